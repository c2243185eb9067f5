#!/usr/bin/env bash
# From a fresh checkout to pictures: installs what is missing, builds build/nadir, runs the two
# demo scenarios into out/day and out/night, and prints where the pictures are.
#
#   tools/demo.sh [--force] [--no-setup]
#
# Run again, it rebuilds and renders only what is out of date: a scenario whose pictures are newer
# than the program and everything under scenes/ is left as it is. --force renders it all the same.
# --no-setup installs nothing.
set -eu
# shellcheck source=tools/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

force=no
setup=yes
for option in "$@"; do
  case "$option" in
    --force) force=yes ;;
    --no-setup) setup=no ;;
    *)
      say "usage: tools/demo.sh [--force] [--no-setup]" >&2
      exit 2
      ;;
  esac
done

cd "$root"
run_setup "$setup"

say "== build"
# Configured once; after that the build itself notices changes to the CMake files.
[ -f build/build.ninja ] || cmake --preset release
cmake --build --preset release --target nadir_command

# Whether the pictures of $1 are newer than all that they depend on.
up_to_date() {
  local output="out/$1" stamp="out/.$1.done"
  [ "$force" = no ] && [ -f "$stamp" ] && [ -n "$(find "$output" -name '*.png' 2>/dev/null)" ] &&
    [ -z "$(find scenes build/nadir build/*.so -newer "$stamp" -print -quit)" ]
}

render() {
  local name="$1" start=$SECONDS
  say
  say "== $name"
  if up_to_date "$name"; then
    say "out/$name is newer than the program and its inputs: kept (--force renders it again)"
    return
  fi
  mkdir -p out
  rm -f "out/.$name.done"
  : >"out/.$name.started" # inputs that change during the run count as newer
  build/nadir run "scenes/jacksboro/$name.xml" --output "out/$name"
  mv "out/.$name.started" "out/.$name.done"
  say "$name took $((SECONDS - start)) s"
}

render day
render night

say
say "Pictures:"
find "$root/out/day" "$root/out/night" -name '*.png' | sort | sed 's/^/  /'
say "Done in $SECONDS s."
