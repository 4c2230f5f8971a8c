#!/usr/bin/env bash
# Runs a program for AArch64 under qemu-user, with Mesa for that processor: on_arm64.sh FOLDER PROGRAM [ARGUMENT …].
# Exits with 77, which ctest counts as skipped, where Mesa has not been unpacked to the folder.
folder=${MARROW_ARM64_GL:-$1}
shift
if [ ! -e "$folder/lib/ld-linux-aarch64.so.1" ]; then
  echo "SKIPPED: no OpenGL ES for AArch64 in $folder; get it by: tools/get_arm64.sh $folder tools/packages/arm64-gl.txt" >&2
  exit 77
fi
exec qemu-aarch64 -L "$folder" "$@"
