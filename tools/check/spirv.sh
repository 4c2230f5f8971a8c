#!/usr/bin/env bash
# For ports to Vulkan and Metal: every text of marrow::gles3 becomes SPIR-V for Vulkan (glslang) and is validated, and
# that becomes OpenGL ES again, which must compile, and Metal's language (SPIRV-Cross). Then the compute shader skins
# meshes on Vulkan, in software, and every vertex is compared with the CPU's. See docs/other_apis.md.
# usage: tools/check/spirv.sh
# The texts stay in build/spirv/texts: NAME.vert, .frag or .comp, and beside each .spv, .es and .metal. All that it needs
# comes from Debian's packages; where they cannot be had it says so and exits with 3.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$PWD/build/spirv
skip() { echo "SKIPPED: SPIR-V, Vulkan and Metal: $1" >&2; exit 3; }
tools/install.sh tools/packages/build.txt tools/packages/spirv.txt || skip "some packages cannot be installed"

mkdir -p "$work"
{ cmake -G Ninja -C cmake/quick.cmake -S . -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF \
  -DMARROW_SPIRV=ON && cmake --build "$work/build" --target marrow_shader_texts marrow_vulkan_skin; } \
  >"$work/build.log" 2>&1 || { tail -30 "$work/build.log" >&2; exit 2; }
programs=$work/build/tests/vulkan
rm -rf "$work/texts" && mkdir "$work/texts"
"$programs/marrow_shader_texts" "$work/texts" >&2

# Vulkan knows no uniforms outside blocks, and no OpenGL ES before 3.10: `-R` makes the block MarrowUniforms of them, at
# binding 5 (which nothing of Marrow's reaches from below), and the first line changes.
check_text() {  # FILE
  local text=$1 stage=${1##*.} version=300
  [ "$stage" != comp ] || version=310
  sed '1s/.*/#version 310 es/' "$text" >"$text.310" &&
    glslangValidator -S "$stage" "$text" &&
    glslangValidator -V -R --auto-map-bindings --auto-map-locations --set-default-uniform-block MarrowUniforms 0 5 \
      -S "$stage" -o "$text.spv" "$text.310" &&
    spirv-val --target-env vulkan1.0 "$text.spv" &&
    spirv-cross "$text.spv" --es --version "$version" --output "$text.es" &&
    glslangValidator -S "$stage" "$text.es" &&
    spirv-cross "$text.spv" --msl --msl-decoration-binding --output "$text.metal" &&
    rm "$text.310"
}
check_quietly() {
  local said
  if said=$(check_text "$1" 2>&1); then echo "$1"; else echo "check/spirv: $1: $said" >&2; fi
}
export -f check_text check_quietly
# The short form takes those that a Vulkan driver runs below, and every twelfth.
every=1
[ "${MARROW_TESTS:-}" = all ] || every=12
find "$work/texts" -type f | sort |
  awk -v every=$every '/\/compute-[a-z]+-[a-z]+-[48]-p(n|nt)?\.comp$/ || NR % every == 0' >"$work/checked.txt"
all=$(wc -l <"$work/checked.txt")
passed=$(xargs -P2 -n1 bash -c 'check_quietly "$0"' <"$work/checked.txt" | wc -l)
echo "$all texts, $passed passed: OpenGL ES → SPIR-V for Vulkan → OpenGL ES, Metal's language"
[ "$all" -gt 0 ] && [ "$passed" = "$all" ] || exit 1

# What the manual shows is what runs.
if sed -n '/^```cpp/,/^```$/p' docs/other_apis.md | grep -v '^```' | grep -vxFf tests/vulkan/skin_test.cpp >&2; then
  echo "check/spirv: docs/other_apis.md: these lines are not in tests/vulkan/skin_test.cpp" >&2
  exit 1
fi

code=0
"$programs/marrow_vulkan_skin" "$work/texts" || code=$?
[ $code -ne 77 ] || skip "no driver of Vulkan"
exit $code
