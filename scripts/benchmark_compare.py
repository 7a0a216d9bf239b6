#!/usr/bin/python3
"""Compares the speed of two builds of the tool by whole runs on a bundled sample.

    benchmark_compare.py --program A --against B [--case NAME] [--frames MANY] [--few FEW]
                         [--pairs N] [--threads N]

Every pair is four runs: A and B with many frames, A and B with few. The time of a frame is the
difference divided by the frames between them, so that start-up and reading cancel. A machine that
others use too may change its speed by half within minutes: only runs next to each other compare.
Each pair therefore has a ratio of its own, and A and B take turns in going first.
"""

import argparse
import pathlib
import shutil
import sys
import tempfile

import numpy as np
from PIL import Image

import benchmark_runs

# As in tests/bench/benchmark_case.cpp, at the samples' own sizes: exemplar, its frames, target.
CASES = {
    "genie": ("ink", 30, "genie"),
    "horse": ("watercolour", 20, "horse"),
    "sunflower": ("rust", 20, "sunflower"),
    "waving": ("ink", 20, "waving"),
    "jump": ("rust", 20, "jump"),
}
SAMPLES = pathlib.Path(__file__).resolve().parent.parent / "samples"
MICROSECONDS = 1e6


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True, metavar="A")
    parser.add_argument("--against", required=True, metavar="B")
    parser.add_argument("--case", choices=CASES, default="horse", help="default: horse")
    parser.add_argument("--frames", type=int, default=6, metavar="MANY", help="default: 6")
    parser.add_argument("--few", type=int, default=2, help="frames; default: 2")
    parser.add_argument("--pairs", type=int, default=3, help="default: 3")
    parser.add_argument("--threads", type=int, default=1, help="default: 1")
    given = parser.parse_args()
    if not 1 <= given.few < given.frames:
        parser.error(f"--few {given.few} --frames {given.frames}: wanted 1 <= few < frames")
    if given.pairs < 1:
        parser.error(f"--pairs {given.pairs}: wanted at least 1")
    return given


def spread(values, digits):
    """Median and range."""
    return f"{np.median(values):.{digits}f} ({min(values):.{digits}f}..{max(values):.{digits}f})"


def frame_cost(name, many, few, frames):
    """What a frame of one program costs; ends this script where runs are too short to tell."""
    cost = benchmark_runs.per_frame(many, few, frames)
    if cost.wall <= 0 or cost.cpu <= 0:
        sys.exit(f"{name}: many frames took no longer than few; wanted more, see --frames")
    return cost


def same_frames(folder, other, frames):
    """How many of the first frames have the same pixels; files may be compressed differently."""
    names = [f"{number:05d}.png" for number in range(1, frames + 1)]
    return sum(np.array_equal(np.asarray(Image.open(folder / name)),
                              np.asarray(Image.open(other / name))) for name in names)


def main():
    given = arguments()
    exemplar, exemplar_frames, target = CASES[given.case]
    source = SAMPLES / "source" / exemplar
    costs = {"A": [], "B": []}
    programs = {"A": given.program, "B": given.against}
    with tempfile.TemporaryDirectory(prefix="fluidymation-benchmark-") as temporary:
        out = {name: pathlib.Path(temporary) / name for name in programs}

        def run(name, frames):
            shutil.rmtree(out[name], ignore_errors=True)
            return benchmark_runs.timed(benchmark_runs.command(
                programs[name], source / "rgb", source / "mask", SAMPLES / "target-mask" / target,
                out[name], frames, "--src-frames", exemplar_frames, "--threads", given.threads))

        for pair in range(given.pairs):
            order = sorted(programs, reverse=pair % 2 == 1)
            few = {name: run(name, given.few) for name in order}
            many = {name: run(name, given.frames) for name in order}
            for name in programs:
                costs[name].append(
                    frame_cost(name, many[name], few[name], given.frames - given.few))
        pixels = benchmark_runs.mask_pixels(out["A"], given.few + 1, given.frames)
        same = same_frames(out["A"], out["B"], given.frames)

    print(f"case      {given.case}: {exemplar}, {exemplar_frames} frames; {pixels:.0f} px inside; "
          f"{given.threads} thread(s)")
    print(f"measured  frames {given.few + 1} to {given.frames}, {given.pairs} pair(s) of runs; "
          "median (range)")
    for name, program in programs.items():
        walls = [cost.wall for cost in costs[name]]
        cpus = [cost.cpu * MICROSECONDS / pixels for cost in costs[name]]
        print(f"{name}         {spread(walls, 3)} s per frame, {spread(cpus, 2)} "
              f"microseconds x cores per px inside   {program}")
    pairs = list(zip(costs["A"], costs["B"]))
    print(f"B / A     of each pair: {spread([b.wall / a.wall for a, b in pairs], 2)} by the clock, "
          f"{spread([b.cpu / a.cpu for a, b in pairs], 2)} by processor time")
    print(f"painted   {same} of {given.frames} frames have the same pixels")


if __name__ == "__main__":
    main()
