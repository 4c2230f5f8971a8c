#!/usr/bin/env bash
# Fetches Debian's packages for AArch64 with all that they need, for programs under qemu-user, and to link those with.
# usage: tools/get_arm64.sh FOLDER LIST [SUITE]      as tools/packages/arm64-gl.txt
# SUITE, as trixie: of that release of Debian instead of the system's own. Then `src:NAME` in the list is a source
# package, whose archives come to FOLDER/source as they are.
# They are unpacked to the folder and not installed: beside the system's own they would have to be of the very same
# version. A second run finds them there and does nothing. Exits with 3 where apt or the network is missing.
set -u
if [ $# -lt 2 ] || [ $# -gt 3 ] || [ ! -r "$2" ]; then
  echo "usage: $0 FOLDER LIST [SUITE]" >&2
  exit 1
fi
list=$2
suite=${3:-}
words() { sed 's/#.*//' "$list" | xargs -n 1; }
mapfile -t packages < <(words | grep -v '^src:')
mapfile -t sources < <(words | sed -n 's/^src://p')
mkdir -p "$1" && folder=$(cd "$1" && pwd) || exit 2
if cmp -s "$list" "$folder/.packages"; then
  exit 0
fi
for tool in apt-get dpkg-deb; do
  if ! command -v "$tool" >/dev/null; then
    echo "get_arm64: $tool is missing, so there are no packages for AArch64" >&2
    exit 3
  fi
done

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"/{state/lists/partial,cache/archives/partial,log,root}
: >"$work/status"
# As on a machine of that kind on which nothing is installed; of the system's apt only the sources.
options=(-o APT::Architecture=arm64 -o APT::Architectures=arm64 -o APT::Install-Recommends=false -o APT::Sandbox::User=
  -o Dir::State="$work/state" -o Dir::State::status="$work/status" -o Dir::Cache="$work/cache" -o Dir::Log="$work/log"
  -o Debug::NoLocking=true)
if [ -n "$suite" ]; then
  # shellcheck disable=SC2016  # apt's own words
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 2>/dev/null | grep -m 1 '/debian/$')
  keys=/usr/share/keyrings/debian-archive-keyring.gpg
  if [ -z "$mirror" ] || [ ! -e "$keys" ]; then
    echo "get_arm64: apt has no mirror of Debian here, so there is no $suite" >&2
    exit 3
  fi
  printf "%s [signed-by=$keys] $mirror $suite main\n" deb deb-src >"$work/sources.list"
  options+=(-o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=/dev/null)
fi
get_sources() {
  [ ${#sources[@]} -gt 0 ] || return 0
  mkdir -p "$work/root/source" && cd "$work/root/source" &&
    apt-get "${options[@]}" -qq source --download-only "${sources[@]}"
}
if ! { apt-get "${options[@]}" -qq update &&
  apt-get "${options[@]}" -qq -y --download-only install "${packages[@]}" && (get_sources); } >"$work/apt.txt" 2>&1; then
  echo "get_arm64: apt cannot fetch ${packages[*]} for arm64" >&2
  tail -n 3 "$work/apt.txt" >&2
  exit 3
fi
set -e
for archive in "$work"/cache/archives/*.deb; do dpkg-deb -x "$archive" "$work/root"; done
rm -rf "$work"/root/usr/share/{doc,man,locale,icons,bug,lintian}
# CMake's files of some packages name libraries by their whole paths.
find "$work"/root/usr/lib -name '*.cmake' -exec sed -i "s|\"/usr\\([/\"]\\)|\"$folder/usr\\1|g" {} +
[ -e "$work/root/lib" ] || ln -s usr/lib "$work/root/lib"  # where newer packages expect it
cp -a "$work/root/." "$folder/"
cp "$list" "$folder/.packages"  # last: what a next run looks for
