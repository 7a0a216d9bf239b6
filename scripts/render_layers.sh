#!/usr/bin/env bash
# Makes the pictures of docs/layers.md: frames of samples/waving.toml, and one horse in several colours.
# Usage: scripts/render_layers.sh [PROGRAM]     (default: build/release/fluidymation)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
take_no_options "$@"
[ $# -le 1 ] || refuse "$# arguments; wanted at most PROGRAM"
program=${1:-build/release/fluidymation}
"$program" layers samples/waving.toml --overwrite --quiet
colors=(own c02020 208030 2030c0)
for medium in watercolour ink; do
  for color in "${colors[@]}"; do
    options=()
    [ "$color" = own ] || options=(--recolor "#$color")
    "$program" --src-path samples/source/$medium/rgb --src-mask-path samples/source/$medium/mask \
      --target-path samples/target-mask/horse --target-range 1-4 --target-scale 0.4 "${options[@]}" \
      --out-path "output/recolor/$medium-$color" --overwrite --quiet
  done
done
/usr/bin/python3 - "${colors[@]}" <<'PYTHON'
import sys

from PIL import Image

GAP = 6
PAPER = (244, 241, 232)
COLORS = 256  # of the palette: a third of the bytes

waving = [Image.open(f"output/waving/{number:05d}.png").convert("RGB") for number in (1, 5, 9)]
waving = [frame.crop((80, 60, 640, 700)).resize((280, 320), Image.LANCZOS) for frame in waving]
sheet = Image.new("RGB", ((280 + GAP) * len(waving) - GAP, 320), "white")
for column, frame in enumerate(waving):
    sheet.paste(frame, (column * (280 + GAP), 0))
sheet.quantize(COLORS).save("docs/images/layers.png", optimize=True)

rows = []
for medium in ("watercolour", "ink"):
    for color in sys.argv[1:]:
        painted = Image.open(f"output/recolor/{medium}-{color}/00004.png")
        paper = Image.new("RGB", painted.size, PAPER)
        paper.paste(painted, mask=painted.getchannel("A"))
        rows.append(paper.crop((40, 30, 380, 290)))
columns = len(sys.argv[1:])
width, height = rows[0].size
sheet = Image.new("RGB", (columns * width, 2 * height), PAPER)
for place, picture in enumerate(rows):
    sheet.paste(picture, (place % columns * width, place // columns * height))
sheet.quantize(COLORS).save("docs/images/recolor.png", optimize=True)
PYTHON
