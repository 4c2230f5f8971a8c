#!/usr/bin/env bash
# Puts the Unity package together: sources and their .meta files, the C# declarations, and native libraries, which are
# built for this machine, and taken from folders for others. See docs/platforms/unity.md.
# usage: tools/unity.sh [--out DIR] [--no-host] [--android ABI=DIR] … [--ios DIR] [--windows DIR] [--macos DIR]
#   --out DIR           the package's folder; the default is out/com.marrow.animation. It is made anew
#   --no-host           builds nothing
#   --android ABI=DIR   ABI: arm64-v8a, armeabi-v7a or x86_64. DIR has libmarrow_c.so and libmarrow_unity.so
#   --ios, --windows, --macos DIR   DIR has *.a, marrow_c.dll, libmarrow_c.dylib
# DIR is the folder `plugins` of a build of platform/unity/native.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out="$here/out/com.marrow.animation"
host=yes
given=()
usage() { sed -n 's/^# usage: //p' "$0" >&2; exit 2; }
die() { echo "unity: $*" >&2; exit 1; }

while [ $# -gt 0 ]; do
  option=$1
  case $option in
    --no-host) host=no; shift; continue ;;
    --out|--android|--ios|--windows|--macos) [ $# -ge 2 ] || usage ;;
    *) usage ;;
  esac
  case $option in
    --out) out=$2 ;;
    --android)
      case $2 in
        arm64-v8a=*|armeabi-v7a=*|x86_64=*) given+=("Android/${2%%=*}|${2#*=}|lib*.so") ;;
        *) die "--android $2: give arm64-v8a=DIR, armeabi-v7a=DIR or x86_64=DIR" ;;
      esac ;;
    --ios) given+=("iOS|$2|lib*.a") ;;
    --windows) given+=("Windows/x86_64|$2|*.dll") ;;
    --macos) given+=("macOS|$2|lib*.dylib") ;;
  esac
  shift 2
done
if [ -e "$out" ] && [ -n "$(ls -A "$out")" ] && [ ! -e "$out/package.json" ]; then
  die "$out: is there and no package: give another folder"
fi

if [ $host = yes ]; then
  build="$here/build/unity/native"
  generator=()
  if command -v ninja >/dev/null; then generator=(-G Ninja); fi
  log=$(mktemp)
  { cmake -S "$here/platform/unity/native" -B "$build" ${generator[@]+"${generator[@]}"} -DCMAKE_BUILD_TYPE=Release &&
    cmake --build "$build" --target plugins; } >"$log" 2>&1 || { tail -30 "$log" >&2; die "no library"; }
  rm "$log"
  case $(uname -sm) in
    "Linux x86_64") given+=("Linux/x86_64|$build/plugins|lib*.so") ;;
    Darwin*) given+=("macOS|$build/plugins|lib*.dylib") ;;
    *) die "$(uname -sm): Unity has no Editor here: give --no-host" ;;
  esac
fi
for one in "${given[@]}"; do
  IFS='|' read -r _ folder _ <<<"$one"
  compgen -G "$folder/*marrow_c.*" >/dev/null || die "$folder: has no marrow_c: build platform/unity/native there"
done

rm -rf "$out"
mkdir -p "$out"
for part in package.json README.md CHANGELOG.md Runtime Editor 'Samples~'; do
  cp -R "$here/platform/unity/$part" "$out"
  if [ -e "$here/platform/unity/$part.meta" ]; then cp "$here/platform/unity/$part.meta" "$out"; fi
done
bindings=$(mktemp -d)
python3 "$here/tools/c_api" --bindings "$bindings"
cp "$bindings/Marrow.cs" "$out/Runtime/Core"
rm -r "$bindings"
cp "$here/LICENSE" "$out/LICENSE.md"
cp "$here/THIRD_PARTY.md" "$out/Third Party Notices.md"
for one in "${given[@]}"; do
  IFS='|' read -r name folder files <<<"$one"
  mkdir -p "$out/Plugins/$name"
  find "$folder" -maxdepth 1 -type f -name "$files" -exec cp {} "$out/Plugins/$name" \;
done
python3 "$here/tools/unity/metas.py" write "$out"
python3 "$here/tools/unity/metas.py" check "$out" >/dev/null

# A library that needs others of this machine works on this machine alone.
library="$out/Plugins/Linux/x86_64/libmarrow_c.so"
if [ -e "$library" ] && command -v readelf >/dev/null; then
  needs=$(readelf -d "$library" | sed -n 's/.*library: \[\(lib\(draco\|meshoptimizer\)[^]]*\)\]/\1/p' | paste -sd ' ')
  [ -z "$needs" ] ||
    echo "unity: Linux/x86_64: needs $needs of this machine; a game that is shipped takes a build with" \
      "-DFETCHCONTENT_TRY_FIND_PACKAGE_MODE=NEVER" >&2
fi
(cd "$out" && find . -path './Plugins/*' -type f ! -name '*.meta' -exec wc -c {} \; | sort -k2)
echo "$out"
