#!/usr/bin/env bash
# Makes the picture of docs/looks.md: three looks of the same two frames, enlarged.
# Usage: scripts/render_looks.sh [PROGRAM]     (default: build/release/fluidymation)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
take_no_options "$@"
[ $# -le 1 ] || refuse "$# arguments; wanted at most PROGRAM"
program=${1:-build/release/fluidymation}
looks=(crisp standard calm)
for look in "${looks[@]}"; do
  "$program" --preset "$look" --src-path samples/source/rust/rgb --src-mask-path samples/source/rust/mask \
    --target-path samples/target-mask/jump/%05d.png --target-range 1-12 --blur-sigma 3 \
    --mask-threshold 0.45 --border-width 10 --out-path "output/looks/$look" --overwrite --quiet
done
/usr/bin/python3 - "${looks[@]}" <<'PYTHON'
import sys

from PIL import Image

FRAMES = (10, 11)
SIDE = 110  # of the square that is cut out, px
ENLARGED = 3
GAP = 6
PAPER = (244, 241, 232)

looks = sys.argv[1:]
first = Image.open(f"output/looks/{looks[0]}/{FRAMES[0]:05d}.png")
left, top, right, bottom = first.getchannel("A").getbbox()
x, y = (left + right - SIDE) // 2, (top + bottom - SIDE) // 2
side = SIDE * ENLARGED
sheet = Image.new("RGB", ((side + GAP) * len(looks) - GAP, (side + GAP) * len(FRAMES) - GAP), "white")
for column, look in enumerate(looks):
    for row, frame in enumerate(FRAMES):
        painted = Image.open(f"output/looks/{look}/{frame:05d}.png")
        paper = Image.new("RGB", painted.size, PAPER)
        paper.paste(painted, mask=painted.getchannel("A"))
        cut = paper.crop((x, y, x + SIDE, y + SIDE)).resize((side, side), Image.NEAREST)
        sheet.paste(cut, (column * (side + GAP), row * (side + GAP)))
sheet.save("docs/images/looks.png")
PYTHON
