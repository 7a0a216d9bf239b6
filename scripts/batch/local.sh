#!/usr/bin/env bash
# Paints all shots of a list on this machine, several at a time, then checks them and makes previews.
# Usage: scripts/batch/local.sh [--jobs N] [--no-previews] LIST
#   LIST   a shot list: see scripts/batch/shots.py --help
#   N      shots at a time (default: as many as there are processors, at most one a shot); each gets its
#          share of the processors, and needs memory of its own
# Ctrl-C stops all, with their states saved; the same command goes on.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../common.sh"

jobs=
previews=(--previews)
while [[ ${1:-} == -* ]]; do
  case $1 in
    --jobs)
      [[ ${2:-} =~ ^[1-9][0-9]{0,3}$ ]] || refuse "--jobs ${2:-}: wanted a number from 1 to 9999"
      jobs=$2
      shift
      ;;
    --no-previews) previews=() ;;
    *) take_no_options "$1" ;;
  esac
  shift
done
[ $# -eq 1 ] || refuse "$# arguments; wanted LIST (see --help)"
list=$1

"$here/../install_packages.sh" batch
names=$("$here/shots.py" names "$list")
count=$(wc -l <<<"$names")
processors=$(nproc)
: "${jobs:=$((count < processors ? count : processors))}"
threads=$((processors / jobs))
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-$((threads > 0 ? threads : 1))}
# Waiting threads sleep: there are other shots to paint.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}

# The tool needs about a second to save its state; a second SIGTERM would end it at once.
save_time_ms=20000
trap 'echo "interrupted, with all states saved: the same command goes on" >&2; exit 130' INT
failed=0
parallel --jobs "$jobs" --line-buffer --tag --termseq "TERM,$save_time_ms,KILL,100" \
  "$here/shots.py" paint "$list" {} <<<"$names" || failed=$?
bad=0
"$here/finish.sh" "${previews[@]}" "$list" || bad=1
if [ "$failed" -gt 0 ]; then
  echo "$failed of $count shots were not painted now, as told above; frames that are there are of an earlier run" >&2
fi
exit $((failed + bad > 0))
