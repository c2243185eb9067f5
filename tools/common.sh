# Sourced by the scripts of this folder: where the tree is, and which tools come first.

# Debian's own programs before a pyenv, conda or pip copy of the same name: those may be older,
# broken, or lead CMake to libraries of their own.
PATH="/usr/bin:/bin:$PATH"
export PATH

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
jobs="$(nproc 2>/dev/null || echo 2)"

say() { printf '%s\n' "$*"; }
fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# Installs what is missing; a bare `no` as the first argument leaves the machine alone.
run_setup() {
  local wanted="$1"
  shift
  [ "$wanted" = no ] || "$root/tools/setup.sh" "$@"
}
