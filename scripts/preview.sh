#!/usr/bin/env bash
# Makes an animated GIF of painted frames over a background, and an MP4 where ffmpeg is installed.
# Usage: scripts/preview.sh FRAMES_DIR OUT_STEM [BACKGROUND]
#   FRAMES_DIR   numbered PNG files of one size, shown at 12 frames/s
#   OUT_STEM     OUT_STEM.gif and OUT_STEM.mp4 are written
#   BACKGROUND   a colour, or a picture such as the film's bare surface (default: #F4F1E8)
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
source "$here/common.sh"
take_no_options "$@"
if [ $# -lt 2 ] || [ $# -gt 3 ]; then
  refuse "$# arguments; wanted FRAMES_DIR OUT_STEM and perhaps BACKGROUND"
fi
"$here/install_packages.sh" samples
exec "$here/preview.py" "$@"
