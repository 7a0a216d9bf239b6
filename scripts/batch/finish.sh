#!/usr/bin/env bash
# Checks the painted frames of all shots of a list against their manifests, and makes previews.
# Usage: scripts/batch/finish.sh [--previews] LIST
#   --previews   also write FRAMES/../NAME-preview.gif (and .mp4 where ffmpeg is installed) of each
#                shot that is whole; FRAMES is the folder of its frames
# The exit code is 1 if a shot is unfinished, or a frame is missing, changed or extra.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../common.sh"

previews=
if [ "${1:-}" = --previews ]; then
  previews=yes
  shift
fi
take_no_options "$@"
[ $# -eq 1 ] || refuse "$# arguments; wanted LIST (see --help)"
list=$1

names=$("$here/shots.py" names "$list")
bad=0
while IFS= read -r name; do
  if ! "$here/shots.py" check "$list" "$name" </dev/null; then
    echo "$name: not as it should be, see above" >&2
    bad=$((bad + 1))
    continue
  fi
  [ -n "$previews" ] || continue
  frames=$("$here/shots.py" frames "$list" "$name")
  "$here/../preview.sh" "$frames" "$(dirname "$frames")/$name-preview" </dev/null || bad=$((bad + 1))
done <<<"$names"
echo "$(($(wc -l <<<"$names") - bad)) of $(wc -l <<<"$names") shots are painted and as they should be"
exit $((bad > 0))
