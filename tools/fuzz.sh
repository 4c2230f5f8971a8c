#!/usr/bin/env bash
# Lets libFuzzer search for inputs that break what reads others' bytes: optimised, under ASan and UBSan, as many targets
# at a time as there are processors. What it finds is written to build/fuzz/found; its corpora grow in build/fuzz/corpus.
# usage: tools/fuzz.sh [SECONDS [TARGET...]]   each target for so long, 3600 if left out; targets: mrw clip unpack
#                                              gltf glb bvh vertices settings self_test
# Exit code: 0 no complaint, 1 a target failed, 2 no build, 3 no clang here
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
usage() { sed -n '4,6s/^# //p' "$0" >&2; exit 1; }
seconds=${1:-3600}
[[ $seconds =~ ^[0-9]+$ ]] || usage
shift || true
[ $# -gt 0 ] || set -- mrw clip unpack gltf glb bvh vertices settings self_test

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
    bvh) echo tests/fuzz/seeds/*.bvh ;;
    vertices) echo tests/fuzz/seeds/*.vertices ;;
    settings) echo tests/fuzz/seeds/*.toml ;;
    clip) echo tests/fuzz/seeds/*.clip ;;
    self_test) echo tests/fuzz/seeds/*.selftest ;;
    *) echo "fuzz: no target '$1'" >&2; usage ;;
  esac
}
# A tool's own memory and time are bounded; an input may take ten seconds at most.
search() {  # TARGET
  "build/fuzz/$(program "$1")" "build/fuzz/corpus/$1" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=65536 -artifact_prefix="build/fuzz/found/$1-" -print_final_stats=1 >"build/fuzz/$1.log" 2>&1
}
line() {  # TARGET, of what it did
  awk -v target="$1" '/number_of_executed_units/ { units = $2 } /average_exec_per_sec/ { rate = $2 }
    / cov: / { for (i = 1; i < NF; i++) if ($i == "cov:") coverage = $(i + 1) }
    END { printf "%-9s %10d executions, %6d a second, %6d places covered: ", target, units, rate, coverage }' \
    "build/fuzz/$1.log"
}

tools/install.sh tools/packages/build.txt tools/packages/fuzz.txt || echo "fuzz: some packages cannot be installed" >&2
command -v clang++ >/dev/null || { echo "fuzz: clang++ is not installed" >&2; exit 3; }
programs=()
for target in "$@"; do
  mkdir -p "build/fuzz/corpus/$target" build/fuzz/found
  # shellcheck disable=SC2046
  cp -n $(seeds "$target") "build/fuzz/corpus/$target"
  programs+=("$(basename "$(program "$target")")")
done
cmake --preset fuzz >/dev/null && cmake --build --preset fuzz --target "${programs[@]}" >/dev/null || exit 2

declare -A job
for target in "$@"; do
  while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
  search "$target" &
  job[$target]=$!
done
failed=0
for target in "$@"; do
  word="no complaint"
  wait "${job[$target]}" || { word="FAILED, see build/fuzz/$target.log"; failed=1; }
  echo "$(line "$target")$word"
done
exit $failed
