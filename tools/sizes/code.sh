#!/usr/bin/env bash
# Says how many bytes of code (.text) a game links: built with -Os, what is not called left out, C++'s own library not
# counted.
# usage: tools/sizes/code.sh [LIBDRACO.a]      (default: the one that is installed, built with -O2)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
draco=${1:--ldraco}
build="$here/build/small"
flags=(-std=c++20 -Os -DNDEBUG -ffunction-sections -fdata-sections)
cmake -S "$here" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=MinSizeRel -DCMAKE_CXX_FLAGS_MINSIZEREL="${flags[*]:1}" \
  -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_GLES=OFF -DMARROW_DRACO=ON -DMARROW_MESHOPT=ON >/dev/null
cmake --build "$build" >/dev/null
libraries=()
for name in draco meshopt unpack runtime; do libraries+=("$build/runtime/libmarrow_$name.a"); done

text() { size -A "$1" | awk '/^\.text/ {sum += $2} END {print sum + 0}'; }
program() {
  g++ "${flags[@]}" -Wno-unused-result -I "$here/runtime/include" "${@:2}" "$here/tools/sizes/code.cpp" -o "$build/program" \
    -Wl,--gc-sections "${libraries[@]}" -Wl,-Bstatic "$draco" -Wl,-Bdynamic -lmeshoptimizer
  printf '%-60s %7d\n' "$1" $(($(text "$build/program") - empty))
}
empty=0
empty=$(program "" -DSTAGES=0)
program "load, sample, blend, local to model" -DSTAGES=1
program "… and a limb, a look at" -DSTAGES=1 -DIK=1
program "… and chains by FABRIK or CCD, limits" -DSTAGES=1 -DIK=2
program "… and bodies by the Jacobian methods" -DSTAGES=1 -DIK=3
program "… and rates, springs, feet" -DSTAGES=1 -DIK=4
program "… and the genetic solver" -DSTAGES=1 -DIK=5
program "and palette, SSD" -DSTAGES=2
program "… and a limb, a look at" -DSTAGES=2 -DIK=1
program "and palette, SSD, animation space" -DSTAGES=3
program "… and a limb, a look at" -DSTAGES=3 -DIK=1
program "and unpack, meshoptimizer (its own library not counted)" -DSTAGES=3 -DUNPACK=meshopt_decoder
program "and unpack, Draco" -DSTAGES=3 -DUNPACK=draco_decoder
for library in "${libraries[@]:2}"; do printf '%-60s %7d\n' "all of $(basename "$library")" "$(text "$library")"; done
