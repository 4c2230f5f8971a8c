#!/usr/bin/env bash
# Runs a program on ANGLE instead of the system's OpenGL ES: on_angle.sh FOLDER PROGRAM [ARGUMENT …].
# Exits with 77, which ctest counts as skipped, where ANGLE has not been unpacked to the folder.
folder=${MARROW_ANGLE:-$1}
shift
if [ ! -e "$folder/libEGL.so.1" ]; then
  echo "SKIPPED: no ANGLE in $folder; get it by: bash tools/get_angle.sh $folder" >&2
  exit 77
fi
export LD_LIBRARY_PATH="$folder${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
export MARROW_EXPECT_DRIVER=ANGLE
exec "$@"
