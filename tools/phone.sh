#!/usr/bin/env bash
# Makes a folder to push to a phone or a board, which measures Marrow there: the same bits?, which skinning paths work, how
# fast is what. See docs/performance.md, "On a real phone".
# usage: tools/phone.sh [--out DIR] [--ndk NDK]
#   --out DIR    the folder; out/phone without. What is there of an older kit is replaced
#   --ndk NDK    for Android, by the NDK in this folder; the environment's ANDROID_NDK does the same. Untried
# Without an NDK the programs are for GNU/Linux on ARM: boards and Linux phones with glibc, not Android.
# Builds in build/phone and, for what the kit carries, by the preset release, if MARROW_PROGRAM names no program there.
set -euo pipefail
usage() { sed -n '4,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 1; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$here/out/phone
ndk=${ANDROID_NDK:-}
while [ $# -gt 0 ]; do
  [ $# -ge 2 ] || usage
  case $1 in
    --out) out=$(realpath -m "$2") ;;
    --ndk) ndk=$(realpath -m "$2") ;;
    *) usage ;;
  esac
  shift 2
done
cd "$here"
toolchain=$ndk/build/cmake/android.toolchain.cmake
if [ -n "$ndk" ] && [ ! -e "$toolchain" ]; then
  echo "phone: $ndk: no Android NDK: it has no build/cmake/android.toolchain.cmake" >&2
  exit 1
fi
tools/install.sh tools/packages/build.txt
[ -n "$ndk" ] || tools/install.sh tools/packages/phone.txt
mkdir -p build/phone

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >build/phone/log.txt 2>&1 || { cat build/phone/log.txt >&2; exit 2; }
}
arguments() {  # arm64 or armv7
  case "${ndk:+android-}$1" in
    arm64) echo "-DCMAKE_TOOLCHAIN_FILE=$here/cmake/aarch64.cmake" ;;
    armv7) echo "-DCMAKE_TOOLCHAIN_FILE=$here/cmake/armhf.cmake" ;;
    android-arm64) echo "-DCMAKE_TOOLCHAIN_FILE=$toolchain -DANDROID_ABI=arm64-v8a" ;;
    android-armv7) echo "-DCMAKE_TOOLCHAIN_FILE=$toolchain -DANDROID_ABI=armeabi-v7a" ;;
  esac
}
linking="-static-libstdc++ -static-libgcc" kind="GNU/Linux with glibc; for Android give --ndk"
if [ -n "$ndk" ]; then linking="" kind="Android 8 and newer, untried"; fi

marrow=${MARROW_PROGRAM:-build/release/tools/marrow}
[ -n "${MARROW_PROGRAM:-}" ] || { quietly cmake --preset release && quietly cmake --build --preset release --target marrow marrow_bits; }
kit=build/phone/kit
rm -rf $kit && mkdir -p $kit
for abi in arm64 armv7; do
  # shellcheck disable=SC2046  # several words
  quietly cmake -G Ninja -S . -B "build/phone/${ndk:+android-}$abi" -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_CXX_FLAGS_RELEASE=-O3 -DNDEBUG" -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_BITS=ON -DMARROW_PHONE=ON \
    "-DCMAKE_EXE_LINKER_FLAGS=$linking" -DANDROID_PLATFORM=26 -DANDROID_STL=c++_static --no-warn-unused-cli \
    $(arguments $abi)
  quietly cmake --build "build/phone/${ndk:+android-}$abi" --target marrow_phone marrow_bits
  mkdir $kit/$abi
  cp "build/phone/${ndk:+android-}$abi"/{tools/phone/marrow_phone,tests/bits/marrow_bits} $kit/$abi/
done

"$marrow" sample -o $kit/newt.glb
quietly "$marrow" cook $kit/newt.glb -o $kit/newt.mrw --mesh-codec none
rm $kit/newt.glb
# What the bits are here, and which Marrow this is.
"$(dirname "$marrow")/../tests/bits/marrow_bits" >build/phone/bits.txt ||
  { echo "phone: the bits differ on this machine: see build/phone/bits.txt" >&2; exit 1; }
sed -n 's/^bits \([0-9A-F]*\)$/\1/p' build/phone/bits.txt >$kit/kit.txt
git describe --always --dirty 2>/dev/null >>$kit/kit.txt || echo unknown >>$kit/kit.txt
cp tools/phone/run.sh $kit/

mkdir -p "$out"
rm -rf "$out"/{arm64,armv7,newt.mrw,kit.txt,run.sh}
cp -R $kit/. "$out/"
echo "$out: for $kind" >&2
if [ -n "$ndk" ]; then
  there=/data/local/tmp/marrow
  echo "adb push $out/. $there && adb shell sh $there/run.sh && adb pull $there/result.json"
else
  echo "tar -C $out -c . | ssh DEVICE 'mkdir -p marrow-kit && tar -C marrow-kit -x && sh marrow-kit/run.sh' &&" \
    "scp DEVICE:marrow-kit/result.json ."
fi
