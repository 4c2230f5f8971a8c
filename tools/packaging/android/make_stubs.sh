#!/usr/bin/env bash
# Makes libraries that stand in for Android's where there is no NDK: they export what stubs.txt says and do nothing.
# usage: tools/packaging/android/make_stubs.sh ABI FOLDER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
abi=$1 folder=$2
declare -A target=([arm64-v8a]=aarch64-linux-android21 [armeabi-v7a]=armv7a-linux-androideabi21 [x86_64]=x86_64-linux-android21)
mkdir -p "$folder/include"
for headers in EGL GLES3 KHR; do ln -sfn "/usr/include/$headers" "$folder/include/$headers"; done
declare -A names
while read -r first second rest; do
  case $first in
    "$abi") names[$second]+=" $rest" ;;
    lib*) names[$first]+=" $second $rest" ;;
  esac
done < <(sed 's/#.*//' "$here/stubs.txt")
for library in "${!names[@]}"; do
  # shellcheck disable=SC2086  # several words
  printf 'void %s(void) {}\n' ${names[$library]} >"$folder/${library%.so}.c"
  "clang-19" "--target=${target[$abi]}" -w -fno-builtin -fPIC -nostdlib -shared -fuse-ld=lld-19 "-Wl,-soname,$library" \
    "$folder/${library%.so}.c" -o "$folder/$library"
done
