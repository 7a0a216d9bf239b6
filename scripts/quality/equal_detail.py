#!/usr/bin/python3
"""Judges two variants of `measure.py` at equal detail: blur flatters patch fidelity and flicker.

    equal_detail.py --judge quality.py --pairs PAIRS.tsv [--data DIR] --out DIR [--pair NAME ...] A B

The folder of --out is what measure.py has written, with the same judge, and A and B are two of its variants, B
the one with more detail. The frames of B are blurred until their detail is that of A: with a Gaussian inside,
another at the rim, each of the width, px, at which that row comes out equal, passing over from one to the other
round the judge's border. Where B has no more detail than A, it stays as it is. Then they are judged once more, as
measure.py had them judged. Frames and figures are in the folder equal-detail/B-as-A of --out; the rows that blur
flatters are printed as A, B and B blurred. A width with "?" is one at which the details are not equal.

The judge's rows have to be detail_interior, detail_border, fidelity_interior, fidelity_border, flicker_static and
flicker_moving, and its JSON has to tell the border's width, px, as details.border_px. Needs python3-numpy and
python3-opencv.
"""

import argparse
import json
import pathlib
import shlex
import shutil
import sys

import cv2
import numpy as np

import measure

DETAIL = ("detail_interior", "detail_border")  # rows of the judge, inside and at the rim
FLATTERED = ("fidelity_interior", "fidelity_border", "flicker_static", "flicker_moving")
ROUNDS = 6  # of the search for both widths, each a run of the judge; two or three do mostly
CLOSE = 0.015  # of the detail: half of what means nothing (docs/quality.md)
# px: less hardly shows in 8 bits, more is no longer the same picture; in one step, so that a bad guess is mended
LEAST_PX, LARGEST_PX, LARGEST_STEP_PX = 0.3, 2.5, 0.6
FIRST_PX_PER_DETAIL = 1.2  # the first guess: a width of so much for each unit of detail too many
PASSAGE_PX = 4.0  # from the rim's width to the interior's


def blurred(image, width):
    """An RGBA picture whose colours are blurred within what is painted; its alpha stays."""
    if width <= 0.0:
        return image[..., :3].astype(np.float32)
    weight = image[..., 3:].astype(np.float32) / 255.0
    both = np.concatenate([image[..., :3] * weight, weight], axis=2)
    both = cv2.GaussianBlur(both, (0, 0), width, borderType=cv2.BORDER_REPLICATE)
    return both[..., :3] / np.maximum(both[..., 3:], 1e-6)


def blur_frame(path, out, widths, border):
    """Writes a frame whose interior and rim, up to `border` px deep, are blurred by these widths."""
    inside, rim = widths
    image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    if image is None or image.ndim != 3 or image.shape[2] != 4 or image.dtype != np.uint8:
        sys.exit(f"equal_detail.py: {path}: wanted an RGBA picture of 8 bits")
    depth = cv2.distanceTransform((image[..., 3] > 127).astype(np.uint8), cv2.DIST_L2, 5)
    share = np.clip((depth - border) / PASSAGE_PX + 0.5, 0.0, 1.0)[..., None]
    color = share * blurred(image, inside) + (1.0 - share) * blurred(image, rim)
    painted = np.where(image[..., 3:] > 0, np.clip(color + 0.5, 0, 255), image[..., :3])
    result = np.concatenate([painted.astype(np.uint8), image[..., 3:]], axis=2)
    if not cv2.imwrite(str(out / path.name), result):
        sys.exit(f"equal_detail.py: {out / path.name}: cannot be written")


def loaded(path):
    """A JSON file that measure.py has left."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as fault:
        sys.exit(f"equal_detail.py: {path}: {fault}; wanted what measure.py has written with this --out")


def how_judged(folder):
    """What measure.py notes of a variant's judging: the judge's digest, and the options that smooth its masks."""
    try:
        _, judge, _, smoothed, *_ = (folder / "command").read_text(encoding="utf-8").split("\n")
    except (OSError, ValueError) as fault:
        sys.exit(f"equal_detail.py: {folder / 'command'}: {fault}; wanted what measure.py has written")
    return judge, shlex.split(smoothed)


def value(figures, row, path):
    """A row's value, which is None where the inputs do not show it."""
    if row not in figures:
        sys.exit(f"equal_detail.py: {path}: has no row {row}; wanted a judge that has it")
    return figures[row][1]


def judged(arguments, pair, smoothed, frames, border, out, widths):
    """The judge's rows of these frames, blurred by `widths` into `out`."""
    for path in frames:
        blur_frame(path, out, widths, border)
    result = out / "judged.json"
    measure.run(
        measure.judge_command(arguments.judge, pair, smoothed, len(frames), out, result)
    )
    return measure.figures_of(result)


def next_width(width, excess, last):
    """The width at which a line through the last two points, or the first and a guess, has no detail too many.

    `last` has the width and the excess of the round before, or is None."""
    if last is None or last[0] == width or last[1] == excess:
        proposed = width + FIRST_PX_PER_DETAIL * excess
    else:
        proposed = width - excess * (width - last[0]) / (excess - last[1])
    proposed = min(proposed, width + LARGEST_STEP_PX, LARGEST_PX)
    return max(proposed, LEAST_PX)


def equalized(arguments, pair):
    """Rows of A, of B and of B blurred; the widths, and whether each makes its row equal."""
    folders = [arguments.out / name / pair["name"] for name in (arguments.blurred, arguments.sharp)]
    before, after = (loaded(folder / "figures.json") for folder in folders)
    kept = [how_judged(folder) for folder in folders]
    if kept[0] != kept[1] or kept[0][0] != measure.digest(arguments.judge):
        sys.exit(f"equal_detail.py: {folders[1]}: judged otherwise; wanted both by --judge, with the same masks")
    smoothed = kept[1][1]
    border = loaded(folders[1] / "judged.json")["details"]["border_px"]
    frames = sorted(folders[1].glob("*.png"))
    if not frames:
        sys.exit(f"equal_detail.py: {folders[1]}: holds no PNG file; wanted painted frames")
    out = arguments.out / "equal-detail" / f"{arguments.sharp}-as-{arguments.blurred}" / pair["name"]
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)

    def excess(figures, i):
        values = [value(figures, DETAIL[i], folders[0]), value(before, DETAIL[i], folders[0])]
        return 0.0 if None in values else values[0] - values[1]

    rows, widths, last = after, [0.0, 0.0], [None, None]
    for _ in range(ROUNDS):
        # A row that has too little without any blur stays
        wrong = [i for i in range(2) if abs(excess(rows, i)) > CLOSE and (widths[i] > 0 or excess(rows, i) > 0)]
        if not wrong:
            break
        for i in wrong:
            width = next_width(widths[i], excess(rows, i), last[i])
            last[i] = (widths[i], excess(rows, i))
            widths[i] = width
        rows = judged(arguments, pair, smoothed, frames, border, out, widths)
    (out / "figures.json").write_text(json.dumps(rows), encoding="utf-8")
    return (before, after, rows), widths, [abs(excess(rows, i)) <= CLOSE for i in range(2)]


def main():
    """Reads the command line and prints a Markdown table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--judge", required=True)
    parser.add_argument("--pairs", required=True)
    parser.add_argument("--data", default="")
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--pair", action="append", help="only this pair; may be repeated")
    parser.add_argument("blurred", metavar="A")
    parser.add_argument("sharp", metavar="B")
    arguments = parser.parse_args()
    print("| pair | blur inside, at the rim, px | " + " | ".join((*DETAIL, *FLATTERED)) + " |")
    print("|---" * (2 + len(DETAIL) + len(FLATTERED)) + "|")
    pairs = measure.lines(arguments.pairs, ["name", "exemplar", "target", "start", "blur", "options"])
    for pair in pairs:
        if arguments.pair and pair["name"] not in arguments.pair:
            continue
        for key in ("exemplar", "target"):
            pair[key] = pair[key].replace("{data}", arguments.data)
        try:
            columns, widths, are_equal = equalized(arguments, pair)
        except RuntimeError as failure:
            sys.exit(f"equal_detail.py: failed: {failure}")
        cells = [", ".join(f"{w:.2f}" + ("" if equal else "?") for w, equal in zip(widths, are_equal))]
        for row in (*DETAIL, *FLATTERED):
            values = [column.get(row, [row, None])[1] for column in columns]
            cells.append(" → ".join("n/a" if v is None else f"{v:.2f}" for v in values))
        print(f"| {pair['name']} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
