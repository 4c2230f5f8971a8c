#!/usr/bin/env bash
# From a bare Debian machine to a picture: cooks models, draws them by linear blend skinning and by animation space, and
# writes out/NAME.mrw and out/NAME.png. Without arguments it shows the sample that comes with Marrow.
# usage: tools/demo.sh [MODEL.glb ...]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$here/tools/install.sh" "$here/tools/packages/build.txt"
# Clang, where it is, compiles the tools without optimising in half of g++'s time; what computes is optimised.
CC=$(command -v clang || command -v cc) CXX=$(command -v clang++ || command -v c++) cmake -S "$here" -B "$here/build/demo" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMARROW_TESTS=OFF \
  -DMARROW_ALL_COMMANDS=OFF -DMARROW_VIEW=OFF -DMARROW_TOOLS_FLAGS=-O0 -DMARROW_NUMERIC_FLAGS=-O1 >/dev/null
cmake --build "$here/build/demo" --target marrow >/dev/null || cmake --build "$here/build/demo" --target marrow
"$here/build/demo/tools/marrow" demo "$@" -o "$here/out"
