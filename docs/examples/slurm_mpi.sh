#!/usr/bin/env bash
# Solves one case by all tasks of a Slurm allocation: sbatch --ntasks=16 slurm_mpi.sh CASE.json [OPTIONS OF peristat run]
#
# peristat must be built with the feature `petsc`, and the folder of the case must be seen by all nodes.
#SBATCH --job-name=peristat
#SBATCH --cpus-per-task=1
set -euo pipefail

: "${1:?usage: slurm_mpi.sh CASE.json [OPTIONS]}"
exec mpirun -n "${SLURM_NTASKS:-1}" peristat --threads "${SLURM_CPUS_PER_TASK:-1}" run "$@"
