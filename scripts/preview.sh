#!/usr/bin/env bash
# Makes an MP4 and an animated GIF of painted frames over one colour, if ffmpeg is there.
# Usage: scripts/preview.sh FRAMES_DIR OUT_STEM [COLOUR]   (frames %05d.png from 1; 12 frames/s)
set -euo pipefail
[ $# -ge 2 ] || { sed -n '2,3s/^# //p' "$0" >&2; exit 2; }
frames=$1 stem=$2 colour=${3:-0xF4F1E8}
if ! command -v ffmpeg >/dev/null; then
  echo "ffmpeg is not installed: no MP4 and no animated preview"
  exit 0
fi
size=$(ffprobe -v error -select_streams v -show_entries stream=width,height -of csv=p=0:s=x \
  "$frames/00001.png")
input=(-v error -y -f lavfi -i "color=$colour:s=$size:r=12" -framerate 12 -i "$frames/%05d.png")
ffmpeg "${input[@]}" -filter_complex '[0][1]overlay=shortest=1,pad=ceil(iw/2)*2:ceil(ih/2)*2' \
  -pix_fmt yuv420p "$stem.mp4"
ffmpeg "${input[@]}" -filter_complex \
  '[0][1]overlay=shortest=1,scale=480:-1,split[a][b];[a]palettegen[p];[b][p]paletteuse' "$stem.gif"
echo "$stem.mp4"
echo "$stem.gif"
