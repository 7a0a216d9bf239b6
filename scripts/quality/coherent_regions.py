#!/usr/bin/python3
"""Measures how large the pieces of the exemplar are that a painting is made of.

    coherent_regions.py DUMP...

DUMP is a folder that `--dump-guides` has written. Two neighbouring pixels belong to one region
when one's match continues the other's: the same frame of the exemplar, and the place that the
neighbour's match, turned as it is, has one pixel further. Prints for each folder, as the mean over
its frames, the side of the region that a pixel lies in (the square root of its area, px, mean over
pixels), and the share of all pairs of neighbours that a seam divides.
"""

import pathlib
import sys

import numpy as np

NEAR_PX = 0.7  # half a pixel's diagonal: what reading matches at whole pixels may add


def read_pfm(path):
    """A PFM file as an array of height x width x channels, top row first."""
    with path.open("rb") as file:
        channels = {b"PF": 3, b"Pf": 1}[file.readline().strip()]
        width, height = map(int, file.readline().split())
        file.readline()
        values = np.frombuffer(file.read(), "<f4")
    return values.reshape(height, width, channels)[::-1]


def joined(matches, theta, dx, dy):
    """Where a pixel's match is continued by that of the pixel (dx, dy) further."""
    height, width = theta.shape
    here = np.s_[: height - dy, : width - dx]
    there = np.s_[dy:, dx:]
    cosine, sine = np.cos(theta[here]), np.sin(theta[here])
    away_x = matches[here][..., 0] + cosine * dx + sine * dy - matches[there][..., 0]
    away_y = matches[here][..., 1] - sine * dx + cosine * dy - matches[there][..., 1]
    both = (matches[here][..., 2] >= 0) & (matches[there][..., 2] >= 0)
    same = matches[here][..., 2] == matches[there][..., 2]
    return both, both & same & (away_x**2 + away_y**2 < NEAR_PX**2)


def region_areas(pairs, count):
    """Areas of the regions that pairs of pixels join."""
    parent = list(range(count))

    def root(pixel):
        while parent[pixel] != pixel:
            parent[pixel] = parent[parent[pixel]]
            pixel = parent[pixel]
        return pixel

    for first, second in pairs:
        parent[root(first)] = root(second)
    return np.bincount([root(pixel) for pixel in range(count)]).astype(float)


def measure(matches, theta):
    """Side of the mean region, px, and share of seams of one frame; None where nothing is painted."""
    inside = matches[..., 2] >= 0
    if not inside.any():
        return None
    numbers = np.cumsum(inside).reshape(inside.shape) - 1
    pairs, neighbors = [], 0
    for dx, dy in ((1, 0), (0, 1)):
        both, one = joined(matches, theta, dx, dy)
        neighbors += both.sum()
        height, width = inside.shape
        first = numbers[: height - dy, : width - dx][one]
        second = numbers[dy:, dx:][one]
        pairs += zip(first.tolist(), second.tolist())
    areas = region_areas(pairs, int(inside.sum()))
    side = np.sqrt((areas**2).sum() / areas.sum())
    return side, 1 - len(pairs) / max(neighbors, 1)


def main():
    """Reads the command line and prints a line for each folder."""
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    for name in sys.argv[1:]:
        fields = sorted(pathlib.Path(name, "target").glob("*.nnf.pfm"))
        if not fields:
            sys.exit(f"coherent_regions.py: {name}: no target/*.nnf.pfm; wanted a --dump-guides folder")
        figures = []
        for path in fields:
            turns = path.with_name(path.name.replace(".nnf.", ".theta."))
            figures.append(measure(read_pfm(path), read_pfm(turns)[..., 0]))
        side, seams = np.mean([figure for figure in figures if figure], axis=0)
        print(f"{name}: side of a region {side:.1f} px, seams {seams:.3f}")


if __name__ == "__main__":
    main()
