#!/usr/bin/env bash
# Runs the tasks of a study as a Slurm array and collects them: slurm_array.sh STUDY.json [FOLDER]
#
# Submitted by hand it plans the study and submits itself twice: as an array, one element per TASKS_PER_JOB tasks, and as a
# job that collects when every element has succeeded. The folder of the study must be seen by all nodes.
# Options of `sbatch`, such as a partition or --cpus-per-task, go into SBATCH_OPTIONS.
set -euo pipefail

if [[ -n ${PERISTAT_STUDY:-} && -n ${SLURM_ARRAY_TASK_ID:-} ]]; then
    first=$(((SLURM_ARRAY_TASK_ID - 1) * TASKS_PER_JOB + 1))
    last=$((first + TASKS_PER_JOB - 1))
    for ((task = first; task <= last && task <= TASKS; task++)); do
        peristat study "$PERISTAT_STUDY" -o "$FOLDER" --task "$task" --threads "${SLURM_CPUS_PER_TASK:-1}" || failed=1
    done
    exit "${failed:-0}"
fi
if [[ -n ${PERISTAT_STUDY:-} ]]; then
    exec peristat study "$PERISTAT_STUDY" -o "$FOLDER" --collect
fi

PERISTAT_STUDY=${1:?usage: slurm_array.sh STUDY.json [FOLDER]}
name=$(basename "$PERISTAT_STUDY" .json)
FOLDER=${2:-results/${name%.study}}
TASKS_PER_JOB=${TASKS_PER_JOB:-1}
TASKS=$(peristat study "$PERISTAT_STUDY" -o "$FOLDER" --plan --json | python3 -c 'import json, sys; print(len(json.load(sys.stdin)["tasks"]))')
export PERISTAT_STUDY FOLDER TASKS TASKS_PER_JOB

read -ra options <<<"${SBATCH_OPTIONS:-}"
jobs=$(((TASKS + TASKS_PER_JOB - 1) / TASKS_PER_JOB))
array=$(sbatch --parsable --export=ALL --job-name=study --array="1-$jobs" "${options[@]}" "$0")
sbatch --export=ALL --job-name=collect --dependency="afterok:$array" "${options[@]}" "$0"
