#!/usr/bin/env bash
# Paints all shots of a list on a Slurm cluster: an array of jobs, one a shot, and one that follows, checks
# the frames and makes previews. Prints the two job numbers.
# Usage: scripts/batch/slurm.sh LIST [SBATCH-OPTION...]
#   LIST            a shot list (see scripts/batch/shots.py --help), where all nodes see it
#   SBATCH-OPTION   for the painting jobs: --partition=cpu --time=02:00:00 --cpus-per-task=8 --mem=4G ...
# A shot that meets its time limit, or whose node fails, is queued again and goes on from its last state.
# Given again, the same command paints what is still missing.
# Logs go to the folder slurm-logs beside LIST.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../common.sh"
take_no_options "$@"
[ $# -ge 1 ] || refuse "no arguments; wanted LIST (see --help)"
list=$(realpath "$1")
shift
command -v sbatch >/dev/null || refuse "no sbatch here; wanted a machine that submits to Slurm"

names=$("$here/shots.py" names "$list")
count=$(wc -l <<<"$names")
logs=$(dirname "$list")/slurm-logs
mkdir -p "$logs"

# The signal comes up to a minute earlier than said, and saving takes seconds.
seconds_before_limit=60
painting=$(sbatch --parsable --job-name="$(basename "$list" .tsv)" --array="1-$count" --requeue \
  --open-mode=append --output="$logs/%x-%A_%a.log" --signal="B:USR1@$seconds_before_limit" \
  "$@" "$here/slurm_shot.sh" "$here" "$list")
painting=${painting%%;*} # a cluster's name may follow
# afterany: shots that failed are to be named, and the others to be seen.
following=$(sbatch --parsable --job-name="$(basename "$list" .tsv)-check" \
  --dependency="afterany:$painting" --output="$logs/%x-%j.log" "$here/slurm_finish.sh" "$here" "$list")
echo "painting: job $painting, $count shots; then job ${following%%;*} checks them; logs in $logs"
