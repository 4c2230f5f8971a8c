#!/usr/bin/env bash
# Says whether poses are the same bits by every compiler, on every processor and system that can be had here.
# Builds marrow_bits in build/bits, runs it where it is for, under qemu, Wine or node, and prints a line for each.
# usage: tools/same_bits.sh [VARIANT ...]   of the names in variants below; all without arguments
# Exit code: 0 the same, 1 not, 2 no build, 3 what ran is the same, but a variant cannot be had here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
here=$PWD
variants="x86-64 scalar small one-file clang i686 aarch64 armhf windows wasm32 wasm32-simd"
# shellcheck disable=SC2086  # several words
[ $# -gt 0 ] || set -- $variants
for name in "$@"; do
  [[ " $variants " == *" $name "* ]] || { sed -n '4s/^# //p' "$0" >&2; exit 1; }
done

tools/install.sh tools/packages/build.txt tools/packages/bits.txt || echo "same_bits: some packages cannot be installed" >&2
mkdir -p build/bits

# What cmake is told of a variant.
arguments() {
  case $1 in
    scalar) echo "-DMARROW_SIMD=scalar" ;;
    small) echo "-DCMAKE_BUILD_TYPE=MinSizeRel" ;;
    clang) echo "-DCMAKE_CXX_COMPILER=clang++-19" ;;
    i686 | aarch64 | armhf) echo "--toolchain cmake/$1.cmake" ;;
    windows) echo "--toolchain cmake/mingw64.cmake" ;;
    wasm32) echo "--toolchain cmake/wasm32.cmake" ;;
    wasm32-simd) echo "--toolchain cmake/wasm32.cmake -DMARROW_WASM_SIMD=ON" ;;
  esac
}

# The programs that a variant needs.
needs() {
  case $1 in
    clang) echo clang++-19 ;;
    i686) echo i686-linux-gnu-g++ qemu-i386 ;;
    aarch64) echo aarch64-linux-gnu-g++ qemu-aarch64 ;;
    armhf) echo arm-linux-gnueabihf-g++ qemu-arm ;;
    windows) echo x86_64-w64-mingw32-g++-posix /usr/lib/wine/wine64 ;;
    wasm32*) echo clang++-19 wasm-ld-19 node ;;
  esac
}

run() {  # NAME PROGRAM
  case $1 in
    i686) qemu-i386 -L /usr/i686-linux-gnu "$2" ;;
    aarch64) qemu-aarch64 -L /usr/aarch64-linux-gnu "$2" ;;
    armhf) qemu-arm -L /usr/arm-linux-gnueabihf "$2" ;;
    windows) WINEPREFIX="$here/build/bits/wine" WINEDEBUG=-all /usr/lib/wine/wine64 "$2.exe" ;;
    wasm32*) node --no-warnings --experimental-wasi-unstable-preview1 tools/wasi.mjs "$2" ;;
    *) "$2" ;;
  esac
}

# Builds a variant and puts what is to be said of it into a file. Exit code as the script's.
try() {  # NAME
  local name=$1 program=marrow_bits folder="build/bits/$1" missing=""
  for tool in $(needs "$name"); do command -v "$tool" >/dev/null || missing="$missing $tool"; done
  if [ -n "$missing" ]; then
    echo "SKIPPED: no$missing" >"$folder.txt"
    return 3
  fi
  [ "$name" != one-file ] || program=marrow_bits_in_one_file
  # shellcheck disable=SC2046,SC2086
  if ! { cmake --fresh -G Ninja -S . -B "$folder" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG" \
    -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_GLES=OFF -DMARROW_BITS=ON -DCMAKE_UNITY_BUILD=ON \
    -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 --no-warn-unused-cli $(arguments "$name") && cmake --build "$folder" --target $program
  } >"$folder.log" 2>&1; then
    echo "FAILED to build, see $folder.log" >"$folder.txt"
    return 2
  fi
  local code=0
  run "$name" "$folder/tests/bits/$program" >"$folder.out" 2>"$folder.log" || code=$?
  tail -n 1 "$folder.out" | tr -d '\r' >"$folder.txt"
  [ $code -eq 0 ] || { echo "DIFFERS or failed, see $folder.out and $folder.log" >>"$folder.txt"; return 1; }
}

# As many at a time as there are processors.
for name in "$@"; do
  while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
  (code=0; try "$name" || code=$?; echo $code >"build/bits/$name.code") &
done
wait

worst=0
for name in "$@"; do
  printf '%-28s %s\n' "$name" "$(paste -sd ' ' "build/bits/$name.txt")"
  case "$(cat "build/bits/$name.code") $worst" in
    "1 "*) worst=1 ;;
    "2 0" | "2 3") worst=2 ;;
    "3 0") worst=3 ;;
  esac
done
exit $worst
