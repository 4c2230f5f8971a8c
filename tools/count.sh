#!/usr/bin/env bash
# Counts the instructions an item of `marrow bench` rows: two runs under callgrind that differ in their iterations only.
# usage: tools/count.sh MARROW GLOB    (MARROW: the built program; needs valgrind)
set -euo pipefail
[ $# -eq 2 ] || { sed -n '3s/^# //p' "$0" >&2; exit 1; }
marrow=$1
rows=$("$marrow" bench --only "$2" --iterations 1)

instructions() {  # ROW ITERATIONS
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$marrow" bench --only "$1" --iterations "$2" 2>&1 >/dev/null |
    sed -n 's/.*Collected : //p'
}

tail -n +2 <<<"$rows" | while read -r name items _; do
  iterations=$((100000 / items + 1))
  few=$(instructions "$name" "$iterations")
  many=$(instructions "$name" $((3 * iterations)))
  awk -v name="$name" -v n=$((many - few)) -v items=$((2 * iterations * items)) 'BEGIN { printf "%-34s%8.1f\n", name, n / items }'
done
