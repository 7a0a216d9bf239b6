#!/usr/bin/python3
"""Shows exemplar, target masks and painted frames side by side in one PNG.

Three rows, the same number of frames spread evenly over each sequence: the exemplar with its mask's
outline, the target's masks, and the painted frames over the exemplar's bare surface colour.

    contact_sheet.py --exemplar DIR --target DIR --painted DIR --out FILE.png [--columns N]

DIR of the exemplar holds rgb/ and mask/; the other two hold numbered PNG files.
"""

import argparse
import pathlib
import sys

import numpy as np
from PIL import Image, ImageFilter

OUTLINE_COLOUR = (230, 60, 40)
SHEET_COLOUR = (250, 250, 248)
GAP_PX = 8


def frames(folder):
    """PNG files of a folder in the order of their names; at least one."""
    found = sorted(pathlib.Path(folder).glob("*.png"))
    found = [path for path in found if not path.name.startswith(".")]
    if not found:
        sys.exit(f"contact_sheet.py: {folder}: no PNG files")
    return found


def spread(sequence, count):
    """`count` elements spread evenly over the sequence, first and last included."""
    return [sequence[round(i)] for i in np.linspace(0, len(sequence) - 1, count)]


def bare_surface(rgb_files, mask_files):
    """Median colour outside the mask of the first frame: the surface without paint."""
    rgb = np.asarray(Image.open(rgb_files[0]).convert("RGB"))
    mask = np.asarray(Image.open(mask_files[0]).convert("L"))
    outside = rgb[mask < 128]
    return tuple(int(c) for c in np.median(outside, axis=0)) if len(outside) else (255, 255, 255)


def outlined(rgb_file, mask_file):
    """An exemplar frame with the outline of its mask drawn in."""
    rgb = Image.open(rgb_file).convert("RGB")
    mask = Image.open(mask_file).convert("L").point(lambda v: 255 if v >= 128 else 0)
    inner = np.asarray(mask.filter(ImageFilter.MinFilter(3)))
    edge = (np.asarray(mask) > 0) & (inner == 0)
    pixels = np.array(rgb)
    pixels[edge] = OUTLINE_COLOUR
    return Image.fromarray(pixels)


def over(file, colour):
    """A painted frame composited over one colour."""
    painted = Image.open(file).convert("RGBA")
    base = Image.new("RGBA", painted.size, colour + (255,))
    return Image.alpha_composite(base, painted).convert("RGB")


def row(pictures, width):
    """Pictures scaled to one width, side by side."""
    scaled = [p.resize((width, max(1, round(p.height * width / p.width))), Image.LANCZOS)
              for p in pictures]
    strip = Image.new("RGB", ((width + GAP_PX) * len(scaled) - GAP_PX, scaled[0].height),
                      SHEET_COLOUR)
    for i, picture in enumerate(scaled):
        strip.paste(picture, (i * (width + GAP_PX), 0))
    return strip


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--exemplar", required=True)
    parser.add_argument("--target", required=True)
    parser.add_argument("--painted", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--columns", type=int, default=5)
    parser.add_argument("--width", type=int, default=360, help="of one picture, px")
    arguments = parser.parse_args()

    rgb = frames(pathlib.Path(arguments.exemplar) / "rgb")
    masks = frames(pathlib.Path(arguments.exemplar) / "mask")
    painted = frames(arguments.painted)
    by_name = {path.name: path for path in frames(arguments.target)}
    surface = bare_surface(rgb, masks)
    chosen = spread(painted, arguments.columns)
    rows = [
        row([outlined(a, b) for a, b in zip(spread(rgb, arguments.columns),
                                            spread(masks, arguments.columns))], arguments.width),
        row([Image.open(by_name[p.name]).convert("RGB") for p in chosen if p.name in by_name] or
            [over(p, surface) for p in chosen], arguments.width),
        row([over(p, surface) for p in chosen], arguments.width),
    ]
    sheet = Image.new("RGB", (max(r.width for r in rows) + 2 * GAP_PX,
                              sum(r.height + GAP_PX for r in rows) + GAP_PX), SHEET_COLOUR)
    y = GAP_PX
    for strip in rows:
        sheet.paste(strip, (GAP_PX, y))
        y += strip.height + GAP_PX
    sheet.save(arguments.out, optimize=True)


if __name__ == "__main__":
    main()
