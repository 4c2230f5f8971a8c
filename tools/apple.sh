#!/usr/bin/env bash
# Makes a package for Swift and Xcode: Marrow.xcframework, with static libraries of the C interface, the runtime, unpack
# and skinning by OpenGL ES, and Package.swift beside it. See docs/platforms/ios.md.
# On a Mac by Xcode's tools; elsewhere by Debian's Clang, which tools/packages/apple.txt installs.
# usage: tools/apple.sh [--out DIR] [--macos] [-- ARGUMENT ...]
#   --out DIR   where the package goes, instead of out/apple
#   --macos     a slice for macOS, too
#   ARGUMENT    for CMake, as -DMARROW_MESHOPT=ON or -DMARROW_CALL_ERRORS=OFF
# Builds below build/apple. Exit code: 0 made, 1 a wrong call, 2 no build, 3 a tool cannot be had.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$here/out/apple
work=$here/build/apple
slices="ios-arm64 ios-arm64_x86_64-simulator"
ios=14.0
macos=11.0
while [ $# -gt 0 ]; do
  case $1 in
    --out) [ $# -gt 1 ] || { echo "apple: --out needs a folder" >&2; exit 1; }; out=$2; shift 2 ;;
    --macos) slices="$slices macos-arm64_x86_64"; shift ;;
    --) shift; break ;;
    --help | -h) sed -n '2,10s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) echo "apple: $1: no such option; --help lists them" >&2; exit 1 ;;
  esac
done
arguments=("$@")

if [ "$(uname -s)" = Darwin ]; then
  on_a_mac=yes
  libtool=(xcrun libtool) lipo=(xcrun lipo)
  tools="cmake ninja python3 xcrun"
else
  on_a_mac=no
  libtool=(llvm-libtool-darwin-19) lipo=(llvm-lipo-19)
  tools="cmake ninja python3 clang++-19 llvm-ar-19 llvm-libtool-darwin-19 llvm-lipo-19"
  "$here/tools/install.sh" "$here/tools/packages/apple.txt" || true
fi
for tool in $tools; do
  command -v "$tool" >/dev/null || { echo "apple: SKIPPED: there is no $tool" >&2; exit 3; }
done

architectures() { sed -E 's/^[a-z]+-//; s/-simulator$//; s/x86_64/X/; s/_/ /g; s/X/x86_64/' <<<"$1"; }

for_cmake() {  # SLICE ARCHITECTURE
  local system=ios$ios sdk=iphoneos minimum=$ios
  case $1 in
    *-simulator) sdk=iphonesimulator ;;
    macos-*) system=macos$macos sdk=macosx minimum=$macos ;;
  esac
  if [ $on_a_mac = yes ]; then
    [ $sdk = macosx ] || echo "-DCMAKE_SYSTEM_NAME=iOS"
    printf '%s\n' "-DCMAKE_OSX_SYSROOT=$sdk" "-DCMAKE_OSX_ARCHITECTURES=$2" "-DCMAKE_OSX_DEPLOYMENT_TARGET=$minimum"
  else
    [ $sdk != iphonesimulator ] || system=$system-simulator
    printf '%s\n' --toolchain "$here/cmake/apple.cmake" "-DMARROW_TARGET=$2-apple-$system"
  fi
}

# A library for one processor: everything that was built, merged. Codecs come with the libraries that they need.
build() {  # SLICE ARCHITECTURE
  local folder=$work/$1/$2 targets="marrow_c_gles3" argument line all=()
  for argument in ${arguments[@]+"${arguments[@]}"}; do
    case $argument in
      -DMARROW_DRACO=ON) targets="$targets marrow_draco" ;;
      -DMARROW_MESHOPT=ON) targets="$targets marrow_meshopt" ;;
    esac
  done
  while IFS= read -r line; do all+=("$line"); done < <(for_cmake "$1" "$2")
  rm -rf "$folder"
  # shellcheck disable=SC2086
  cmake -G Ninja -S "$here" -B "$folder" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_INSTALL=OFF \
    -DMARROW_WERROR=OFF -DCMAKE_DISABLE_FIND_PACKAGE_draco=ON -DCMAKE_DISABLE_FIND_PACKAGE_meshoptimizer=ON \
    --no-warn-unused-cli "${all[@]}" ${arguments[@]+"${arguments[@]}"} &&
    cmake --build "$folder" --target $targets &&
    find "$folder" -name '*.a' -print0 | sort -z | xargs -0 "${libtool[@]}" -static -o "$folder/libMarrow.a"
}

# As many at a time as there are processors. The shell of a Mac is old: it has no mapfile and no wait -n.
mkdir -p "$work"
for slice in $slices; do
  for architecture in $(architectures "$slice"); do
    while [ "$(jobs -rp | wc -l)" -ge "$(getconf _NPROCESSORS_ONLN)" ]; do sleep 0.1; done
    log=$work/$slice-$architecture
    (code=0; build "$slice" "$architecture" >"$log.log" 2>&1 || code=$?; echo $code >"$log.code") &
  done
done
wait
libraries=()
for slice in $slices; do
  parts=()
  for architecture in $(architectures "$slice"); do
    log=$work/$slice-$architecture
    if [ "$(cat "$log.code")" != 0 ]; then
      tail -30 "$log.log" >&2
      echo "apple: $slice, $architecture: no build, see $log.log" >&2
      exit 2
    fi
    parts+=("$work/$slice/$architecture/libMarrow.a")
  done
  "${lipo[@]}" -create "${parts[@]}" -output "$work/$slice/libMarrow.a"
  libraries+=("$slice=$work/$slice/libMarrow.a")
done
python3 "$here/tools/packaging/apple/package.py" "$here" "$out" "${libraries[@]}"
