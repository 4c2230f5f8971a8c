#!/usr/bin/env bash
# Makes the kit of tools/phone.sh, runs it under qemu as arm64, on Mesa for that processor, and as armv7, without OpenGL
# ES, and puts both results into a copy of docs/performance.md. Then it spoils them: each must be refused. Two minutes.
# usage: tools/check/phone.sh
# Exit code: 0 good, 1 not, 2 no build, 3 a compiler, qemu or Mesa cannot be had here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$PWD/build/phone/check
mesa=${MARROW_ARM64_GL:-$PWD/build/arm64-gl}
missing() { echo "check/phone: $1" >&2; exit 3; }
tools/install.sh tools/packages/build.txt tools/packages/phone.txt || missing "some packages cannot be installed"
command -v qemu-aarch64 >/dev/null || tools/install.sh tools/packages/test.txt || missing "there is no qemu-user"
tools/get_arm64.sh "$mesa" tools/packages/arm64-gl.txt || missing "there is no OpenGL ES for AArch64"

rm -rf "$work" && mkdir -p "$work"
env -u ANDROID_NDK tools/phone.sh --out "$work/kit" >/dev/null
run() {  # ABI NAME EMULATOR …
  local abi=$1 name=$2
  shift 2
  MARROW_RUNNER="$*" sh "$work/kit/run.sh" --abi "$abi" --name "$name" 2>"$work/$abi.txt" ||
    { cat "$work/$abi.txt" >&2; exit 1; }
  mv "$work/kit/result.json" "$work/$abi.json"
}
run armv7 "a second" qemu-arm -L /usr/arm-linux-gnueabihf
# What run.sh does about other bits, and about a driver that crashes: in the self-test on one path after the other.
cat >"$work/stub.sh" <<'END'
#!/bin/bash
case "${1##*/} ${2:-} ${3:-} $(cat trying.txt 2>/dev/null)" in
  "marrow_bits "*) printf '    {"a, b", 0x1},  // not what is stored\n    {"c", 0x2},\nbits 00000000000000AB DIFFERS\n' && exit 1 ;;
  "marrow_phone device "*) echo '{"name": "stub", "cpu": "none", "system": "none", "machine": "none"}' ;;
  "marrow_phone self-test trying.txt ") echo 1 >trying.txt && kill -SEGV $$ ;;
  "marrow_phone self-test trying.txt 1") echo 3 >trying.txt && kill -SEGV $$ ;;
  "marrow_phone self-test trying.txt 3") echo '{"error": "tried thrice"}' ;;
  "marrow_phone gpu compute "*) kill -SEGV $$ ;;
  *) echo '{"error": "a stub"}' ;;
esac
END
run arm64 "" bash "$work/stub.sh" && mv "$work/arm64.json" "$work/stub.json"
run arm64 "an | emulated <!-- board" qemu-aarch64 -L "$mesa"
echo 3 >"$work/trying.txt"
qemu-aarch64 -L "$mesa" "$work/kit/arm64/marrow_phone" self-test "$work/trying.txt" >"$work/crashed.json"
python3 tools/phone/check_results.py "$work"
