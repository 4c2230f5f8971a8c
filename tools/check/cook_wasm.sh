#!/usr/bin/env bash
# Builds the cooker for WebAssembly, cooks with it in node, and compares with what the program writes; see
# docs/cooking/library.md. Exit 1 if they differ or cook.wasm has grown beyond its limit, 3 if a compiler or the sources
# of Draco and meshoptimizer cannot be had. Builds in build/cook-wasm.
# usage: tools/check/cook_wasm.sh MARROW      (the program)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
work="$here/build/cook-wasm"
most=1000000  # bytes of cook.wasm as brotli sends it

missing() { for name in clang++-19 wasm-ld-19 node brotli xz; do command -v "$name" >/dev/null || echo "$name"; done; }
"$here/tools/install.sh" "$here/tools/packages/cook-wasm.txt" || true
[ -z "$(missing)" ] || { echo "check/cook_wasm: there is no $(missing | paste -sd ' ')" >&2; exit 3; }
packages="$work/packages"
mkdir -p "$packages/include" "$packages/features/draco"

# The libraries that are no headers, from Debian's own sources. A second run finds them there.
get_source() {  # PACKAGE FOLDER
  [ ! -d "$packages/$2" ] || return 0
  local apt="$work/apt"
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
  { echo "check/cook_wasm: apt has no sources of Draco and meshoptimizer" >&2; exit 3; }
for header in nlohmann fmt glm toml++ tiny_gltf.h xxhash.h stb/stb_image.h eigen3/Eigen; do
  ln -sfn "/usr/include/$header" "$packages/include/$(basename "$header")"
done
grep -v TRANSCODER /usr/include/draco/draco_features.h >"$packages/features/draco/draco_features.h"

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { tail -n 60 "$work/log.txt" >&2; exit 1; }
}
# Sizes of 64 bits become those of 32, of which compilers warn: each has been held to a length in memory by then.
quietly cmake -S "$here" -B "$work/build" -G Ninja --toolchain "$here/cmake/wasm32.cmake" \
  -DCMAKE_BUILD_TYPE=MinSizeRel -DCMAKE_CXX_FLAGS=-fexceptions -DMARROW_WERROR=OFF \
  -DMARROW_PACKAGES="$packages" -DMARROW_COOKER=ON -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_GLES=OFF -DMARROW_INSTALL=OFF
quietly cmake --build "$work/build" --target marrow_cook_wasm
wasm="$work/build/tools/cook/cook.wasm"
sent=$(brotli -q 11 -c "$wasm" | wc -c)
echo "cook.wasm: $(wc -c <"$wasm") B, $sent B by brotli"
[ "$sent" -le $most ] || { echo "check/cook_wasm: cook.wasm is more than $most B by brotli" >&2; exit 1; }

newt="$here/tools/sample/newt.glb"
compare() {  # OPTIONS as TOML, the same for the program
  local toml=$1
  shift
  node "$here/tools/cook/wasm.mjs" "$wasm" "$newt" "$work/page.mrw" "$toml" >"$work/said.txt"
  "$marrow" cook "$newt" "$@" -o "$work/program.mrw" >/dev/null 2>&1
  cmp "$work/page.mrw" "$work/program.mrw" ||
    { echo "check/cook_wasm: other bytes than the program's, by $*" >&2; exit 1; }
  echo "the newt, $*: $(tail -n 1 "$work/said.txt"), as by the program"
}
compare "" --effort default
compare "mesh-codec = 'meshopt'
lod = '0.5'" --mesh-codec meshopt --lod 0.5

# A failure is JavaScript's, with its place.
printf '{"asset": {"version": "2.0"}, "nodes": 3}' >"$work/bad.gltf"
said=$(node "$here/tools/cook/wasm.mjs" "$wasm" "$work/bad.gltf" "$work/bad.mrw" 2>&1) && said="nothing"
[[ "$said" == *"bad.gltf: /nodes:"* ]] || { echo "check/cook_wasm: a bad file is told as: $said" >&2; exit 1; }
