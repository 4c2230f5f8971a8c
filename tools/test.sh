#!/usr/bin/env bash
# Installs what is missing, builds and tests. Says at the end what took how long: wall seconds, and seconds of processor.
# usage: tools/test.sh              every test of behaviour once, optimised; under sanitizers what reads others' bytes
#        tools/test.sh all          every preset, driver and model, as before a release: about an hour
#        tools/test.sh PRESET ...   all tests of these presets: release asan tsan scalar aarch64 dev
#        tools/test.sh PART ...     a warm loop: builds and runs these alone, by preset dev. A PART is runtime format misuse ik input
#                                   cook workflow deform road bench cli view gl; GTEST_FILTER=PATTERN picks tests of it
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$here"
presets=" release asan tsan scalar aarch64 dev "
parts=" runtime format misuse ik input cook workflow deform road bench cli view gl "
usage() { sed -n '3,7s/^# \{0,1\}//p' "$0" >&2; exit 1; }

# Runs a command and notes what it took, under a name.
took=""
timed() {  # NAME COMMAND ...
  local name=$1 code=0 start end
  shift
  start="$EPOCHREALTIME $(processor_seconds)"
  "$@" || code=$?
  end="$EPOCHREALTIME $(processor_seconds)"
  took+=$(awk -v a="$start" -v b="$end" -v name="$name" 'BEGIN {
    split(a, s, " "); split(b, e, " "); printf "%-28s %6.0f s %6.0f s of processor", name, e[1] - s[1], e[2] - s[2] }')$'\n'
  return $code
}
# Of this shell's ended children, user and system.
processor_seconds() {
  awk '{ print ($16 + $17) / '"$(getconf CLK_TCK)"' }' "/proc/$$/stat" 2>/dev/null || echo 0
}
trap 'printf "%s" "$took" >&2' EXIT

build() { cmake --preset "$1" >/dev/null && cmake --build --preset "$@"; }
# Address randomisation with many bits defeats the thread sanitizer of older compilers.
run() {
  local plain=()
  if [ "$1" = tsan ] && setarch -R true 2>/dev/null; then plain=(setarch -R); fi
  "${plain[@]}" ctest --preset "$@" -j2
}

# Other opinions from npm, where it can be reached: another OpenGL ES driver, and the Khronos validator.
get_angle() {
  export MARROW_ANGLE="${MARROW_ANGLE:-$here/build/angle}"
  [ -e "$MARROW_ANGLE/libEGL.so" ] || tools/get_angle.sh "$MARROW_ANGLE" || echo "SKIPPED: tests on ANGLE" >&2
}
validate_sample() {
  tools/validate_gltf.sh tools/sample/newt.glb && return 0
  [ $? -eq 3 ] && echo "SKIPPED: gltf-validator on the sample" >&2
}
check_bindings() {
  tools/check_bindings.sh build/release/tools/marrow && return 0
  [ $? -eq 3 ] && echo "SKIPPED: calls from some of Rust, C# and JavaScript" >&2
}
get_arm64_gl() {
  export MARROW_ARM64_GL="${MARROW_ARM64_GL:-$here/build/arm64-gl}"
  tools/get_arm64.sh "$MARROW_ARM64_GL" tools/packages/arm64-gl.txt || echo "SKIPPED: OpenGL ES on AArch64" >&2
}

compare_bytes() {
  tools/same_bytes.sh && return 0
  [ $? -eq 3 ] && echo "SKIPPED: cooked bytes of some compilers or processors" >&2
}

compare_bits() {
  tools/same_bits.sh && return 0
  [ $? -eq 3 ] && echo "SKIPPED: bits of poses by some compilers or processors" >&2
}

check_web() {
  tools/check_web.sh build/release/tools/marrow && return 0
  [ $? -eq 3 ] && echo "SKIPPED: WebGL 2 in a browser" >&2
}

check_fbx() {
  tools/check_fbx.sh build/release/tools/marrow && return 0
  [ $? -eq 3 ] && echo "SKIPPED: FBX, by Blender" >&2
}

check_phone() {
  tools/check_phone.sh && return 0
  [ $? -eq 3 ] && echo "SKIPPED: the kit for phones" >&2
}

fuzz() {
  tools/fuzz.sh 30 && return 0
  [ $? -eq 3 ] && echo "SKIPPED: libFuzzer" >&2
}

test_preset() {
  echo "== $1" >&2
  [ "$1" != release ] || timed "get ANGLE" get_angle
  [ "$1" != aarch64 ] || timed "get OpenGL ES for AArch64" get_arm64_gl
  timed "build $1" build "$1"
  timed "run $1" run "$1"
}

test_parts() {
  local targets=() names
  for part in "$@"; do targets+=("marrow_${part}_tests"); done
  names=$(IFS='|'; echo "$*")
  timed "build $*" build dev --target "${targets[@]}"
  timed "run $*" run dev -R "^($names)(\.[0-9]+)?\$"
}

test_once() {
  timed "validate the sample" validate_sample
  timed "build release" build release
  timed "run release" run release -LE long
  timed "build hostile, sanitized" build asan --target marrow_hostile
  timed "run hostile, sanitized" run asan -L hostile
}

timed packages tools/install.sh tools/packages/build.txt tools/packages/test.txt
case "${1:-}" in
  "") test_once ;;
  all)
    [ $# -eq 1 ] || usage
    timed "validate the sample" validate_sample
    # What is sanitized, emulated or without SIMD takes the same roads through the code in the short form.
    MARROW_TESTS=all test_preset release
    for preset in asan tsan scalar aarch64; do test_preset $preset; done
    export MARROW_TESTS=all
    timed "Rust, C# and JavaScript" check_bindings
    timed "same bytes everywhere" compare_bytes
    timed "same bits everywhere" compare_bits
    timed "FBX, by Blender" check_fbx
    timed "WebGL 2, in Chromium" check_web
    timed "what phones' compilers say" tools/gpu_cost.sh --if-changed
    timed "the kit for phones" check_phone
    timed "SPIR-V, Vulkan and Metal" tools/check_spirv.sh
    timed "installed, in a game" tools/check_install.sh
    timed "libFuzzer, 30 s a target" fuzz
    ;;
  *)
    if [[ $presets == *" $1 "* ]]; then
      for preset in "$@"; do [[ $presets == *" $preset "* ]] || usage; done
      for preset in "$@"; do test_preset "$preset"; done
    else
      for part in "$@"; do [[ $parts == *" $part "* ]] || usage; done
      test_parts "$@"
    fi
    ;;
esac
