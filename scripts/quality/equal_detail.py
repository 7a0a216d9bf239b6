#!/usr/bin/python3
"""Judges two variants of `measure.py` at equal detail: blur flatters patch fidelity and flicker.

    equal_detail.py --judge quality.py --pairs PAIRS.tsv --data DIR --out DIR BLURRED SHARP

DIR is what measure.py has written, BLURRED and SHARP the names of two of its variants. The frames of
SHARP are blurred until their detail is that of BLURRED: with a Gaussian inside, another at the rim, each of
the width, px, at which that row comes out equal, passing over from one to the other round the border's width.
Where SHARP has no more detail than BLURRED, it stays as it is. Then they are judged once more. Writes
DIR/SHARP-as-BLURRED/ with what `measure.py` writes for a variant, and prints the rows that blur flatters
as BLURRED, SHARP and SHARP blurred. Needs python3-numpy and python3-opencv.
"""

import argparse
import json
import pathlib
import sys

import cv2
import numpy as np

import measure

DETAIL = ("detail_interior", "detail_border")  # rows of the judge, inside and at the rim
FLATTERED = ("fidelity_interior", "fidelity_border", "flicker_static", "flicker_moving")
STEPS = 5  # of the secant search for both widths; two or three do mostly
CLOSE = 0.015  # of the detail: half of the row's noise
LARGEST_PX = 2.5
BORDER_PX = 8.0  # depth round which the two widths pass into one another: the judge's borders are 6 to 10 px wide
PASSAGE_PX = 4.0


def blurred(image, width):
    """An RGBA picture whose colours are blurred within what is painted; its alpha stays."""
    if width <= 0.0:
        return image[..., :3].astype(np.float32)
    weight = image[..., 3:].astype(np.float32) / 255.0
    both = np.concatenate([image[..., :3] * weight, weight], axis=2)
    both = cv2.GaussianBlur(both, (0, 0), width, borderType=cv2.BORDER_REPLICATE)
    return both[..., :3] / np.maximum(both[..., 3:], 1e-6)


def blur_frame(path, out, inside, rim):
    """Writes a frame whose interior and rim are blurred by these widths."""
    image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    if image is None or image.ndim != 3 or image.shape[2] != 4 or image.dtype != np.uint8:
        sys.exit(f"equal_detail.py: {path}: wanted an RGBA picture of 8 bits")
    depth = cv2.distanceTransform((image[..., 3] > 127).astype(np.uint8), cv2.DIST_L2, 5)
    share = np.clip((depth - BORDER_PX) / PASSAGE_PX + 0.5, 0.0, 1.0)[..., None]
    color = share * blurred(image, inside) + (1.0 - share) * blurred(image, rim)
    painted = np.where(image[..., 3:] > 0, np.clip(color + 0.5, 0, 255), image[..., :3])
    result = np.concatenate([painted.astype(np.uint8), image[..., 3:]], axis=2)
    if not cv2.imwrite(str(out / path.name), result):
        sys.exit(f"equal_detail.py: {out / path.name}: cannot be written")


def judged(arguments, pair, source, out, widths):
    """The judge's rows of the frames in `source`, blurred by `widths` into `out`."""
    out.mkdir(parents=True, exist_ok=True)
    frames = sorted(source.glob("*.png"))
    for path in frames:
        blur_frame(path, out, *widths)
    masks = ["--mask-blur", pair["blur"], "--mask-threshold", measure.MASK_THRESHOLD]
    result = out / "judged.json"
    command = measure.judge_command(arguments.judge, pair, masks, len(frames), out, result)
    measure.run(command)
    metrics = json.loads(result.read_text(encoding="utf-8"))["metrics"]
    return {row: [m["title"].strip(), m["value"], m["score"]] for row, m in metrics.items()}


def next_width(width, detail, wanted, last):
    """The width at which a line through the last two points, or the first and a guess, has the wanted detail."""
    if last is None or abs(width - last[0]) < 1e-3 or abs(detail - last[1]) < 1e-3:
        proposed = width + 1.2 * (detail - wanted)
    else:
        proposed = width + (wanted - detail) * (width - last[0]) / (detail - last[1])
    return float(np.clip(proposed, 0.0, min(LARGEST_PX, width + 0.6)))


def equalized(arguments, pair):
    """Rows of BLURRED, of SHARP, and of SHARP blurred to the former's detail; and the widths."""
    folders = [arguments.out / name / pair["name"] for name in (arguments.blurred, arguments.sharp)]
    wanted, sharp = (json.loads((f / "figures.json").read_text(encoding="utf-8")) for f in folders)
    out = arguments.out / f"{arguments.sharp}-as-{arguments.blurred}" / pair["name"]
    goals = [wanted[row][1] for row in DETAIL]
    found = [sharp[row][1] for row in DETAIL]
    rows, widths, before = sharp, [0.0, 0.0], [None, None]
    for step in range(STEPS):
        open_ends = [
            i for i in range(2) if found[i] is not None and goals[i] is not None
            and abs(found[i] - goals[i]) > CLOSE and not (step == 0 and found[i] <= goals[i])
        ]  # fmt: skip
        if not open_ends and step > 0:
            break
        for i in open_ends:
            width = next_width(widths[i], found[i], goals[i], before[i])
            if width < 0.3 and widths[i] == 0.0:
                width = 0.3  # less is less than a pixel of 8 bits can show
            before[i] = (widths[i], found[i])
            widths[i] = width
        rows = judged(arguments, pair, folders[1], out, widths)
        found = [rows[row][1] for row in DETAIL]
    (out / "figures.json").write_text(json.dumps(rows), encoding="utf-8")
    return wanted, sharp, rows, widths


def main():
    """Reads the command line and prints a Markdown table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--judge", required=True)
    parser.add_argument("--pairs", required=True)
    parser.add_argument("--data", default="")
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--pair", action="append", help="only this pair; may be repeated")
    parser.add_argument("blurred", metavar="BLURRED")
    parser.add_argument("sharp", metavar="SHARP")
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
            *columns, widths = equalized(arguments, pair)
        except RuntimeError as failure:
            sys.exit(f"equal_detail.py: {failure}")
        cells = []
        for row in (*DETAIL, *FLATTERED):
            values = [column.get(row, [row, None])[1] for column in columns]
            cells.append(" → ".join("n/a" if v is None else f"{v:.2f}" for v in values))
        print(f"| {pair['name']} | {widths[0]:.2f}, {widths[1]:.2f} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
