#!/usr/bin/env bash
# Compiles every program of marrow::gles3 by the compilers of phones' GPUs, without the chips: Mesa's drivers of Mali,
# Adreno and VideoCore under qemu, which believe in a kernel that Mesa's "drm-shim" libraries play. Tells cycles,
# instructions, registers, threads and spills; exits with 1 where they are worse than in tools/gpu_cost/table.json:
# a new spill, fewer threads, or 5 % more of anything.
# usage: tools/gpu_cost.sh [PATTERN] [--gpu=PATTERN] [--json | --update | --if-changed]
#   PATTERN    only programs whose names fit, as `grep -E` would have it: ^ubo/as/4/
#   --gpu=…    only these GPUs: --gpu='G5|V3D'
#   --json     an array of rows on standard output, and nothing else
#   --update   writes the table, and the one in docs/performance.md; of some rows alone if so asked
#   --if-changed  does nothing where the shaders are still those that the table is of
# A name is path/deformer/influences/attributes/pass. How to read the figures: docs/performance.md, "What phones'
# compilers say". They are the compilers' static models, not times. All comes from Debian's packages and stays in
# build/gpu-cost; where they cannot be had it says so and exits with 3.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
usage() { sed -n '6,11s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 1; }
pattern="" mode="" gpu=()
for argument in "$@"; do
  case $argument in
    --json | --update | --if-changed) [ -z "$mode" ] || usage; mode=$argument ;;
    --gpu=*) gpu=("$argument") ;;
    -*) usage ;;
    *) [ -z "$pattern" ] || usage; pattern=$argument ;;
  esac
done
if [ "$mode" = --if-changed ] && python3 tools/gpu_cost/costs.py --unchanged; then
  echo "gpu_cost: the shaders are those of the table" >&2
  exit 0
fi
skip() { echo "SKIPPED: what phones' compilers say: $1" >&2; exit 3; }

tools/install.sh tools/packages/build.txt tools/packages/gpu-cost.txt || skip "some packages cannot be installed"
folder=$PWD/build/gpu-cost
root=$folder/root
tools/get_arm64.sh "$root" tools/packages/arm64-shaders.txt trixie || skip "no drivers of Mali, Adreno and VideoCore"

# The shims, of Mesa's source.
mesa=$folder/mesa/src
common="$mesa/util/hash_table.c $mesa/util/set.c $mesa/util/ralloc.c $mesa/util/vma.c $mesa/util/log.c
  $mesa/util/os_misc.c $mesa/util/os_file.c $mesa/util/anon_file.c $mesa/util/simple_mtx.c $mesa/util/u_call_once.c
  $mesa/util/u_debug.c $mesa/util/u_printf.c $mesa/util/u_process.c $mesa/c11/impl/threads_posix.c
  $mesa/drm-shim/device.c $mesa/drm-shim/drm_shim.c"
make_shim() {  # FILE
  # shellcheck disable=SC2086  # several words; HAVE_THRD_CREATE must not be there
  aarch64-linux-gnu-gcc -shared -fPIC -O1 -w -std=gnu11 -fvisibility=hidden -ffunction-sections -Wl,--gc-sections \
    -D_GNU_SOURCE -DHAVE_PTHREAD -DHAVE_STRUCT_TIMESPEC -DHAVE_ENDIAN_H -DHAVE_SECURE_GETENV -DHAVE_MEMFD_CREATE \
    -I"$root/usr/include" -I"$root/usr/include/libdrm" -I"$mesa" -I"$mesa/util" -I"$folder/mesa/include" \
    $common "$1" -o "$folder/making.so" 2>"$folder/shim.log" || { cat "$folder/shim.log" >&2; exit 2; }
  mv "$folder/making.so" "$folder/$(basename "$1" .c).so"
}
if [ ! -e "$folder/v3d_noop.so" ] || [ "$root/.packages" -nt "$folder/v3d_noop.so" ]; then
  rm -rf "$folder/mesa" && mkdir "$folder/mesa"
  tar -xf "$root"/source/mesa_*.orig.tar.?z -C "$folder/mesa" --strip-components=1 --wildcards \
    '*/include' '*/src/util' '*/src/c11' '*/src/drm-shim' '*/src/*/drm-shim'
  for shim in panfrost/drm-shim/panfrost freedreno/drm-shim/freedreno broadcom/drm-shim/v3d; do
    make_shim "$mesa/${shim}_noop.c"
  done
fi

{ cmake -G Ninja -C cmake/quick.cmake -S . -B "$folder/build" -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/aarch64.cmake" -DCMAKE_BUILD_TYPE=Release \
  -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_GPU_COST=ON --no-warn-unused-cli &&
  cmake --build "$folder/build" --target marrow_gpu_cost; } >"$folder/build.log" 2>&1 ||
  { tail -30 "$folder/build.log" >&2; exit 2; }
# shellcheck disable=SC2086  # none or one
exec python3 tools/gpu_cost/costs.py "$folder" "$folder/build/tools/gpu_cost/marrow_gpu_cost" "$pattern" "${gpu[@]}" $mode
