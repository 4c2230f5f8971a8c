#!/usr/bin/env bash
# Builds the package for npm, takes the sample character down the road of tests/bindings in it, with SIMD and without,
# draws the package's example in a headless Chromium as `marrow render` does, and compiles a program in TypeScript.
# Exit 1 if something differs or a file has grown beyond its limit, 3 if a compiler, a browser or npm cannot be had.
# usage: tools/check/package.sh MARROW      (the program)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
package="$here/build/web-package"
work="$here/build/web-check"
mkdir -p "$work"
typescript=5.9.3
skipped=0

missing() { for name in node npm chromium brotli; do command -v "$name" >/dev/null || echo "$name"; done; }
[ -z "$(missing)" ] || "$here/tools/install.sh" "$here/tools/packages/web-package.txt" || true
[ -z "$(missing)" ] || { echo "check/package: there is no $(missing | paste -sd ' ')" >&2; exit 3; }
"$here/tools/web/package.sh"
quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; exit 1; }
}

# Bytes as brotli sends them.
while read -r name most; do
  sent=$(brotli -q 11 -c "$package/$name" | wc -c)
  [ "$sent" -le "$most" ] || { echo "check/package: $name is $sent B by brotli, more than $most" >&2; exit 1; }
done <<'END'
marrow-core-simd.wasm 86000
marrow-core.wasm 109000
marrow-all-simd.wasm 171000
marrow-all.wasm 233000
END

# The road, in node: what C says, by both.
"$marrow" cook "$here/tools/sample/newt.glb" --mesh-codec none --clip-codec raw -o "$work/newt.mrw" >/dev/null
quietly cmake -S "$here" -B "$work/c" -G Ninja -DCMAKE_BUILD_TYPE=Release -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF \
  -DMARROW_WERROR=OFF -DMARROW_GLES=OFF -DMARROW_DRACO=ON -DMARROW_MESHOPT=ON -C "$here/cmake/quick.cmake"
quietly cmake --build "$work/c" ${MARROW_JOBS:+-j "$MARROW_JOBS"} --target marrow_c_shared
export LD_LIBRARY_PATH="$work/c/runtime/c"
quietly gcc -std=c99 -I"$here/runtime/include" "$here/tests/c/road.c" -o "$work/road_c" -L"$LD_LIBRARY_PATH" -lmarrow_c
wanted=$("$work/road_c" "$work/newt.mrw" | tail -n 1)
cp "$here"/tests/bindings/{road,gles3}.mjs "$package"/{marrow,tables,gl}.mjs "$work"
for name in marrow-all marrow-all-simd; do
  got=$(node "$work/road.mjs" "$package/$name.wasm" "$work/newt.mrw" | tail -n 1)
  [ "$got" = "$wanted" ] || { echo "check/package: $name: a hash of $got, and $wanted in C" >&2; exit 1; }
  echo "$name: the road's hash is $got, as in C"
  node "$work/gles3.mjs" "$package/$name.wasm" "$work/newt.mrw"
done

node "$here/tools/web/example.mjs" "$marrow" "$package" "$work/pictures"

# TypeScript, from the package as npm installs it.
npm="$work/npm"
if [ -d "$npm/node_modules/typescript" ] ||
  npm install --silent --no-audit --no-fund --prefix "$npm" "typescript@$typescript" >"$work/log.txt" 2>&1; then
  mkdir -p "$npm/node_modules/marrow-animation"
  tar -xzf <(cd "$work" && cat "$(npm pack --silent "$package")") -C "$npm/node_modules/marrow-animation" \
    --strip-components 1
  cp "$here/tests/platform/web/play.ts" "$npm"
  (cd "$npm" && quietly node_modules/.bin/tsc --noEmit --strict --target es2022 --module nodenext \
    --lib es2022,dom,dom.iterable play.ts)
  echo "TypeScript $typescript: play.ts compiles against the package"
else
  echo "SKIPPED: TypeScript: npm cannot be reached" >&2
  skipped=3
fi
exit $skipped
