#!/usr/bin/python3
"""Paints an animation by nothing but the film's mean colours at each distance to the edge.

    measure.py --variants VARIANTS.tsv ...   with a line "rim-alone<TAB><TAB>scripts/quality/rim_alone.py"

A control, no look: it stands in for the tool there and takes those of its options that measure.py gives (it wants
a smoothing of the masks, and takes all of the film from frame 1). What it paints has no texture that could be
restless, and exactly the film's rim. What a judge sees of flicker in it, or of fronts that do not move with the
material, comes from the shapes themselves: where a tooth of a cogwheel passes, a place lies deep for a moment, and is
dark for that moment in every painting whose rim is pale, as the film's.
Needs python3-numpy and python3-opencv.
"""

import argparse
import pathlib
import sys

import cv2
import numpy as np

DEEPEST = 40  # px: what lies deeper is painted as there
FEW = 50  # pixels of the whole film: at fewer its colour at a distance is taken from the neighbouring distances


def loaded(path, flags):
    """A picture."""
    image = cv2.imread(str(path), flags)
    if image is None:
        sys.exit(f"rim_alone.py: {path}: cannot be read; wanted a PNG file")
    return image


def depths(path, arguments):
    """Distances to the edge inside a smoothed mask, px; 0 outside."""
    mask = loaded(path, cv2.IMREAD_GRAYSCALE).astype(np.float32) / 255.0
    if arguments.blur_sigma > 0:
        mask = cv2.GaussianBlur(mask, (0, 0), arguments.blur_sigma, borderType=cv2.BORDER_REPLICATE)
    inside = (mask > arguments.mask_threshold).astype(np.uint8)
    return np.minimum(cv2.distanceTransform(inside, cv2.DIST_L2, 5), DEEPEST)


def numbered(pattern, start):
    """The files of a sequence, from a number on to the first that is missing."""
    found = []
    while pathlib.Path(pattern % (start + len(found))).exists():
        found.append(pattern % (start + len(found)))
    if not found:
        sys.exit(f"rim_alone.py: {pattern % start}: not there; wanted the first frame of a sequence")
    return found


def mean_colors(arguments):
    """Of the film, in CIELAB, at distances of 0, 1, 2, ... px."""
    sums, counts = np.zeros((DEEPEST + 1, 3)), np.zeros(DEEPEST + 1)
    for color, mask in zip(numbered(arguments.src_path, 1), numbered(arguments.src_mask_path, 1)):
        lab = cv2.cvtColor(loaded(color, cv2.IMREAD_COLOR).astype(np.float32) / 255.0, cv2.COLOR_BGR2Lab)
        depth = depths(mask, arguments)
        step = depth[depth > 0].astype(int)
        counts += np.bincount(step, minlength=len(counts))
        for channel in range(3):
            sums[:, channel] += np.bincount(step, lab[..., channel][depth > 0], len(counts))
    known = np.flatnonzero(counts >= FEW)
    if not known.size:
        sys.exit(f"rim_alone.py: {arguments.src_mask_path}: covers next to nothing; wanted the masks of a film")
    means = sums[known] / counts[known, None]
    return np.stack([np.interp(np.arange(DEEPEST + 1), known, channel) for channel in means.T], axis=1)


def main():
    """Reads the command line and writes the frames."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("--src-path", "--src-mask-path", "--target-path", "--out-path"):
        parser.add_argument(name, required=True, metavar="PATTERN", help="as of the tool, with %%05d")
    parser.add_argument("--target-start", type=int, default=1)
    parser.add_argument("--target-frames", type=int, default=50)
    parser.add_argument("--blur-sigma", type=float, required=True, help="px; the tool's own choice is not made here")
    parser.add_argument("--mask-threshold", type=float, default=0.3)
    parser.add_argument("--threads", help="of no account")
    parser.add_argument("--quiet", action="store_true", help="it always is")
    arguments = parser.parse_args()
    colors = mean_colors(arguments)
    pathlib.Path(arguments.out_path).parent.mkdir(parents=True, exist_ok=True)
    targets = numbered(arguments.target_path, arguments.target_start)[: arguments.target_frames]
    for number, path in enumerate(targets, arguments.target_start):
        depth = depths(path, arguments)
        lab = np.stack([np.interp(depth, np.arange(DEEPEST + 1), channel) for channel in colors.T], axis=2)
        bgr = cv2.cvtColor(lab.astype(np.float32), cv2.COLOR_Lab2BGR)
        alpha = np.where(depth > 0, 255.0, 0.0)[..., None]
        pixels = np.concatenate([np.clip(255.0 * bgr + 0.5, 0, 255), alpha], axis=2).astype(np.uint8)
        if not cv2.imwrite(arguments.out_path % number, pixels):
            sys.exit(f"rim_alone.py: {arguments.out_path % number}: cannot be written")


if __name__ == "__main__":
    main()
