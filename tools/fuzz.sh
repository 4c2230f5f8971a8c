#!/usr/bin/env bash
# Lets libFuzzer search for inputs that break what reads others' bytes: optimised, under ASan and UBSan. What it finds is
# written to build/fuzz/found; its corpora grow in build/fuzz/corpus.
# usage: tools/fuzz.sh [SECONDS [TARGET...]]   each target for so long, 3600 if left out; targets: mrw clip unpack
#                                              gltf glb settings self_test
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-3600}
[[ $seconds =~ ^[0-9]+$ ]] || { sed -n '2,5s/^# //p' "$0" >&2; exit 1; }
shift || true
[ $# -gt 0 ] || set -- mrw clip unpack gltf glb settings self_test

tools/install.sh tools/packages.txt tools/packages-fuzz.txt
cmake --preset fuzz >/dev/null
program() {
  case "$1" in
    glb) echo tests/marrow_gltf_fuzz ;;
    self_test) echo tests/gl/marrow_self_test_fuzz ;;
    *) echo "tests/marrow_$1_fuzz" ;;
  esac
}
seeds() {
  case "$1" in
    mrw) echo tests/golden/*.mrw ;;
    gltf) echo tests/golden/*.gltf ;;
    unpack) echo tests/fuzz/seeds/*.mrw ;;
    glb) echo tests/fuzz/seeds/*.glb ;;
    settings) echo tests/fuzz/seeds/*.toml ;;
    clip) echo tests/fuzz/seeds/*.clip ;;
    self_test) echo tests/fuzz/seeds/*.selftest ;;
    *) echo "fuzz: no target '$1'" >&2; exit 1 ;;
  esac
}
failed=0
for target in "$@"; do
  files=$(seeds "$target")
  cmake --build --preset fuzz --target "$(basename "$(program "$target")")" >/dev/null
  corpus=build/fuzz/corpus/$target
  mkdir -p "$corpus" build/fuzz/found
  # shellcheck disable=SC2086
  cp -n $files "$corpus"
  # A tool's own memory and time are bounded; an input may take ten seconds at most.
  if "build/fuzz/$(program "$target")" "$corpus" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536 \
      -artifact_prefix="build/fuzz/found/$target-" -print_final_stats=1 >"build/fuzz/$target.log" 2>&1; then
    word="no complaint"
  else
    word="FAILED, see build/fuzz/$target.log"
    failed=1
  fi
  awk -v target="$target" -v word="$word" '/number_of_executed_units/ { units = $2 } /average_exec_per_sec/ { rate = $2 }
    / cov: / { for (i = 1; i < NF; i++) if ($i == "cov:") coverage = $(i + 1) }
    END { printf "%-9s %10d executions, %6d a second, %6d places covered: %s\n", target, units, rate, coverage, word }' \
    "build/fuzz/$target.log"
done
exit $failed
