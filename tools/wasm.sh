#!/usr/bin/env bash
# Builds for WebAssembly what a page calls: cook.wasm, the cooker, and viewer.wasm, the stage of the page of tools/page.
# Builds in build/wasm, and says in its last lines what files it has made. Exit 3 if a compiler or the sources of Draco
# and meshoptimizer cannot be had.
# usage: tools/wasm.sh cook|viewer ...
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work="$here/build/wasm"
packages="$here/build/cook-wasm/packages"

missing() { for name in clang++-19 wasm-ld-19 xz; do command -v "$name" >/dev/null || echo "$name"; done; }
"$here/tools/install.sh" "$here/tools/packages/cook-wasm.txt" || true
[ -z "$(missing)" ] || { echo "wasm: there is no $(missing | paste -sd ' ')" >&2; exit 3; }
mkdir -p "$work" "$packages/include" "$packages/features/draco"

# The libraries that are no headers, from Debian's own sources. A second run finds them there.
get_source() {  # PACKAGE FOLDER
  [ ! -d "$packages/$2" ] || return 0
  local apt="$here/build/cook-wasm/apt"
  mkdir -p "$apt"/{state/lists/partial,cache/archives/partial}
  # shellcheck disable=SC2016  # apt's own words
  apt-get indextargets --format 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $(REPO_URI) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' | sort -u >"$apt/sources.list"
  local options=(-o Dir::State="$apt/state" -o Dir::Cache="$apt/cache" -o Dir::Etc::sourcelist="$apt/sources.list"
    -o Dir::Etc::sourceparts=/dev/null -o APT::Sandbox::User= -o Debug::NoLocking=true)
  (cd "$apt" && apt-get "${options[@]}" -qq update && apt-get "${options[@]}" -qq source --download-only "$1") \
    >"$apt/log.txt" 2>&1 || { tail -n 3 "$apt/log.txt" >&2; return 1; }
  mkdir "$packages/$2.part"
  tar -xJf "$apt/$1"_*.orig.tar.xz -C "$packages/$2.part" --strip-components 1
  mv "$packages/$2.part" "$packages/$2"
}
get_source draco draco && get_source meshoptimizer meshoptimizer ||
  { echo "wasm: apt has no sources of Draco and meshoptimizer" >&2; exit 3; }
for header in nlohmann fmt glm toml++ tiny_gltf.h xxhash.h stb/stb_image.h eigen3/Eigen GLES3 KHR; do
  ln -sfn "/usr/include/$header" "$packages/include/$(basename "$header")"
done
grep -v TRANSCODER /usr/include/draco/draco_features.h >"$packages/features/draco/draco_features.h"

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { tail -n 60 "$work/log.txt" >&2; exit 1; }
}
# Without SIMD, by which every model of the tests is the same bytes.
# Sizes of 64 bits become those of 32, of which compilers warn: each has been held to a length in memory by then.
quietly cmake -S "$here" -B "$work" -G Ninja --toolchain "$here/cmake/wasm32.cmake" \
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-Os -DNDEBUG" -DCMAKE_CXX_FLAGS=-fexceptions \
  -DMARROW_WERROR=OFF -DMARROW_CALL_ERRORS=OFF -DMARROW_UNITY=OFF \
  -DMARROW_PACKAGES="$packages" -DMARROW_COOKER=ON -DMARROW_PAGE=ON -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF \
  -DMARROW_GLES=ON -DMARROW_GLES_INCLUDE="$packages/include" -DMARROW_INSTALL=OFF
for name in "$@"; do
  quietly cmake --build "$work" ${MARROW_JOBS:+-j "$MARROW_JOBS"} --target "marrow_${name}_wasm"
done
for name in "$@"; do find "$work/tools" -name "$name.wasm"; done
