#!/usr/bin/env bash
# Installs the packages that Nadir is built from, where they are missing. Safe to run again.
#
#   tools/setup.sh            what building and running needs
#   tools/setup.sh --checks   also what tools/check.sh needs
#   tools/setup.sh --list     prints the packages and installs nothing
#
# Exit status: 0 everything is there; 2 wrong option; 69 not a system this script installs on, so
# it printed what to install; 77 neither root nor sudo; otherwise the package manager's.
set -eu
# shellcheck source=tools/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

packages=(
  build-essential cmake ninja-build pkg-config ccache git
  libembree-dev       # rays
  libgeographiclib-dev liberfa-dev                  # earth; sun and moon
  libeigen3-dev libtbb-dev libtinyxml2-dev libcli11-dev libfmt-dev nlohmann-json3-dev libssl-dev zlib1g-dev
  libopenexr-dev libimath-dev libopenimageio-dev libgdal-dev   # images and rasters
  openimageio-tools   # Debian's CMake package of OpenImageIO is not found without its programs
  catch2
)
check_packages=(
  clang-14 libclang-rt-14-dev clang-format-14 clang-tidy-14 python3 python3-numpy libxml2-utils gdal-bin libbenchmark-dev
  chromium            # opens the pages of studies
)

list_only=no
for option in "$@"; do
  case "$option" in
    --checks) packages+=("${check_packages[@]}") ;;
    --list) list_only=yes ;;
    *)
      say "usage: tools/setup.sh [--checks] [--list]" >&2
      exit 2
      ;;
  esac
done
if [ "$list_only" = yes ]; then
  printf '%s\n' "${packages[@]}"
  exit 0
fi

# One query for all of them: about 20 ms where nothing is missing.
missing=("${packages[@]}")
if command -v dpkg-query >/dev/null; then
  installed="$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null |
    sed -n 's/^installed //p' || true)"
  missing=()
  for package in "${packages[@]}"; do
    case $'\n'"$installed"$'\n' in
      *$'\n'"$package"$'\n'*) ;;
      *) missing+=("$package") ;;
    esac
  done
fi
[ "${#missing[@]}" -gt 0 ] || exit 0

system="$(. /etc/os-release 2>/dev/null && echo "${ID:-unknown} ${VERSION_ID:-}" || echo unknown)"
if [ "$system" != "debian 12" ] || ! command -v apt-get >/dev/null; then
  say "This script installs packages on Debian 12 only; this system is: $system"
  say "Please install what these Debian packages hold, then run again with --no-setup:"
  printf '  %s\n' "${missing[@]}"
  say "Needed: g++ 12 or clang 14 and newer, CMake 3.25, Embree 3.13 (or 4, with -DNADIR_EMBREE=4)."
  exit 69
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    say "Not root, and there is no sudo. As root, please run:"
    say "  apt-get install --no-install-recommends ${missing[*]}"
    exit 77
  fi
  as_root=(sudo)
fi
apt_get() {
  ${as_root[@]+"${as_root[@]}"} env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@"
}

say "Installing: ${missing[*]}"
# A third party's repository that does not answer must not stop us: the install itself will tell.
apt_get update || say "apt-get update reported an error; trying with the lists at hand"
apt_get install --no-install-recommends "${missing[@]}"
