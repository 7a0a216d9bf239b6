#!/usr/bin/env bash
# Starts a Slurm of one node on this machine and paints a shot list with it: one shot is killed and queued again
# by hand, one is stopped as at its time limit and goes on by itself, one is left alone. All frames and manifests
# have to be, byte for byte, those of scripts/batch/local.sh.
# Usage: scripts/batch/test-slurm.sh [--time-limit] [TOOL]
#   --time-limit   wait for a real limit of a minute instead of sending its signal (some minutes)
#   TOOL           the program (default: build/dev/fluidymation)
# For root, in a container or a machine for tests: Slurm runs as root. Nothing is configured outside a temporary
# folder, and all daemons are ended, whatever happens.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source scripts/common.sh
real_limit=
if [ "${1:-}" = --time-limit ]; then
  real_limit=yes
  shift
fi
take_no_options "$@"
[ $# -le 1 ] || refuse "$# arguments; wanted at most TOOL"
FLUIDYMATION=$(realpath "${1:-build/dev/fluidymation}")
export FLUIDYMATION
[ -x "$FLUIDYMATION" ] || refuse "$FLUIDYMATION: no program; build it first, or name it"
[ "$(id -u)" -eq 0 ] || refuse "wanted root: munge and Slurm are started as root here"
scripts/install_packages.sh samples batch farm

work=$(mktemp -d)
chmod 755 "$work" # munge wants its socket's folder open to all
daemons=()
finish() {
  local code=$?
  trap - EXIT
  set +e
  if [ "$code" -ne 0 ]; then
    echo "test-slurm.sh: failed; what the logs say last:" >&2
    tail -n 20 "$work"/*.log "$work"/*.out "$work"/shots/slurm-logs/*.log >&2 2>/dev/null
  fi
  if [ -e "$work/slurmctld.pid" ]; then # no job is left when all went well
    timeout 10 scancel --quiet --user=root 2>/dev/null
    for ((tenth = 0; tenth < 100; tenth++)); do
      [ -n "$(processes_of_jobs)" ] || break
      sleep 0.1
    done
    # shellcheck disable=SC2046  # one number a word
    kill -KILL $(processes_of_jobs) 2>/dev/null
  fi
  # In the reverse order of their start; munge answers for the other two.
  for ((i = ${#daemons[@]} - 1; i >= 0; i--)); do
    kill -TERM "${daemons[i]}" 2>/dev/null
    for ((tenth = 0; tenth < 50; tenth++)); do
      kill -0 "${daemons[i]}" 2>/dev/null || break
      sleep 0.1
    done
    kill -KILL "${daemons[i]}" 2>/dev/null
  done
  rm -rf "$work"
  exit "$code"
}
# Of this Slurm: its watchers, the scripts of jobs, and the tools they have started.
processes_of_jobs() {
  local pid
  for pid in $(pgrep -f '^slurmstepd|/slurm_script|/fluidymation '); do
    ! grep -qazxF "SLURM_CONF=$work/slurm.conf" "/proc/$pid/environ" 2>/dev/null || echo "$pid"
  done
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

fail() {
  echo "test-slurm.sh: $*" >&2
  exit 1
}

await() { # SECONDS WHAT COMMAND...
  local tenths=$(($1 * 10)) what=$2
  shift 2
  for ((tenth = 0; tenth < tenths; tenth++)); do
    ! "$@" >/dev/null 2>&1 || return 0
    sleep 0.1
  done
  fail "not within $((tenths / 10)) s: $what"
}

free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

start_slurm() {
  dd if=/dev/urandom of="$work/munge.key" bs=1024 count=1 status=none
  chmod 400 "$work/munge.key"
  mkdir "$work/state" "$work/spool"
  # cred_expire: a job that is queued again waits until its old credential has expired; 5 s is the
  # least, 2 minutes the default. sched_interval: and then for the scheduler, by default once a minute.
  cat >"$work/slurm.conf" <<EOF
ClusterName=fluidymation-test
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$work/munge.socket,cred_expire=5
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
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2
MpiDefault=none
MailProg=/bin/true
ReturnToService=2
NodeName=localhost NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1024 State=UNKNOWN
PartitionName=test Nodes=localhost Default=YES MaxTime=INFINITE State=UP
EOF
  export SLURM_CONF=$work/slurm.conf
  munged --foreground --socket="$work/munge.socket" --key-file="$work/munge.key" \
    --pid-file="$work/munged.pid" --seed-file="$work/munge.seed" --log-file="$work/munged.log" 2>/dev/null &
  daemons+=($!)
  await 10 "munge answers" munge --no-input --socket="$work/munge.socket"
  slurmctld -D >"$work/slurmctld.out" 2>&1 &
  daemons+=($!)
  slurmd -D -N localhost >"$work/slurmd.out" 2>&1 &
  daemons+=($!)
  await 30 "the node is idle" node_is_idle
}
node_is_idle() { [ "$(sinfo --noheader --format=%t)" = idle ]; }

# Three shots of a few small frames, slow enough to be met at work.
write_list() { # FOLDER
  mkdir -p "$1"
  ln -s "$PWD/samples" "$1/samples"
  local name frames=6 slow='--target-scale 0.5 --opt-iterations 300'
  # Of a minute Slurm leaves half or less, so that frames have to be short.
  [ -z "$real_limit" ] || { frames=24; slow='--target-scale 0.7 --opt-iterations 200'; }
  {
    printf 'name\tsrc-path\tsrc-mask-path\tsrc-frames\ttarget-path\ttarget-frames\tout-path\toptions\n'
    for name in killed stopped quiet; do
      printf '%s\tsamples/source/rust/rgb/%%05d.png\tsamples/source/rust/mask/%%05d.png\t8\t' "$name"
      printf 'samples/target-mask/jump/%%05d.png\t%d\t%s/frames/%%05d.png\t' "$frames" "$name"
      printf -- '--checkpoint-every 1 %s\n' "$slow"
    done
  } >"$1/shots.tsv"
}

frames_of() { find "$work/shots/$1/frames" -name '0*.png' 2>/dev/null | wc -l; }
has_frames() { [ "$(frames_of "$1")" -ge 2 ]; }
tool_of() { # SHOT: its process
  local pid
  for pid in $(pgrep -x fluidymation); do
    [ "$(readlink "/proc/$pid/cwd")" = "$work/shots" ] || continue
    ! grep -qazF -- "--out-path=$1/" "/proc/$pid/cmdline" || echo "$pid"
  done
}
state_of() { squeue --noheader --array --format=%T --jobs="$1" 2>/dev/null; }
failed() { [ "$(scontrol --oneliner show job "$1" | grep -o 'JobState=[A-Z]*')" = JobState=FAILED ]; }
ended() { [ -z "$(state_of "$1")" ]; }

write_list "$work/shots"
write_list "$work/local"
start_slurm

limit=()
[ -z "$real_limit" ] || limit=(--time=1)
said=$(scripts/batch/slurm.sh "$work/shots/shots.tsv" --cpus-per-task=1 "${limit[@]}")
echo "$said"
painting=$(sed -n 's/^painting: job \([0-9]*\),.*/\1/p' <<<"$said")
following=$(sed -n 's/.*then job \([0-9]*\) checks.*/\1/p' <<<"$said")

await 60 "two frames of the shot to be killed" has_frames killed
pid=$(tool_of killed)
[ -n "$pid" ] || fail "the shot to be killed is not at work any more"
kill -KILL "$pid"
await 20 "the killed shot has failed" failed "${painting}_1"
echo "killed after $(frames_of killed) frames; queued again"
scontrol requeue "${painting}_1"

if [ -z "$real_limit" ]; then
  await 60 "two frames of the shot to be stopped" has_frames stopped
  [ -n "$(tool_of stopped)" ] || fail "the shot to be stopped is not at work any more"
  scancel --batch --signal=USR1 "${painting}_2"
fi

await 400 "all shots are painted" ended "$painting"
await 60 "the job that follows has ended" ended "$following"

logs=$work/shots/slurm-logs
grep -h . "$logs"/*.log | grep -vE '^fluidymation: note' | sed 's/^/  /'
grep -q '^stopped: queued again' "$logs"/*_2.log || fail "the stopped shot was not queued again"
grep -q '^stopped: run 2 ' "$logs"/*_2.log || fail "the stopped shot was not begun again"
grep -q '^killed: run 2 ' "$logs"/*_1.log || fail "the killed shot was not begun again"
grep -q '^3 of 3 shots are painted' "$logs"/*check*.log || fail "the job that follows does not say that all is well"
for shot in killed stopped; do
  sum=$(sed -n "s/^$shot: \([0-9]*\) frames painted.*/\1/p" "$logs"/*.log | paste -sd +)
  echo "$shot: painted in parts of $sum frames"
done
for shot in killed stopped quiet; do
  [ -s "$work/shots/$shot/$shot-preview.gif" ] || fail "$shot: no preview"
done

echo "the same shots without Slurm:"
scripts/batch/local.sh --no-previews "$work/local/shots.tsv" 2>&1 | tail -n 1
for shot in killed stopped quiet; do
  diff -r "$work/shots/$shot/frames" "$work/local/$shot/frames" --exclude=.fluidymation ||
    fail "$shot: not the bytes of a local run"
done
echo "all $(find "$work/local" -name '0*.png' | wc -l) frames and 3 manifests are, byte for byte, those of local runs"
