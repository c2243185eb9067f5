#!/usr/bin/env bash
# Searches for bytes that upset a reader: every target of tests/fuzz for some seconds, from the kept
# corpus.
#
#   tools/fuzz.sh BUILD [SECONDS] [TARGET...]
#
# BUILD was configured with clang, -DNADIR_SANITIZE=ON -DNADIR_FUZZ=ON. What upset a reader is left in
# BUILD/fuzz/: mend the reader, and put the file into tests/fuzz/corpus/TARGET. What reached new lines is
# left in BUILD/fuzz/TARGET.
set -u
# shellcheck source=tools/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build="$1"
seconds="${2:-5}"
shift $(($# < 2 ? $# : 2))
targets=("$@")
[ "${#targets[@]}" -gt 0 ] || targets=(scenario spectrum mesh raster weather time orbit table)
fuzzer="$(cd "$build" && pwd)/tests/fuzz_readers"
mkdir -p "$build/fuzz"

# fuzz TARGET: silent but for what went wrong.
fuzz() {
  local target="$1" log="$build/fuzz/$1.log"
  mkdir -p "$build/fuzz/$target"
  # GDAL and PROJ keep what they read once: that is no leak.
  if ASAN_OPTIONS="detect_leaks=0:allocator_may_return_null=1" "$fuzzer" "$target" \
    -max_total_time="$seconds" -max_len=16384 -rss_limit_mb=4000 -timeout=20 -print_final_stats=1 \
    -artifact_prefix="$build/fuzz/$target-" "$build/fuzz/$target" "$root/tests/fuzz/corpus/$target" \
    >"$log" 2>&1; then
    say "fuzz $target: $(grep -a 'number_of_executed_units' "$log" | tr -dc '0-9') inputs in $seconds s, nothing found"
  else
    tail -n 40 "$log"
    say "fuzz $target: FAILED, log in $log"
    return 1
  fi
}

failed=0
for target in "${targets[@]}"; do
  fuzz "$target" &
  # two at a time
  [ "$(jobs -rp | wc -l)" -lt 2 ] || wait -n || failed=1
done
while [ "$(jobs -rp | wc -l)" -gt 0 ]; do wait -n || failed=1; done
exit "$failed"
