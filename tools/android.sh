#!/usr/bin/env bash
# Makes Marrow for Android: out/android/marrow.aar, libraries for Gradle, and newt.apk, the example of platform/android.
# usage: tools/android.sh [--out DIR] [--ndk NDK] [--key KEY.pk8 CERTIFICATE.pem]
#   --out DIR   the folder; out/android without
#   --ndk NDK   build by the NDK in this folder; the environment's ANDROID_NDK does the same. Untried
#   --key …     what signs the APK; without, a key that is made and kept in build/android
# Without an NDK: Debian's clang-19, with headers and libraries that stand in for Android's; see cmake/android.cmake.
# Builds in build/android. Exit code: 3 if a tool cannot be had.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
usage() { sed -n '3,8s/^# \{0,1\}//p' tools/android.sh >&2; exit 1; }
out=out/android ndk=${ANDROID_NDK:-} work=build/android
key=$work/key.pk8 certificate=$work/key.pem
while [ $# -gt 0 ]; do
  case $1 in
    --out) [ $# -ge 2 ] || usage && out=$2 && shift 2 ;;
    --ndk) [ $# -ge 2 ] || usage && ndk=$(realpath -m "$2") && shift 2 ;;
    --key) [ $# -ge 3 ] || usage && key=$2 certificate=$3 && shift 3 ;;
    *) usage ;;
  esac
done
toolchain=$ndk/build/cmake/android.toolchain.cmake
[ -z "$ndk" ] || [ -e "$toolchain" ] || { echo "android: $ndk: no NDK: it has no ${toolchain#"$ndk"/}" >&2; exit 1; }
tools/install.sh tools/packages/build.txt tools/packages/android.txt ||
  { echo "android: some of tools/packages/android.txt cannot be installed" >&2; exit 3; }
marrow=${MARROW_PROGRAM:-build/release/tools/marrow}
mkdir -p $work "$out"

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >$work/log.txt 2>&1 || { cat $work/log.txt >&2; exit 2; }
}
abis="arm64-v8a armeabi-v7a x86_64"
configure() {  # ABI SOURCE BUILD [OPTION ...]
  local abi=$1 source=$2 build=$3 kit
  shift 3
  if [ -n "$ndk" ]; then
    kit=(--toolchain "$toolchain" "-DANDROID_ABI=$abi" -DANDROID_PLATFORM=21 -DANDROID_STL=c++_static
      -DANDROID_SUPPORT_FLEXIBLE_PAGE_SIZES=ON)
  else
    kit=(--toolchain "$PWD/cmake/android.cmake" "-DMARROW_STUBS=$PWD/$work/stubs/$abi")
  fi
  quietly cmake --fresh -G Ninja -S "$source" -B "$build" "${kit[@]}" "-DMARROW_ABI=$abi" -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG -ffunction-sections -fdata-sections" --no-warn-unused-cli "$@"
}
tool() {  # NAME ARGUMENT ...: of the NDK, or Debian's
  local name=$1
  shift
  if [ -n "$ndk" ]; then
    local folders=("$ndk"/toolchains/llvm/prebuilt/*/bin)
    "${folders[0]}/$name" "$@"
  else
    "$name-19" "$@"
  fi
}

build_libraries() {  # ABI
  local abi=$1 libraries=$work/$1/libraries name
  [ -n "$ndk" ] || quietly tools/packaging/android/make_stubs.sh "$abi" "$work/stubs/$abi"
  configure "$abi" . "$work/$abi" -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0
  quietly cmake --build "$work/$abi" --target marrow_c_shared marrow_c_gles3
  mkdir -p "$libraries"
  tool llvm-strip -s "$work/$abi/runtime/c/libmarrow_c.so" -o "$libraries/libmarrow_c.so"
  {
    echo "create $libraries/libmarrow.a"
    for name in runtime unpack gles3/gles3 c/c c/c_gles3; do
      echo "addlib $work/$abi/runtime/${name%"${name##*/}"}libmarrow_${name##*/}.a"
    done
    printf 'save\nend\n'
  } | tool llvm-ar -M
  tool llvm-strip --strip-debug "$libraries/libmarrow.a"
}

build_example() {  # ABI
  configure "$1" platform/android/example "$work/$1/example" "-DMARROW_PREFAB=$PWD/$work/aar/prefab" \
    "-Dmarrow_DIR=$PWD/tests/platform/android"
  quietly cmake --build "$work/$1/example"
  mkdir -p "$work/apk/lib/$1"
  tool llvm-strip -s "$work/$1/example/libnewt.so" -o "$work/apk/lib/$1/libnewt.so"
}

make_aar() {
  rm -rf $work/aar
  python3 tools/packaging/android/make_prefab.py $work $work/aar "${ndk:+$(sed -n 's/^Pkg.Revision *= *\([0-9]*\).*/\1/p' "$ndk/source.properties")}"
  cp platform/android/AndroidManifest.xml $work/aar/
  cp LICENSE $work/aar/LICENSE
  rm -f "$out/marrow.aar"
  (cd $work/aar && find . -type f | LC_ALL=C sort | TZ=UTC zip -q -X -9 -@ - ) >"$out/marrow.aar"
}

make_key() {
  [ -e "$key" ] && return 0
  quietly openssl req -x509 -newkey rsa:2048 -nodes -days 10000 -subj /CN=newt -keyout $work/key.tmp -out "$certificate"
  quietly openssl pkcs8 -topk8 -outform DER -in $work/key.tmp -nocrypt -out "$key"
  rm $work/key.tmp
}

make_apk() {
  mkdir -p $work/apk/assets
  "$marrow" sample -o $work/newt.glb
  quietly "$marrow" cook $work/newt.glb -o $work/apk/assets/newt.mrw --mesh-codec none --clip-codec raw
  # A ramp of light: 64 texels, darker and bluer away from the light.
  python3 -c 'import sys
for i in range(64):
  t = min(max((i / 63 - 0.25) / 0.45, 0), 1)
  t = t * t * (3 - 2 * t)
  sys.stdout.buffer.write(bytes(round(255 * (low + (1 - low) * t)) for low in (0.42, 0.44, 0.56)))' >$work/apk/assets/ramp.rgb
  quietly aapt package -f -0 mrw -M platform/android/example/AndroidManifest.xml -A $work/apk/assets \
    -I /usr/share/android-framework-res/framework-res.apk -F $work/unaligned.apk
  (cd $work/apk && quietly_zip ../unaligned.apk lib)
  python3 platform/android/align_apk.py $work/unaligned.apk $work/aligned.apk 'assets/*.rgb'
  make_key
  quietly apksigner sign --min-sdk-version 21 --key "$key" --cert "$certificate" --out "$out/newt.apk" $work/aligned.apk
  rm -f "$out/newt.apk.idsig"
}
quietly_zip() { zip -q -X -r -0 "$@"; }

[ -x "$marrow" ] || { quietly cmake --preset release && quietly cmake --build --preset release --target marrow; }
rm -rf $work/apk
for abi in $abis; do build_libraries "$abi"; done
make_aar
for abi in $abis; do build_example "$abi"; done
make_apk
ls -l "$out/marrow.aar" "$out/newt.apk"
