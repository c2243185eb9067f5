#!/usr/bin/env bash
# Everything that must hold before a change goes in; needs no other step on a fresh machine.
#
#   tools/check.sh [--fast | --all | --threads] [--no-setup]
#
# Format, include directions, names, build with warnings as errors, all tests, the tests again under
# the address and undefined-behaviour sanitizers, some seconds of the fuzzers of readers. --fast leaves
# sanitizers and fuzzers out; --all adds the long tests, the thread sanitizer and clang-tidy over
# every source, which takes longer than all the rest: run it before a release. --threads does the
# thread sanitizer's part and nothing else.
# Works in build-check/, build-sanitize/ and build-threads/, never in build/. Every step runs even
# where an earlier one failed; the exit status is 0 only if all passed. Run again, it builds, tests
# and lints only what changed, except that the tests of the release build always run.
set -u
# shellcheck source=tools/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

fast=no
all=no
threads_alone=no
setup=yes
for option in "$@"; do
  case "$option" in
    --fast) fast=yes ;;
    --all) all=yes ;;
    --threads) threads_alone=yes ;;
    --no-setup) setup=no ;;
    *)
      say "usage: tools/check.sh [--fast | --all | --threads] [--no-setup]" >&2
      exit 2
      ;;
  esac
done

cd "$root" || exit 1
run_setup "$setup" --checks || exit
logs="build-check/logs"
mkdir -p "$logs"
results=()
failed=()

# step NAME COMMAND...: runs the command, keeps its output, notes time and outcome.
step() {
  local name="$1" start=$SECONDS outcome=passed
  shift
  say
  say "== $name"
  set -o pipefail
  if ! "$@" 2>&1 | tee "$logs/$name.log"; then
    outcome=FAILED
    failed+=("$name")
  fi
  results+=("$(printf '  %-10s %-7s %4d s' "$name" "$outcome" $((SECONDS - start)))")
  [ "$outcome" = passed ]
}

sources() {
  find . \( -path './build*' -o -path ./out -o -path ./.git \) -prune -o \
    -type f \( "$@" \) -print0
}

check_format() {
  sources -name '*.cpp' -o -name '*.hpp' |
    xargs -0 -r clang-format-14 --dry-run --Werror && say "every file is formatted"
}

check_scripts() {
  sources -name '*.sh' | xargs -0 -r -n 1 bash -n &&
    bash -n .ci/run &&
    sources -name '*.py' | xargs -0 -r python3 -c '
import ast, sys
for name in sys.argv[1:]:
    with open(name, encoding="utf-8") as file:
        ast.parse(file.read(), name)
' && say "every script parses"
}

# build FOLDER OPTIONS...: configures on the first run and after other options; ninja notices later
# changes by itself.
build() {
  local folder="$1"
  shift
  if [ ! -f "$folder/build.ninja" ] || [ "$(cat "$folder/.options" 2>/dev/null)" != "$*" ]; then
    cmake -S . -B "$folder" -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" || return
    printf '%s' "$*" >"$folder/.options"
  fi
  # -k 0: all errors at once, and as much of the rest as there is to test
  cmake --build "$folder" -- -k 0
}

tests() { # tests FOLDER OPTIONS...
  local folder="$1"
  shift
  ctest --test-dir "$folder" -j "$jobs" --output-on-failure --no-tests=error "$@" |
    grep -a -v -E '^ *(Start|[0-9]+/[0-9]+ Test .* Passed) '
}

# Comparisons with published figures or of one solver with the other that trace or integrate for
# seconds: under the sanitizers they take a third of the time and run no line that other tests do not.
figures='published:|LOWTRAN7|RRTMG|line-by-line|1e7 rays|lamp look alike to both solvers'
figures+='|the same bowl is short by|a rendered edge has about|the XML schema takes as well'

# The same tests under the sanitizers, but for those that take long there; not again while nothing
# that they depend on has changed.
sanitized_tests() {
  local stamp="build-sanitize/.passed"
  if [ -f "$stamp" ] && [ -z "$(newer_than "$stamp")" ]; then
    say "nothing changed since these tests passed"
    return
  fi
  rm -f "$stamp"
  : >"build-sanitize/.started"
  # The leak check dies on the thread-local storage of some library that OpenImageIO brings along,
  # unless the sanitizer leaves that storage alone.
  ASAN_OPTIONS="intercept_tls_get_addr=0" UBSAN_OPTIONS="print_stacktrace=1" \
    tests build-sanitize -LE 'install|slow|long|end_to_end' -E "$figures" &&
    mv "build-sanitize/.started" "$stamp"
}

# A program, test or data file that is newer than the file $1.
newer_than() {
  find build-sanitize/nadir build-sanitize/*.so build-sanitize/tests scenes tests \
    -type f ! -name '*.log' ! -path '*/Testing/*' -newer "$1" -print -quit 2>/dev/null
}

# What runs on several threads, under the thread sanitizer; oneTBB's loops run on std::threads there,
# which it understands (cmake/tsan/README.md).
threaded='thread|tiles|heat_ahead|solve ahead|journal|killed|bit by bit|same bytes|air cache'
threaded_tests() {
  build build-threads -DCMAKE_CXX_COMPILER=clang++-14 -DNADIR_SANITIZE_THREAD=ON -DNADIR_UNITY=ON \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" || return
  TSAN_OPTIONS="halt_on_error=1 second_deadlock_stack=1" \
    tests build-threads -R "$threaded" -LE 'install|slow|long|end_to_end'
}

# Without a name, tidy.py lints every source of the build.
lint() {
  python3 tools/tidy.py --build build-check --jobs "$jobs"
}

if [ "$threads_alone" = yes ]; then
  if step threads threaded_tests; then exit 0; fi
  exit 1
fi
step format check_format
step includes python3 tools/check_includes.py
step names python3 tools/check_names.py
step scripts check_scripts
# Several sources at a time, which takes half the time; that each source stands by itself shows the
# plain build that everybody works with, demo.sh's as well.
step build build build-check -DNADIR_UNITY=ON -DCMAKE_BUILD_TYPE=Release -DNADIR_WERROR=ON
step test tests build-check -LE long
if [ "$fast" = no ]; then
  # By clang: every change is seen by both compilers, and it takes half of g++'s time.
  step sanitize build build-sanitize -DCMAKE_CXX_COMPILER=clang++-14 \
    -DNADIR_SANITIZE=ON -DNADIR_FUZZ=ON -DNADIR_UNITY=ON -DNADIR_WERROR=ON \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" # lines in reports; -O0 compiles faster, runs slower
  step santest sanitized_tests
  # Longer by hand after a change to a reader: tools/fuzz.sh build-sanitize 300
  step fuzz tools/fuzz.sh build-sanitize 3
fi
if [ "$all" = yes ]; then
  step long tests build-check -L long
  step threads threaded_tests
  step tidy lint
fi

say
say "== summary ($SECONDS s; logs in $logs)"
printf '%s\n' "${results[@]}"
grep -a -h 'tests passed' "$logs/test.log" # of the release build
if [ "${#failed[@]}" -gt 0 ]; then
  say "check FAILED: ${failed[*]}"
  exit 1
fi
say "check passed"
