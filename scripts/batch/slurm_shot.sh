#!/usr/bin/env bash
# One shot of an array job; scripts/batch/slurm.sh submits it.
# Usage: sbatch ... slurm_shot.sh BATCH_DIR LIST      (Slurm runs a copy, which knows no folder of its own)
#
# Slurm sends SIGUSR1 before the time limit: the tool is asked to stop, saves its state, and the job is queued
# again. SIGTERM (cancelled, or pushed aside by another job) stops the tool just so, but what to do then is
# up to whoever sent it.
set -uo pipefail
batch=$1
list=$2
name=$("$batch/shots.py" names "$list" | sed -n "${SLURM_ARRAY_TASK_ID}p")
progress=$(mktemp)
tool=
out_of_time=
signalled=

# shellcheck disable=SC2317  # called by traps
stop() {
  signalled=yes
  [ -z "$tool" ] || kill -TERM "$tool" 2>/dev/null
}
trap 'out_of_time=yes; stop' USR1
trap stop TERM
trap 'rm -f "$progress"' EXIT

echo "$name: run $((${SLURM_RESTART_COUNT:-0} + 1)) on $(hostname)"
"$batch/shots.py" paint "$list" "$name" --progress=json >"$progress" &
tool=$!
[ -z "$signalled" ] || stop # it came before the tool was there
while :; do
  signalled=
  wait "$tool"
  code=$?
  [ -n "$signalled" ] || break # else it is the signal that has ended the waiting
done
painted=$(wc -l <"$progress")
echo "$name: $painted frames painted, exit code $code"

terminated=143 # 128 + SIGTERM: the state is saved
if [ "$code" -eq "$terminated" ] && [ -n "$out_of_time" ]; then
  if [ "$painted" -eq 0 ]; then
    echo "$name: not one frame within the time limit; it needs a longer one (--time)"
    exit "$code"
  fi
  echo "$name: queued again"
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$code"
