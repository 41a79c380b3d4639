#!/bin/sh
# job_array.sh: one task of a cluster's job array: runs its part of a file of jobs.
#
#   sbatch --array=1-20 --cpus-per-task=8 job_array.sh JOBS FOLDER        (Slurm)
#   qsub -J 1-20 -v COUNT=20 -- job_array.sh JOBS FOLDER                  (PBS)
#   qsub -t 1-20 job_array.sh JOBS FOLDER                                 (Grid Engine)
#
# JOBS is a file for thud-run --jobs, FOLDER a folder that all machines see. Each task writes
# FOLDER/part-K.ndjson; a task that is started again after an interruption goes on where it was. When
# all have ended, `cat FOLDER/part-*.ndjson` has the results of all jobs. To submit single tasks of an
# array again, set COUNT to the number of all of its tasks: the cluster then tells that of the new
# array. THUD_RUN names the program where it is not on the path.
set -eu

if [ $# -ne 2 ]; then
    echo "job_array.sh: usage: job_array.sh JOBS FOLDER, as a task of a job array" >&2
    exit 2
fi
part=${SLURM_ARRAY_TASK_ID:-${PBS_ARRAY_INDEX:-${SGE_TASK_ID:-}}}
count=${COUNT:-${SLURM_ARRAY_TASK_COUNT:-${SGE_TASK_LAST:-}}}
if [ -z "$part" ] || [ -z "$count" ]; then
    echo "job_array.sh: no task of a job array: its number and the count of tasks are in none of" \
        "the variables of Slurm, PBS (with COUNT) or Grid Engine" >&2
    exit 2
fi
# As many jobs at a time as the task has processors: thud-run would take all of the machine's.
workers=${SLURM_CPUS_PER_TASK:-${NCPUS:-${NSLOTS:-1}}}
mkdir -p "$2"
exec "${THUD_RUN:-thud-run}" --jobs "$1" --part "$part/$count" --workers "$workers" \
    --out "$2/part-$part.ndjson" --resume
