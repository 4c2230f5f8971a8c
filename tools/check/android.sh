#!/usr/bin/env bash
# Makes Marrow for Android by tools/android.sh, and tries as much of it as a machine that is no phone can: what the
# libraries say of themselves; the shared ones under qemu, each to the same hash as here; the APK's own library for
# x86-64, with a program that plays Android to it; and APKs that are spoilt, each of which must get its message.
# usage: tools/check/android.sh MARROW      (the program)
# Exit code: 0 good, 1 not, 2 no build, 3 a tool cannot be had here.
set -euo pipefail
MARROW_PROGRAM=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$PWD/build/android/check
export MARROW_PROGRAM MESA_GLES_VERSION_OVERRIDE=3.0
fail() { echo "check/android: $*" >&2; exit 1; }
wanted() { [[ $2 == *"$1"* ]] || fail "said"$'\n'"$2"$'\n'"and not: $1"; }

rm -rf build/android/apk "$work" && mkdir -p "$work"
env -u ANDROID_NDK tools/android.sh --out "$work" >/dev/null
libraries() { echo "build/android/$1/libraries"; }

# What each library imports, its pages, where entries begin, and who signed.
for package in marrow.aar newt.apk; do
  python3 platform/android/check_apk.py "$work/$package" tools/packaging/android/stubs.txt || fail "$package is not good"
done
said=$(apksigner verify --verbose --min-sdk-version 21 "$work/newt.apk") || fail "the signature of newt.apk: $said"
wanted "Verified using v1 scheme (JAR signing): true" "$said"
wanted "Verified using v2 scheme (APK Signature Scheme v2): true" "$said"
said=$(aapt dump badging "$work/newt.apk" 2>&1) || fail "aapt: $said"
wanted "native-code: 'arm64-v8a' 'armeabi-v7a' 'x86_64'" "$said"
wanted "sdkVersion:'21'" "$said"

# The same road through each shared library. GNU's C library answers to the names of Android's.
"$MARROW_PROGRAM" cook tools/sample/newt.glb --mesh-codec none --clip-codec raw -o "$work/newt.mrw" >/dev/null
road() {  # NAME TARGET FOLDER-OF-LIBC RUN LIBRARY … [OPTION …]; RUN is told LD_LIBRARY_PATH=…
  local name=$1 target=$2 libc=$3 run=$4
  shift 4
  mkdir -p "$work/$name"
  ln -sfn "$libc/libc.so.6" "$work/$name/libc.so"
  ln -sfn "$libc/libm.so.6" "$work/$name/libm.so"
  clang-19 "--target=$target" -fuse-ld=lld-19 -std=c99 -Iruntime/include tests/c/road.c -o "$work/$name/road" "$@" \
    -Wl,--unresolved-symbols=ignore-all || fail "tests/c/road.c does not link for $name"
  # shellcheck disable=SC2086  # a command of several words
  $run "LD_LIBRARY_PATH=$(libraries "$name"):$work/$name" "$work/$name/road" "$work/newt.mrw"
}
built=$(dirname "$MARROW_PROGRAM")/../runtime
here=$(road here x86_64-linux-gnu /lib/x86_64-linux-gnu env "$built"/{c/libmarrow_c,libmarrow_unpack,libmarrow_runtime}.a -lm)
compare() {  # ABI TARGET FOLDER-OF-LIBC RUN OPTION …
  local abi=$1 kind said
  for kind in libmarrow_c.so libmarrow.a; do
    said=$(road "$@" "$(libraries "$abi")/$kind" -lm) || fail "$abi: tests/c/road.c with $kind: $said"
    [ "$said" = "$here" ] || fail "$abi, $kind: says"$'\n'"$said"$'\n'"and here"$'\n'"$here"
    echo "$abi, $kind: ${said//$'\n'/, }"
  done
}
compare x86_64 x86_64-linux-gnu /lib/x86_64-linux-gnu env
compare arm64-v8a aarch64-linux-gnu /usr/aarch64-linux-gnu/lib "qemu-aarch64 -L /usr/aarch64-linux-gnu -E"
compare armeabi-v7a arm-linux-gnueabi /usr/arm-linux-gnueabi/lib "qemu-arm -L /usr/arm-linux-gnueabi -E" \
  -march=armv7-a -mfloat-abi=softfp

# The program and the CMake file of the page, by what Gradle would tell CMake of the AAR.
page=docs/platforms/android.md
mkdir -p "$work/page"
block() { awk -v begin="\`\`\`$1" '$0 == begin { on = 1; next } $0 == "```" { on = 0 } on' $page; }
block cmake >"$work/page/CMakeLists.txt"
block cpp >"$work/page/game.cpp"
{
  cmake -G Ninja -S "$work/page" -B "$work/page/build" --toolchain "$PWD/cmake/android.cmake" -DMARROW_ABI=arm64-v8a \
    "-DMARROW_STUBS=$PWD/build/android/stubs/arm64-v8a" "-DMARROW_PREFAB=$PWD/build/android/aar/prefab" \
    "-Dmarrow_DIR=$PWD/tests/platform/android" -DCMAKE_BUILD_TYPE=Release
  cmake --build "$work/page/build"
} >"$work/page/log.txt" 2>&1 || fail "$page: $(tail -20 "$work/page/log.txt")"
[ -e "$work/page/build/libgame.so" ] || fail "$page: there is no libgame.so"

# The app's life, on the APK's own library.
"${CXX:-c++}" -std=c++20 -O1 -Wall -Wextra -Werror -Itests/platform/android/headers tests/platform/android/*.cpp -o "$work/play" \
  -rdynamic -Wl,--no-as-needed -lGLESv2 -lz -ldl
play() {  # APK STORY
  unzip -q -o "$1" lib/x86_64/libnewt.so -d "$work/apk"
  LD_LIBRARY_PATH=$PWD/build/android/stubs/x86_64 "$work/play" "$work/apk/lib/x86_64/libnewt.so" "$1" "$2" "$work/$2.ppm" 2>&1
}
for story in life lost killed never; do
  said=$(play "$work/newt.apk" $story) || fail "$story: $said"
  echo "${said##*$'\n'}"
  wanted "used in place" "$said"
done
wanted "no context after 20 tries" "$said"

# APKs that are spoilt: what the app says of each, and what check_apk.py does.
spoil() {  # STORY: to $work/STORY.apk
  python3 tests/platform/android/spoil_apk.py "$1" "$work/newt.apk" "$work/$1.apk"
}
app_says() {  # STORY TEXT
  spoil "$1"
  said=$(play "$work/$1.apk" open) || fail "$1: $said"
  wanted "$2" "$said"
}
checker_says() {  # STORY TEXT
  spoil "$1"
  said=$(python3 platform/android/check_apk.py "$work/$1.apk" tools/packaging/android/stubs.txt 2>&1) && fail "check_apk.py takes $1.apk"
  wanted "$2" "$said"
}
app_says compressed-asset "newt.mrw: 516100 bytes, copied, as it begins on no multiple of 16 in the APK: it is compressed there, see noCompress"
app_says unaligned-asset "copied, as it begins on no multiple of 16 in the APK: see align_apk.py"
app_says no-asset "newt.mrw: not among the APK's assets; put it into src/main/assets and build again"
app_says damaged-asset "newt.mrw: byte "
app_says cut-asset "newt.mrw: byte "
app_says empty-asset "newt.mrw: Android cannot read it"
app_says no-texture "ramp.rgb: not among the APK's assets"
wanted "ramp.rgb: drawn without" "$said"
app_says cut-texture "ramp.rgb: has 100 bytes and not 192"
checker_says compressed-asset 'assets/newt.mrw: is compressed, so it is copied each time; set androidResources { noCompress += "mrw" }'
checker_says unaligned-asset "assets/newt.mrw: begins 4 bytes behind a multiple of 16; run align_apk.py"
checker_says other-abi "lib/arm64-v8a/libnewt.so: is for x86_64; put one for arm64-v8a there"
checker_says small-pages "lib/arm64-v8a/libnewt.so: does not fit pages of 16 KB; link it with -Wl,-z,max-page-size=16384"
checker_says unaligned-library "lib/arm64-v8a/libnewt.so: begins 4 bytes behind a multiple of 16384; run align_apk.py"
checker_says compressed-library "lib/arm64-v8a/libnewt.so: is compressed"
checker_says new-import "lib/x86_64/libnewt.so: imports timerfd_invent, which Android 21 may not export"
checker_says cut-library "lib/arm64-v8a/libnewt.so: is damaged"
checker_says no-library "lib/arm64-v8a/libnewt.so: is no library of Android's"
# Whatever lies before them, align_apk.py finds cooked files their places.
for size in 1 2 3 5 6 7 9 10; do head -c $size "$work/newt.mrw" >"$work/$size.mrw"; done
(cd "$work" && rm -f many.apk && zip -q many.apk ./{1,2,3,5,6,7,9,10}.mrw)
python3 platform/android/align_apk.py "$work/many.apk" "$work/aligned.apk"
python3 platform/android/check_apk.py "$work/aligned.apk" || fail "align_apk.py does not find cooked files their places"
said=$(python3 platform/android/check_apk.py "$work/newt.mrw" 2>&1) && fail "check_apk.py takes a file that is no APK"
wanted "File is not a zip file" "$said"
echo "check/android: good"
