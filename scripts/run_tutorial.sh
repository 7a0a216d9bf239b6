#!/usr/bin/env bash
# Runs the commands of docs/tutorial.md as they stand there, from an empty output/tutorial on; any failure ends it.
# Needs build/release/fluidymation and ffmpeg. Then makes the tutorial's picture, with --picture.
# Usage: scripts/run_tutorial.sh [--picture]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
picture=no
if [ "${1:-}" = --picture ]; then
  picture=yes
  shift
fi
take_no_options "$@"
[ $# -eq 0 ] || refuse "$1: no such argument; see --help"
[ -x build/release/fluidymation ] || refuse "build/release/fluidymation is not there; cmake --build --preset release"
command -v ffmpeg >/dev/null || refuse "the tutorial needs ffmpeg (Debian: apt install ffmpeg)"
rm -rf output/tutorial
# Indented lines are commands; what they print stands in fenced blocks.
commands=$(sed -n 's/^    //p' docs/tutorial.md)
[ -n "$commands" ] || refuse "docs/tutorial.md holds no commands"
bash -euo pipefail -c "$commands"
[ $picture = yes ] || exit 0
/usr/bin/python3 - <<'PYTHON'
from PIL import Image, ImageFilter

COLUMNS = 6
WIDTH = 180  # of one picture, px
GAP = 6
FILM = (7, 10, 14, 19, 24, 30)
PAINTED = (1, 5, 9, 13, 17, 21)
OUTLINE = (230, 60, 40)
COLORS = 128  # of the palette
FOLDER = "output/tutorial"


def outlined(number):
    rgb = Image.open(f"{FOLDER}/film/rgb/{number:05d}.png").convert("RGB")
    mask = Image.open(f"{FOLDER}/film/mask/{number:05d}.png").convert("L")
    rim = Image.composite(Image.new("L", mask.size, 0), mask, mask.filter(ImageFilter.MinFilter(3)))
    rgb.paste(OUTLINE, mask=rim)
    return rgb


rows = [[outlined(number) for number in FILM],
        [Image.open(f"{FOLDER}/on-paper/{number:05d}.png").convert("RGB") for number in PAINTED]]
rows = [[p.resize((WIDTH, round(WIDTH * p.height / p.width)), Image.LANCZOS) for p in row] for row in rows]
sheet = Image.new("RGB", ((WIDTH + GAP) * COLUMNS - GAP, rows[0][0].height + GAP + rows[1][0].height), "white")
for row, top in zip(rows, (0, rows[0][0].height + GAP)):
    for column, shown in enumerate(row):
        sheet.paste(shown, (column * (WIDTH + GAP), top))
sheet.quantize(COLORS).save("docs/images/tutorial.png", optimize=True)
PYTHON
