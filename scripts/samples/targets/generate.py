#!/usr/bin/python3
"""Draws the sample target animations: binary masks, white = inside, one 1-bit PNG per frame from 00001.png.

    generate.py [--out DIR] [NAME...]

Each module named in MODULES has SIZE (width, height in px), FRAMES and frame(index) with index from 0, which
returns either one mask or, for an animation in layers, a dict of masks by the name of the segment; the segments go
to NAME-segments/SEGMENT/ and their union to NAME/. The same code draws the same bytes on every run.
"""

import argparse
import importlib
import pathlib

import numpy as np

import vector

MODULES = ("genie", "horse", "jump", "squiggle", "sunflower", "waving")
DEFAULT_OUT = pathlib.Path(__file__).resolve().parents[3] / "samples" / "target-mask"


def clear_folder(folder):
    """Make the folder and drop frames of an earlier, longer run."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("[0-9][0-9][0-9][0-9][0-9].png"):
        old.unlink()


def generate(name, out):
    """Draw one animation; returns the number of pixels inside for each frame."""
    module = importlib.import_module(name)
    cleared = set()
    areas = []
    for index in range(module.FRAMES):
        drawn = module.frame(index)
        layers = {}
        if isinstance(drawn, dict):
            layers = {out / f"{name}-segments" / segment: mask for segment, mask in drawn.items()}
            drawn = np.logical_or.reduce(list(drawn.values()))
        layers[out / name] = drawn
        for folder, mask in layers.items():
            if folder not in cleared:
                clear_folder(folder)
                cleared.add(folder)
            vector.save_mask(mask, folder / f"{index + 1:05d}.png")
        areas.append(int(drawn.sum()))
    return areas


def main():
    parser = argparse.ArgumentParser(description="Draw the sample target animations.")
    parser.add_argument("--out", type=pathlib.Path, default=DEFAULT_OUT, help="folder for the animations")
    parser.add_argument("names", nargs="*", metavar="NAME", help="one or more of: " + ", ".join(MODULES))
    arguments = parser.parse_args()
    for name in arguments.names:
        if name not in MODULES:
            parser.error(f"no animation '{name}'; there are: " + ", ".join(MODULES))
    for name in arguments.names or MODULES:
        areas = generate(name, arguments.out)
        width, height = importlib.import_module(name).SIZE
        print(f"{name}: {len(areas)} frames {width}x{height}, inside {min(areas)}..{max(areas)} px, "
              f"mean {sum(areas) / len(areas):.0f}")


if __name__ == "__main__":
    main()
