#!/usr/bin/env bash
# Builds build/web-package/, the package for npm, which is published nowhere.
# Exit 1 if a build fails, 3 if a compiler cannot be had. Builds in build/web-build; see docs/platforms/web.md.
# usage: tools/web/package.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work="$here/build/web-build"
mkdir -p "$work"

missing() { for name in clang++-19 wasm-ld-19 brotli python3; do command -v "$name" >/dev/null || echo "$name"; done; }
[ -z "$(missing)" ] || "$here/tools/install.sh" "$here/tools/packages/web-package.txt" || true
[ -z "$(missing)" ] || { echo "web: there is no $(missing | paste -sd ' ')" >&2; exit 3; }

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { tail -n 60 "$work/log.txt" >&2; exit 1; }
}

# marrow-all and marrow-core, with SIMD and without.
build_libraries() {  # FOLDER SIMD FLAGS
  local folder="$work/$1"
  quietly cmake -S "$here" -B "$folder" -G Ninja --toolchain "$here/cmake/wasm32.cmake" -DCMAKE_BUILD_TYPE=MinSizeRel \
    -DMARROW_WASM_SIMD="$2" "-DCMAKE_CXX_FLAGS_MINSIZEREL=-Oz -DNDEBUG -flto $3" -DCMAKE_UNITY_BUILD=ON \
    -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_INSTALL=OFF -DMARROW_WERROR=OFF
  quietly cmake --build "$folder" ${MARROW_JOBS:+-j "$MARROW_JOBS"} --target marrow-all marrow-core
}

out="$here/build/web-package"
version=$(sed -n 's/^#define MARROW_VERSION_\(MAJOR\|MINOR\|PATCH\) //p' "$here/runtime/include/marrow/version.h" |
  paste -sd .)
build_libraries plain OFF ""
# Browsers have had these before SIMD.
build_libraries simd ON "-mbulk-memory -mnontrapping-fptoint"
rm -rf "$out"
quietly python3 "$here/tools/c_api" --bindings "$work/bindings"
mkdir -p "$out"
cp "$work"/bindings/{marrow.mjs,tables.mjs,gl.mjs,marrow.d.ts} "$here/platform/web/gl.d.mts" "$here/LICENSE" "$out"
cp "$here"/platform/web/package/{README.md,example.html} "$out"
sed "s/\"version\": \"[^\"]*\"/\"version\": \"$version\"/" "$here/platform/web/package/package.json" >"$out/package.json"
for name in core all; do
  cp "$work/plain/platform/web/marrow-$name.wasm" "$out/marrow-$name.wasm"
  cp "$work/simd/platform/web/marrow-$name.wasm" "$out/marrow-$name-simd.wasm"
done
for file in "$out"/*.wasm "$out"/{marrow,tables,gl}.mjs; do
  echo "$(basename "$file"): $(wc -c <"$file") B, $(brotli -q 11 -c "$file" | wc -c) B by brotli"
done
