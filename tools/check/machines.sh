#!/usr/bin/env bash
# Cooks on many machines, as far as one can be many: shards, a cache on nginx and on servers that fail, Bazel in its sandbox,
# a Slurm cluster of one node with workers that are killed. tests/machines has the tests. Exit 1 if one fails, 3 if what an
# engine needs cannot be had.
# usage: tools/check/machines.sh MARROW [PART ...]      (the program; shards, cache, bazel, slurm)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
shift
for tool in nginx bazel slurmctld munged; do
  command -v "$tool" >/dev/null || { "$here/tools/install.sh" "$here/tools/packages/machines.txt" || true; break; }
done
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
python3 "$here/tests/machines/run.py" "$marrow" "$work" "$@"
