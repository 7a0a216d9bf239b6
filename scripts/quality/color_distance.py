#!/usr/bin/python3
"""Measures how far a painting's body colours are from its film's, and whether they drift away.

    color_distance.py [--border-width PX] FILM PAINTED...

FILM is a folder with rgb/ and mask/, PAINTED a folder of painted RGBA frames. For the first, the middle
and the last frame of each it prints the distance between the colours that lie deeper than the border's
width and those that do in the film, all frames alike: the mean difference of their quantiles from 2 to
98 per cent (the earth mover's distance) in L, in a and in b of CIELAB, as one length. Needs
python3-numpy and python3-opencv.
"""

import argparse
import pathlib
import sys

import cv2
import numpy as np

QUANTILES = np.linspace(0.02, 0.98, 49)
FEWEST = 50  # pixels: fewer have no quantiles


def read(path, flags, what):
    """An image as OpenCV reads it, in [0, 1]."""
    image = cv2.imread(str(path), flags | cv2.IMREAD_ANYDEPTH)
    if image is None:
        sys.exit(f"color_distance.py: {path}: cannot be read; wanted {what}")
    return image.astype(np.float32) / np.iinfo(image.dtype).max


def quantiles(color, inside, border_width):
    """Quantiles of the colours of the interior; None where it has too few pixels."""
    depth = cv2.distanceTransform(inside.astype(np.uint8), cv2.DIST_L2, 5)
    lab = cv2.cvtColor(color, cv2.COLOR_BGR2LAB)
    interior = lab[depth > border_width]
    return np.quantile(interior, QUANTILES, axis=0) if len(interior) >= FEWEST else None


def film_quantiles(film, border_width):
    """The same of a film, as the mean over the frames that have an interior."""
    found = []
    for path in sorted((film / "rgb").glob("*.png")):
        inside = read(film / "mask" / path.name, cv2.IMREAD_GRAYSCALE, "the frame's mask") > 0.5
        values = quantiles(read(path, cv2.IMREAD_COLOR, "a frame"), inside, border_width)
        if values is not None:
            found.append(values)
    if not found:
        sys.exit(f"color_distance.py: {film}: no frame with an interior; wanted a film with rgb/ and mask/")
    return np.mean(found, axis=0)


def main():
    """Reads the command line and prints a line for each painting."""
    parser = argparse.ArgumentParser(description="Distance of a painting's body colours to its film's.")
    parser.add_argument("film", type=pathlib.Path, metavar="FILM")
    parser.add_argument("painted", type=pathlib.Path, nargs="+", metavar="PAINTED")
    parser.add_argument("--border-width", type=float, default=10.0, metavar="PX")
    arguments = parser.parse_args()
    film = film_quantiles(arguments.film, arguments.border_width)
    for folder in arguments.painted:
        frames = sorted(folder.glob("*.png"))
        if not frames:
            sys.exit(f"color_distance.py: {folder}: holds no PNG file; wanted painted frames")
        distances = []
        for path in (frames[0], frames[len(frames) // 2], frames[-1]):
            image = read(path, cv2.IMREAD_UNCHANGED, "a painted frame")
            if image.ndim != 3 or image.shape[2] != 4:
                sys.exit(f"color_distance.py: {path}: has no alpha; wanted a frame painted without background")
            own = quantiles(np.ascontiguousarray(image[..., :3]), image[..., 3] > 0.5, arguments.border_width)
            distances.append(np.nan if own is None else np.linalg.norm(np.abs(own - film).mean(axis=0)))
        print(f"{' '.join(f'{apart:5.1f}' for apart in distances)}   {folder}")


if __name__ == "__main__":
    main()
