#!/usr/bin/env bash
# A render as a SLURM job array: one task per shard, requeued where it left off.
#
#   sbatch --array=1-16 --cpus-per-task=8 slurm_array.sh scene.xml 1024 shards [options of tyndall render]
#   tyndall merge shards/*.shard -o scene.exr
#
# Arguments: scene, passes in all, folder for the shards (it is made). The array must start at 1. TYNDALL names the program, if it is not on the PATH.
#
# A task that is told to end (time limit, preemption, scancel --signal) saves a checkpoint beside its shard and exits with 75, which asks for another try: with
# `RequeueExit=75` in slurm.conf SLURM requeues it by itself, otherwise `scontrol requeue JOB_TASK` does. Either way it goes on from the checkpoint. After the death of a node or
# SIGKILL it goes on from the last one that was written, at most some 30 seconds before.
#SBATCH --job-name=tyndall
#SBATCH --requeue
#SBATCH --signal=B:TERM@60
#SBATCH --open-mode=append
#SBATCH --output=tyndall-%A_%a.log
set -u
if (($# < 3)) || [[ -z ${SLURM_ARRAY_TASK_ID:-} ]]; then
  echo "usage: sbatch --array=1-N slurm_array.sh SCENE.XML PASSES FOLDER [options of tyndall render]" >&2
  exit 2
fi
scene=$1 passes=$2 folder=$3
shift 3

shards=$SLURM_ARRAY_TASK_MAX
shard=$folder/$(basename "$scene" .xml).$(printf '%05d' "$SLURM_ARRAY_TASK_ID")-of-$shards.shard
mkdir -p "$folder" || exit 6
if [[ -s $shard ]]; then
  echo "$shard is there already"
  exit 0
fi

# A CPU device has threads of its own beside --threads; PoCL's are as many as the machine has cores unless told otherwise.
export POCL_MAX_PTHREAD_COUNT=${POCL_MAX_PTHREAD_COUNT:-${SLURM_CPUS_PER_TASK:-1}}

"${TYNDALL:-tyndall}" render "$scene" --passes "$passes" --shard "$SLURM_ARRAY_TASK_ID/$shards" -o "$shard" \
  --threads "${SLURM_CPUS_PER_TASK:-1}" --resume --progress plain "$@" &
render=$!
trap 'kill -TERM $render 2>/dev/null' TERM HUP
wait $render
code=$?
while kill -0 $render 2>/dev/null; do # `wait` returns when a signal comes; the render is still writing then
  wait $render
  code=$?
done
case $code in
  129 | 143) exit 75 ;;
  *) exit $code ;;
esac
