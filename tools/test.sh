#!/usr/bin/env bash
# Installs what is missing, builds and runs the tests: optimised, under the sanitizers, without SIMD, and on AArch64.
# usage: tools/test.sh [PRESET ...]     presets: release asan tsan scalar aarch64 dev; without arguments the first five
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$here"
[ $# -gt 0 ] || set -- release asan tsan scalar aarch64

tools/install.sh tools/packages.txt tools/packages-test.txt

# Second opinions from npm, where it can be reached: another OpenGL ES driver, and the Khronos validator. And Debian's
# OpenGL ES for the other processor, below.
export MARROW_ANGLE="${MARROW_ANGLE:-$here/build/angle}"
[ -e "$MARROW_ANGLE/libEGL.so" ] || tools/get_angle.sh "$MARROW_ANGLE" || echo "SKIPPED: tests on ANGLE" >&2
tools/validate_gltf.sh tools/sample/newt.glb || { code=$?; [ $code -eq 3 ] && echo "SKIPPED: gltf-validator on the sample" >&2 || exit $code; }

case " $* " in
  *" aarch64 "*)
    export MARROW_ARM64_GL="${MARROW_ARM64_GL:-$here/build/arm64-gl}"
    tools/get_arm64_gl.sh "$MARROW_ARM64_GL" || echo "SKIPPED: OpenGL ES on AArch64" >&2
    ;;
esac

# Address randomisation with many bits defeats the thread sanitizer of older compilers.
run_tests() {
  local run=()
  if [ "$1" = tsan ] && setarch -R true 2>/dev/null; then run=(setarch -R); fi
  "${run[@]}" ctest --preset "$1" -j2
}
for preset in "$@"; do
  echo "== $preset" >&2
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset"
  run_tests "$preset"
done
