#!/usr/bin/env bash
# Makes the kit of tools/phone.sh, runs it under qemu as arm64, on Mesa for that processor, and as armv7, without OpenGL
# ES, and puts both results into a copy of docs/performance.md. Then it spoils them: each must be refused. Two minutes.
# usage: tools/check_phone.sh
# Exit code: 0 good, 1 not, 2 no build, 3 a compiler, qemu or Mesa cannot be had here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$PWD/build/phone/check
mesa=${MARROW_ARM64_GL:-$PWD/build/arm64-gl}
missing() { echo "check_phone: $1" >&2; exit 3; }
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
run arm64 "an | emulated <!-- board" qemu-aarch64 -L "$mesa"
# What a kit does about a driver that crashes: two paths of the self-test, one after the other, and one path's figures.
cat >"$work/crash.sh" <<'END'
#!/bin/bash
case "$2 $(cat trying.txt 2>/dev/null)" in
  "self-test ") echo 1 >trying.txt && kill -SEGV $$ ;;
  "self-test 1") echo 3 >trying.txt && kill -SEGV $$ ;;
  "gpu "*) [ "$3" != compute ] || kill -SEGV $$ ;;
esac
exec qemu-arm -L /usr/arm-linux-gnueabihf "$@"
END
run armv7 "a second" bash "$work/crash.sh"
echo 3 >"$work/trying.txt"
qemu-aarch64 -L "$mesa" "$work/kit/arm64/marrow_phone" self-test "$work/trying.txt" >"$work/crashed.json"
python3 tools/phone/check_results.py "$work"
