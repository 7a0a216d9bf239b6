#!/usr/bin/python3
"""Shows what variants make of one pair: a labelled row of frames for each, over the bare surface.

    variants_sheet.py --painted DIR --pair NAME --variants VARIANTS.tsv --exemplar DIR
                      --out FILE.png [--columns N] [--width PX]

DIR/<variant>/NAME holds the painted frames, as measure.py leaves them.
"""

import argparse
import pathlib
import sys

from PIL import Image, ImageDraw

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import contact_sheet  # noqa: E402  (a neighbour, not an installed module)
import measure  # noqa: E402

LABEL_HEIGHT_PX = 16


def labelled(strip, label):
    """A row of pictures with its name above."""
    picture = Image.new("RGB", (strip.width, strip.height + LABEL_HEIGHT_PX),
                        contact_sheet.SHEET_COLOUR)
    ImageDraw.Draw(picture).text((2, 2), label, fill=(40, 40, 40))
    picture.paste(strip, (0, LABEL_HEIGHT_PX))
    return picture


def main():
    """Reads the command line and writes the sheet."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--painted", required=True, type=pathlib.Path)
    parser.add_argument("--pair", required=True)
    parser.add_argument("--variants", required=True)
    parser.add_argument("--exemplar", required=True, type=pathlib.Path)
    parser.add_argument("--out", required=True)
    parser.add_argument("--columns", type=int, default=3)
    parser.add_argument("--width", type=int, default=300, help="of one picture, px")
    arguments = parser.parse_args()

    surface = contact_sheet.bare_surface(contact_sheet.frames(arguments.exemplar / "rgb"),
                                         contact_sheet.frames(arguments.exemplar / "mask"))
    rows = []
    for variant in measure.lines(arguments.variants, ["name", "options", "program"]):
        painted = contact_sheet.frames(arguments.painted / variant["name"] / arguments.pair)
        chosen = contact_sheet.spread(painted, arguments.columns)
        pictures = [contact_sheet.over(file, surface) for file in chosen]
        rows.append(labelled(contact_sheet.row(pictures, arguments.width), variant["name"]))
    sheet = Image.new("RGB", (max(r.width for r in rows), sum(r.height for r in rows)),
                      contact_sheet.SHEET_COLOUR)
    y = 0
    for picture in rows:
        sheet.paste(picture, (0, y))
        y += picture.height
    sheet.save(arguments.out, optimize=True)


if __name__ == "__main__":
    main()
