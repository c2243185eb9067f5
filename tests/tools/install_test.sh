#!/usr/bin/env bash
# Installs a finished build into a folder of its own, moves it, and uses it from elsewhere: the
# command with its data and modules, and the CMake package from a program outside the tree.
#
#   tests/tools/install_test.sh BUILD SOURCE VERSION [CMAKE]
set -eu
build="$1"
source="$2"
version="$3"
cmake="${4:-cmake}"

scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

fail() {
  echo "install_test: $*" >&2
  exit 1
}

"$cmake" --install "$build" --prefix "$scratch/first" >"$scratch/install.log"
# Nothing may remember where it was installed to.
mv "$scratch/first" "$scratch/prefix"
prefix="$scratch/prefix"
nadir="$prefix/bin/nadir"
cd /

[ "$("$nadir" --version | grep -c -F "$version")" -eq 1 ] || fail "--version does not say $version"

# Its own data by a path from anywhere.
"$nadir" validate "$prefix/share/nadir/jacksboro/day.xml" || fail "the installed day.xml is invalid"

# Its library is that of the prefix, not of the tree it was built in: a name changed only there shows.
"$nadir" materials >"$scratch/before.txt" || fail "nadir materials failed"
grep -q '^wet_soil ' "$scratch/before.txt" || fail "nadir materials does not list wet_soil"
sed -i 's/name="wet_soil"/name="wet_test_soil"/' "$prefix/share/nadir/library/materials.xml"
"$nadir" materials | grep -q '^wet_test_soil ' || fail "the command does not read its own library"
sed -i 's/name="wet_test_soil"/name="wet_soil"/' "$prefix/share/nadir/library/materials.xml"

modules="$(find "$prefix" -path '*/nadir/*' -name '*.so' | wc -l)"
[ "$modules" -eq 2 ] || fail "found $modules modules, expected 2"

# Public headers only.
leaked="$(grep -rlE '#include <(embree|GeographicLib|tbb|tinyxml2|fmt|nlohmann|Imf|gdal|CLI)' \
  "$prefix/include" || true)"
[ -z "$leaked" ] || fail "installed headers need other libraries: $leaked"

"$cmake" -S "$source/tests/tools/consumer" -B "$scratch/consumer" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$prefix" >"$scratch/configure.log" || fail "find_package(Nadir) failed"
"$cmake" --build "$scratch/consumer" >"$scratch/build.log" 2>&1 ||
  { cat "$scratch/build.log" >&2; fail "the consumer does not build"; }
# Planck's law at 10 um and 300 K; c1, c2 of the SI (2019): 9.9240 W m^-2 sr^-1 um^-1.
"$scratch/consumer/consumer" "$prefix/share/nadir/jacksboro/day.xml" >"$scratch/said.txt" ||
  fail "the consumer does not run"
grep -qx '9.9240' "$scratch/said.txt" || fail "planck: $(cat "$scratch/said.txt")"
echo "install_test: passed"
