#!/usr/bin/env bash
# Installs what is missing, builds and tests. Says at the end what took how long: wall seconds, and seconds of processor.
# usage: tools/test.sh              every test of behaviour once, optimised; under sanitizers what reads others' bytes
#        tools/test.sh ci           what continuous integration runs: on other drivers, more under sanitizers, the manual,
#                                   and the kits that have changed
#        tools/test.sh all          every preset, kit and model, as before a release: more than an hour
#        tools/test.sh PRESET ...   all tests of these presets: test release asan tsan scalar aarch64 dev
#        tools/test.sh PART ...     a warm loop: builds and runs these alone, by preset dev. A PART is runtime format misuse ik input
#                                   cook workflow deform road bench cli view gl; GTEST_FILTER=PATTERN picks tests of it
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$here"
presets=" test release asan tsan scalar aarch64 dev "
parts=" runtime format misuse ik input cook workflow deform road bench cli view gl "
usage() { sed -n '3,9s/^# \{0,1\}//p' "$0" >&2; exit 1; }

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
get_arm64_gl() {
  export MARROW_ARM64_GL="${MARROW_ARM64_GL:-$here/build/arm64-gl}"
  tools/get_arm64.sh "$MARROW_ARM64_GL" tools/packages/arm64-gl.txt || echo "SKIPPED: OpenGL ES on AArch64" >&2
}
# A check that needs what not every machine can have: its exit code 3 says so.
where_possible() {  # WHAT COMMAND ...
  local what=$1 code=0
  shift
  timed "$what" "$@" || code=$?
  [ $code -ne 3 ] || { echo "SKIPPED: some or all of: $what" >&2 && return 0; }
  return $code
}
validate_sample() { where_possible "gltf-validator on the sample" tools/validate_gltf.sh tools/sample/newt.glb tools/sample/newt_moves.glb; }

test_preset() {
  echo "== $1" >&2
  [[ "$1" != release && "$1" != test ]] || timed "get ANGLE" get_angle
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
  validate_sample
  timed "build test" build test
  timed "run test" run test -LE long
  timed "build hostile, sanitized" build asan --target marrow_hostile
  timed "run hostile, sanitized" run asan -L hostile
}

# What reads others' bytes, and what is cooked and played of it.
sanitized_in_ci() {
  timed "build asan" build asan --target marrow_hostile marrow_runtime_tests marrow_ik_tests marrow_cook_tests marrow_retarget_tests marrow_road_tests marrow_graph_tests
  timed "run asan" run asan -R '^(runtime|format|misuse|gl.misuse|input|ik|cook|cook.1|retarget|road|graph|fuzz[.].*)$'
}

timed packages tools/install.sh tools/packages/build.txt tools/packages/test.txt
case "${1:-}" in
  "") test_once ;;
  ci)
    [ $# -eq 1 ] || usage
    export MARROW_TESTS=ci MARROW_PROGRAM=$here/build/test/tools/marrow
    validate_sample
    test_preset test
    sanitized_in_ci
    test_preset tsan
    where_possible "the manual" tools/check/docs.sh "$MARROW_PROGRAM"
    timed kits tools/kits.py run
    ;;
  all)
    [ $# -eq 1 ] || usage
    validate_sample
    # What is sanitized, emulated or without SIMD takes the same roads through the code in the short form.
    MARROW_TESTS=all test_preset release
    for preset in asan tsan scalar aarch64; do test_preset $preset; done
    export MARROW_TESTS=all MARROW_PROGRAM=$here/build/release/tools/marrow
    where_possible "the manual" tools/check/docs.sh "$MARROW_PROGRAM"
    where_possible "same bytes everywhere" tools/same_bytes.sh
    timed "growth" tools/check/growth.py "$MARROW_PROGRAM"
    timed kits tools/kits.py --all
    where_possible "libFuzzer, 15 s a target" tools/fuzz.sh 15
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
