#!/bin/sh
# Runs on the device, out of the kit of tools/phone.sh: measures, and writes result.json beside itself.
# usage: sh run.sh [--abi arm64|armv7] [--name NAME]
#   --abi     the programs to take; without, those that run, 64 bits first
#   --name    what the device is called; without, what Android or the kernel calls it
# Needs nothing but a shell: every part is a run of a program, and one that fails is told in its place.
# The environment's MARROW_RUNNER stands before each program: an emulator.
abis="arm64 armv7" name=
usage() { echo "usage: sh run.sh [--abi arm64|armv7] [--name NAME]" >&2; exit 1; }
while [ $# -gt 0 ]; do
  [ $# -ge 2 ] || usage
  case $1 in
    --abi) abis=$2 ;;
    --name) name=$2 ;;
    *) usage ;;
  esac
  shift 2
done
cd "$(dirname "$0")" || exit 2
[ -n "$name" ] || name=$(getprop ro.product.model 2>/dev/null)

# Copies by `adb push` and `scp` may have lost the right to be run.
chmod +x arm64/* armv7/* 2>/dev/null
for abi in $abis; do
  # shellcheck disable=SC2086  # the runner is several words
  device=$($MARROW_RUNNER "./$abi/marrow_phone" device "$name") && break
  device=
done
if [ -z "$device" ]; then
  echo "run.sh: $(pwd): no program of $abis runs on this machine: is the kit for this system?" >&2
  exit 1
fi

part() {  # WORD …: what marrow_phone says, or how it ended
  echo "run.sh: $*" >&2
  # shellcheck disable=SC2086
  said=$($MARROW_RUNNER "./$abi/marrow_phone" "$@")
  code=$?
  [ $code -eq 0 ] || said="{\"error\": \"the program ended with code $code\"}"
  echo "$said"
  return $code
}

bits() {
  echo "run.sh: bits" >&2
  # shellcheck disable=SC2086
  $MARROW_RUNNER "./$abi/marrow_bits" >bits.out
  code=$? hash="" differ="" comma=""
  while read -r word value rest; do
    case "$word $value $rest" in
      "bits "*) hash=$value ;;
      *"not what is stored"*)
        stage="$word $value $rest"
        stage=${stage#*\"}
        differ="$differ$comma\"${stage%%\"*}\"" comma=", "
        ;;
    esac
  done <bits.out
  rm -f bits.out
  if [ -z "$hash" ]; then
    echo "{\"error\": \"marrow_bits ended with code $code\"}"
    return
  fi
  same=false
  if [ "$hash" = "$kit_hash" ] && [ $code -eq 0 ]; then same=true; fi
  echo "{\"hash\": \"$hash\", \"kit\": \"$kit_hash\", \"same\": $same, \"differ\": [$differ]}"
}

# A path during which the driver crashed is left out the next time.
self_test() {
  rm -f trying.txt
  for _ in 0 1 2 3 4 5; do
    result=$(part self-test trying.txt) && break
    [ -s trying.txt ] || break
  done
  rm -f trying.txt
  echo "$result"
}

{ read -r kit_hash && read -r kit_version; } <kit.txt
{
  echo "{\"format\": 1, \"marrow\": \"$kit_version\", \"date\": \"$(date -u +%Y-%m-%d)\", \"abi\": \"$abi\","
  echo "\"device\": $device,"
  echo "\"bits\": $(bits),"
  echo "\"self_test\": $(self_test),"
  echo "\"cpu\": $(part cpu newt.mrw),"
  echo "\"gpu\": {"
  comma=
  for path in ubo texture feedback compute cpu; do
    echo "$comma\"$path\": $(part gpu $path newt.mrw)"
    comma=,
  done
  echo "}}"
} >result.json || exit 2
echo "run.sh: $(pwd)/result.json is written" >&2
