#!/usr/bin/env bash
# Cooks on a Slurm cluster: an array of shards with the time and memory of the plan, shards with failures once more, and a
# merged report. Prints the number of the last job, which ends when all has.
# usage: tools/farm/slurm.sh SHARDS FOLDER [MARROW COOK'S ARGUMENTS ...]
#
#   tools/farm/slurm.sh 64 farm chars/ props/ -o build/ --cache http://cache.local/marrow
#
# FOLDER gets plan.json, a report of each shard, what they say, and report.html and report.json of all; the report.json that
# is there already tells how long files take, and what has grown. Folders are shared by all nodes, by the same paths.
# MARROW: the program, if not the one in PATH. MARROW_JOBS: threads of a shard, 1. SBATCH_PARTITION and the like count.
set -euo pipefail
[ $# -ge 3 ] || { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "$0" >&2; exit 1; }
shards=$1
folder=$2
shift 2
marrow=$(command -v "${MARROW:-marrow}") || { echo "slurm: there is no ${MARROW:-marrow}" >&2; exit 1; }
jobs=${MARROW_JOBS:-1}
mkdir -p "$folder"
folder=$(realpath "$folder")
rm -f "$folder"/shard-*.json

before=()
if [ -f "$folder/report.json" ]; then
  mv "$folder/report.json" "$folder/before.json"
  before=(--history "$folder/before.json")
fi
"$marrow" cook "$@" "${before[@]}" --plan "$folder/plan.json" >&2
# What the plan expects of one shard, three times as long and half as much memory again.
read -r program minutes megabytes < <(python3 - "$folder/plan.json" "$shards" "$jobs" <<'END'
import json, math, sys
plan, shards, jobs = json.load(open(sys.argv[1])), int(sys.argv[2]), int(sys.argv[3])
seconds = max(plan['seconds'] / shards, plan['longest_s']) * 3
print(plan['program'], 2 + math.ceil(seconds / 60), math.ceil(1.5 * jobs * plan['memory_bytes'] / 1e6))
END
)

# The number of a job is that of its script, which gives a shard's number to the command.
cat >"$folder/shard.sh" <<END
#!/usr/bin/env bash
cd $(printf %q "$PWD")
report=$(printf %q "$folder")/shard-\$SLURM_ARRAY_TASK_ID.json
if [ "\${1:-}" = again ] && [ -f "\$report" ] && ! grep -q '"error": {' "\$report"; then exit 0; fi
exec $(printf '%q ' "$marrow" cook "$@" "${before[@]}" --jobs "$jobs" --program "$program") \\
  --shard "\$SLURM_ARRAY_TASK_ID/$shards" --report "\$report"
END
cat >"$folder/merge.sh" <<END
#!/usr/bin/env bash
cd $(printf %q "$folder")
$(printf %q "$marrow") report --merge shard-*.json -o report.json $([ ${#before[@]} -eq 0 ] || echo --since before.json)
exec $(printf %q "$marrow") report --merge shard-*.json -o report.html $([ ${#before[@]} -eq 0 ] || echo --since before.json)
END
chmod +x "$folder/shard.sh" "$folder/merge.sh"

array=(--parsable --array="1-$shards" --cpus-per-task="$jobs" --time="$minutes" --mem="${megabytes}M" --requeue)
first=$(sbatch "${array[@]}" --job-name=marrow --output="$folder/shard-%a.txt" "$folder/shard.sh")
again=$(sbatch "${array[@]}" --job-name=marrow-again --output="$folder/again-%a.txt" --dependency="afterany:$first" \
  "$folder/shard.sh" again)
sbatch --parsable --job-name=marrow-report --output="$folder/merge.txt" --dependency="afterany:$again" --mem=1G --time=10 \
  "$folder/merge.sh"
