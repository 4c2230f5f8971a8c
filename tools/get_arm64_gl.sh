#!/usr/bin/env bash
# Fetches Mesa for AArch64 with all that it needs, for tests under qemu-user: tools/get_arm64_gl.sh FOLDER.
# The packages are Debian's, unpacked to the folder and not installed: beside the system's own Mesa they would have to be of the very
# same version. A second run finds them there and does nothing. Exits with 3 where apt or the network is missing.
set -u
packages=(libegl1 libegl-mesa0 libgl1-mesa-dri libgles2 libstdc++6)
if [ $# -ne 1 ]; then
  echo "usage: $0 FOLDER" >&2
  exit 1
fi
mkdir -p "$1" && folder=$(cd "$1" && pwd) || exit 2
if [ -e "$folder/lib/ld-linux-aarch64.so.1" ]; then
  exit 0
fi
for tool in apt-get dpkg-deb; do
  if ! command -v "$tool" >/dev/null; then
    echo "get_arm64_gl: $tool is missing, so there is no OpenGL ES for AArch64" >&2
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
if ! { apt-get "${options[@]}" -qq update &&
  apt-get "${options[@]}" -qq -y --download-only install "${packages[@]}"; } >"$work/apt.txt" 2>&1; then
  echo "get_arm64_gl: apt cannot fetch ${packages[*]} for arm64, so there is no OpenGL ES for AArch64" >&2
  tail -n 3 "$work/apt.txt" >&2
  exit 3
fi
set -e
for archive in "$work"/cache/archives/*.deb; do dpkg-deb -x "$archive" "$work/root"; done
# Last what a next run looks for.
loader="$work/root/lib/ld-linux-aarch64.so.1"
cp -P "$loader" "$work/loader"
rm "$loader"
rm -rf "$work"/root/usr/share/{doc,man,locale,icons,bug,lintian}
cp -a "$work/root/." "$folder/"
cp -P "$work/loader" "$folder/lib/ld-linux-aarch64.so.1"
