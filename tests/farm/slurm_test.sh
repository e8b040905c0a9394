#!/usr/bin/env bash
# host/docs/farm/slurm_array.sh on a real SLURM: one node, one controller, munge, all in a folder of their own and without systemd.
#   slurm_test.sh TYNDALL TEMPLATE SCENE.XML
# An array of six; one task is killed with SIGKILL and requeued, one is told to end and comes back by its exit code 75. The merged image must be byte-equal to that of one run.
# Needs Debian's slurm-wlm and munge, and root. Exit code 77: not here.
set -euo pipefail
tyndall=$(realpath "$1") template=$(realpath "$2") scene=$(realpath "$3")
export PATH=$PATH:/usr/sbin TYNDALL=$tyndall

for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || { echo "skipped: $program is not installed (Debian: slurm-wlm munge)"; exit 77; }
done
[[ $(id -u) -eq 0 ]] || { echo "skipped: slurmd needs root"; exit 77; }

work=$(mktemp -d)
pids=()
finish() {
  local code=$?
  ((code == 0)) || tail -n 30 "$work"/*.log "$work"/out/*.log 2>/dev/null || true
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$work"
  exit $code
}
trap finish EXIT
say() { echo "$(date +%T) $*"; }

# A free port for each daemon, so that two tests can run side by side.
free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }

mkdir -p "$work"/{munge,state,spool,out}
chmod 755 "$work"
chmod 700 "$work/munge"
head -c 128 /dev/urandom >"$work/munge/key"
chmod 400 "$work/munge/key"
munged --force --foreground --key-file="$work/munge/key" --socket="$work/munge.socket" --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" \
  --log-file="$work/munged.log" >"$work/munged.out.log" 2>&1 &
pids+=($!)

host=$(hostname -s)
cat >"$work/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=1,requeue_delay=1
SelectType=select/cons_res
SelectTypeParameters=CR_CPU
RequeueExit=75
ReturnToService=2
SlurmctldTimeout=30
KillWait=5
MinJobAge=600
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
CONF
export SLURM_CONF=$work/slurm.conf
slurmctld -D -c -f "$SLURM_CONF" >"$work/slurmctld.out.log" 2>&1 &
pids+=($!)
slurmd -D -c -f "$SLURM_CONF" -N "$host" >"$work/slurmd.out.log" 2>&1 &
pids+=($!)

# until_true SECONDS COMMAND...
until_true() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    ((SECONDS < end)) || { say "gave up waiting for: $*"; return 1; }
    sleep .2
  done
}
node_is_up() { [[ $(sinfo -h -o %t) == idle* ]]; }
until_true 60 node_is_up
say "SLURM $(sinfo --version | cut -d' ' -f2) is up"

passes=1500 options=(--lights 16 --resolution 96x72)
export TYNDALL_CHECKPOINT=.5s
cd "$work/out"
job=$(sbatch --parsable --array=1-6 --cpus-per-task=1 "$template" "$scene" "$passes" "$work/out/shards" "${options[@]}")
say "array $job of six"

task_pid() { pgrep -f -- "$tyndall render .* --shard $1/6 " | head -n 1; }
has_checkpoint() { compgen -G "$work/out/shards/*.0000$1-of-6.shard.checkpoint"; }
state_of() { squeue -h -r -t all -j "${job}_$1" -o %T; }
restarts_of() { scontrol show job "${job}_$1" | grep -o 'Restarts=[0-9]*' | cut -d= -f2; }

until_true 120 has_checkpoint 1
until_true 60 has_checkpoint 2
kill -KILL "$(task_pid 1)"
say "task 1 killed with SIGKILL after a checkpoint"
kill -TERM "$(ps -o ppid= -p "$(task_pid 2)" | tr -d ' ')"  # its batch script, as slurmd does with --signal=B:TERM
say "task 2 told to end"
is_failed() { [[ $(state_of 1) == FAILED ]]; }
until_true 60 is_failed
say "task 1 is known to have failed"
scontrol requeue "${job}_1"
came_back() { [[ $(restarts_of 2) -ge 1 ]]; }
until_true 60 came_back

all_done() { ! squeue -h -r -j "$job" -t PENDING,RUNNING,COMPLETING,CONFIGURING,REQUEUE_HOLD,SPECIAL_EXIT -o %T | grep -q .; }
until_true 400 all_done
for task in 1 2 3 4 5 6; do
  [[ $(state_of $task) == COMPLETED ]] || { say "task $task ended as $(state_of $task)"; exit 1; }
done
say "restarts of task 1: $(restarts_of 1), of task 2: $(restarts_of 2), of task 3: $(restarts_of 3)"
[[ $(restarts_of 1) -ge 1 && $(restarts_of 2) -ge 1 && $(restarts_of 3) -eq 0 ]]
grep -q "going on from" "$work"/out/tyndall-"${job}"_1.log || { say "task 1 did not go on from its checkpoint"; exit 1; }

"$tyndall" merge shards/*.shard -o merged.exr --no-timestamps >/dev/null 2>&1
"$tyndall" render "$scene" --passes "$passes" "${options[@]}" --no-timestamps -o whole.exr --progress none >/dev/null
cmp merged.exr whole.exr
cmp merged.png whole.png
say "the merged image is byte-equal to that of one run"
