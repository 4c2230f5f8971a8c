#!/usr/bin/env bash
# Builds the game of platform/web to WebAssembly, draws it by WebGL 2 in a headless Chromium, and compares the pictures
# with those of `marrow render`; see docs/platforms/web.md. Exit 1 if they differ or the program has grown beyond its limit, 3 if
# a compiler or a browser cannot be had. Builds in build/web-newt, pictures go to build/web-newt/pictures.
# usage: tools/check/web.sh MARROW      (the program)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
work="$here/build/web-newt"
most=66500  # bytes of newt.wasm as brotli sends it

missing() { for name in em++ node chromium brotli; do command -v "$name" >/dev/null || echo "$name"; done; }
[ -z "$(missing)" ] || "$here/tools/install.sh" "$here/tools/packages/web.txt" || true
[ -z "$(missing)" ] || { echo "check/web: there is no $(missing | paste -sd ' ')" >&2; exit 3; }
export NODE_PATH=${NODE_PATH:-/usr/share/nodejs}  # where Debian's compiler has its own modules
mkdir -p "$work"

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; exit 1; }
}
quietly emcmake cmake -S "$here" -B "$work" -G Ninja -DCMAKE_BUILD_TYPE=MinSizeRel \
  "-DCMAKE_CXX_FLAGS_MINSIZEREL=-Oz -DNDEBUG" -DCMAKE_CXX_FLAGS=-msimd128 -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF \
  -DMARROW_WERROR=OFF
quietly cmake --build "$work" --target marrow_web_newt marrow_web_solvers

built="$work/platform/web"
sent() { brotli -q 11 -c "$built/$1" | wc -c; }
for file in newt.wasm newt.mjs solvers.wasm; do
  echo "$file: $(wc -c <"$built/$file") B, $(sent "$file") B by brotli"
done
[ "$(sent newt.wasm)" -le $most ] || { echo "check/web: newt.wasm is more than $most B by brotli" >&2; exit 1; }
node "$here/tools/web/draw.mjs" "$marrow" "$built" "$work/pictures"
