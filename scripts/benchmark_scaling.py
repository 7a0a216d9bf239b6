#!/usr/bin/python3
"""Measures how the time of a frame grows with its inputs; writes a table and a plot.

    benchmark_scaling.py [--program FILE] [--out FOLDER] [--plot FILE.svg] [--sweep NAME]...
                         [--repetitions N] [--quick]

Five sweeps, each of one quantity: mask-pixels (in frames of 1920x1080), target-size (480x270 to
3840x2160 of which the mask covers 24 %, 2 Mpx of the largest), exemplar-frames (10 to 200),
exemplar-size and threads. Inputs are made of the bundled samples: the horse scaled, the watercolour
scaled and interpolated over time. The time of a frame is that of a run of many frames less that of
a run of few, divided by the frames between them.
"""

import argparse
import os
import pathlib
import shutil
import tempfile
from typing import NamedTuple

import numpy as np
from PIL import Image

import benchmark_runs
import benchmark_scaling_plot

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
EXEMPLAR = REPOSITORY / "samples/source/watercolour"
TARGET = REPOSITORY / "samples/target-mask/horse"

# The point that all sweeps but that of the target's size have in common.
EXEMPLAR_SIZE = (400, 222)
EXEMPLAR_FRAMES = 20
TARGET_SIZE = (1920, 1080)
MASK_PIXELS = 111_000  # of the horse in the paper's table 2

MASK_SHARE = 0.241  # 2 Mpx of 3840x2160
FRAMES = (2, 6)  # of the short and of the long run
COLUMNS = ("sweep", "value", "target_width", "target_height", "mask_px", "exemplar_width",
           "exemplar_height", "exemplar_frames", "threads", "cpu_s_per_frame", "cpu_min", "cpu_max",
           "wall_s_per_frame", "us_cores_per_px")


class Setting(NamedTuple):
    """One run's inputs."""

    target_size: tuple = TARGET_SIZE
    mask_pixels: int = MASK_PIXELS
    exemplar_size: tuple = EXEMPLAR_SIZE
    exemplar_frames: int = EXEMPLAR_FRAMES
    threads: int = 1


def mask_pixel_sweep():
    return [(n, Setting(mask_pixels=n)) for n in (31_000, 62_000, 125_000, 250_000, 450_000)]


def target_size_sweep():
    sizes = [(480, 270), (960, 540), (1920, 1080), (3840, 2160)]
    return [(w * h, Setting(target_size=(w, h), mask_pixels=round(MASK_SHARE * w * h)))
            for w, h in sizes]


def exemplar_frame_sweep():
    return [(n, Setting(exemplar_frames=n)) for n in (10, 20, 50, 100, 200)]


def exemplar_size_sweep():
    sizes = [tuple(round(side * scale) for side in EXEMPLAR_SIZE) for scale in (0.5, 0.71, 1, 1.41, 2)]
    return [(w * h, Setting(exemplar_size=(w, h))) for w, h in sizes]


def thread_sweep():
    """1, 2, 4 and so on, and all processors."""
    processors = os.cpu_count() or 1
    counts = [1]
    while counts[-1] * 2 < processors:
        counts.append(counts[-1] * 2)
    return [(n, Setting(threads=n)) for n in counts + [processors] * (processors > 1)]


SWEEPS = {
    "mask-pixels": mask_pixel_sweep,
    "target-size": target_size_sweep,
    "exemplar-frames": exemplar_frame_sweep,
    "exemplar-size": exemplar_size_sweep,
    "threads": thread_sweep,
}


def loaded(folder, mode):
    """All pictures of a folder as arrays of floats."""
    return [np.asarray(Image.open(path).convert(mode), dtype=np.float32)
            for path in sorted(folder.glob("[0-9]*.png"))]


def between(pictures, position):
    """The picture at a fractional index, interpolated."""
    before = min(int(position), len(pictures) - 2)
    share = position - before
    return (1 - share) * pictures[before] + share * pictures[before + 1]


def save(array, size, path, cut):
    """Scales and writes a picture; with `cut`, a mask of black and white."""
    image = Image.fromarray(np.clip(np.rint(array), 0, 255).astype(np.uint8))
    if image.size != size:
        image = image.resize(size, Image.LANCZOS)
    if cut:
        image = image.point(lambda v: 255 if v >= 128 else 0).convert("1")
    path.parent.mkdir(parents=True, exist_ok=True)
    image.save(path, compress_level=1)


def write_exemplar(setting, folder):
    """The watercolour's first EXEMPLAR_FRAMES frames, stretched to as many as are wanted."""
    for name, mode in (("rgb", "RGB"), ("mask", "L")):
        pictures = loaded(EXEMPLAR / name, mode)[:EXEMPLAR_FRAMES]
        for i, position in enumerate(np.linspace(0, len(pictures) - 1, setting.exemplar_frames)):
            save(between(pictures, position), setting.exemplar_size,
                 folder / name / f"{i + 1:05d}.png", cut=mode == "L")


def write_target(setting, folder, frames):
    """The horse in the middle of each frame, scaled until it has the pixels wanted; wider than it is
    where it would be higher than the frame."""
    masks = loaded(TARGET, "L")[:frames]
    rows = np.flatnonzero(np.max(masks, axis=(0, 2)))
    columns = np.flatnonzero(np.max(masks, axis=(0, 1)))
    figures = [mask[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1] for mask in masks]
    inside = np.mean([(figure >= 128).sum() for figure in figures])
    area = setting.mask_pixels / inside  # factor
    height, width = figures[0].shape
    tall = min(round(height * area ** 0.5), setting.target_size[1] - 2)
    size = (round(width * area * height / tall), tall)
    if size[0] > setting.target_size[0]:
        raise ValueError(f"{setting.mask_pixels} px inside do not fit into {setting.target_size}")
    for i, figure in enumerate(figures):
        path = folder / "target" / f"{i + 1:05d}.png"
        save(figure, size, path, cut=True)
        frame = Image.new("1", setting.target_size)
        frame.paste(Image.open(path), ((frame.width - size[0]) // 2, (frame.height - tall) // 2))
        frame.save(path)


def measured(program, setting, frames, repetitions):
    """Costs of a frame, one a repetition, and the pixels inside."""
    few, many = frames
    with tempfile.TemporaryDirectory(prefix="fluidymation-scaling-") as temporary:
        folder = pathlib.Path(temporary)
        write_exemplar(setting, folder)
        write_target(setting, folder, many)

        def run(count):
            shutil.rmtree(folder / "out", ignore_errors=True)
            return benchmark_runs.timed(benchmark_runs.command(
                program, folder / "rgb", folder / "mask", folder / "target", folder / "out", count,
                "--src-frames", setting.exemplar_frames, "--threads", setting.threads))

        costs = []
        for _ in range(repetitions):
            cost_of_few = run(few)
            costs.append(benchmark_runs.per_frame(run(many), cost_of_few, many - few))
        return costs, benchmark_runs.mask_pixels(folder / "out", few + 1, many)


def row_of(sweep, value, setting, costs, pixels):
    cpus = [cost.cpu for cost in costs]
    cpu = float(np.median(cpus))
    return dict(zip(COLUMNS, (
        sweep, value, *setting.target_size, round(pixels), *setting.exemplar_size,
        setting.exemplar_frames, setting.threads, round(cpu, 4), round(min(cpus), 4),
        round(max(cpus), 4), round(float(np.median([cost.wall for cost in costs])), 4),
        round(cpu * 1e6 / pixels, 3))))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=REPOSITORY / "build/release/fluidymation")
    parser.add_argument("--out", type=pathlib.Path, default=REPOSITORY / "output/scaling",
                        help="folder of scaling.tsv; default: output/scaling")
    parser.add_argument("--plot", type=pathlib.Path,
                        help="default: scaling.svg in the folder of --out")
    parser.add_argument("--sweep", action="append", choices=SWEEPS, help="default: all")
    parser.add_argument("--repetitions", type=int, default=3, help="default: 3")
    parser.add_argument("--quick", action="store_true",
                        help="two small points a sweep, one repetition: tries the script")
    given = parser.parse_args()
    if given.repetitions < 1:
        parser.error(f"--repetitions {given.repetitions}: wanted at least 1")

    rows = []
    for sweep in given.sweep or SWEEPS:
        points = SWEEPS[sweep]()
        repetitions, frames = given.repetitions, FRAMES
        if given.quick:
            points, repetitions, frames = points[:2], 1, (1, 2)
        for value, setting in points:
            rows.append(row_of(sweep, value, setting,
                               *measured(given.program, setting, frames, repetitions)))
            print("\t".join(f"{name}={rows[-1][name]}" for name in
                            ("sweep", "value", "mask_px", "cpu_s_per_frame", "us_cores_per_px")),
                  flush=True)
    given.out.mkdir(parents=True, exist_ok=True)
    table = given.out / "scaling.tsv"
    table.write_text("\n".join("\t".join(str(field) for field in line)
                               for line in [COLUMNS] + [list(row.values()) for row in rows]) + "\n")
    plot = given.plot or given.out / "scaling.svg"
    plot.parent.mkdir(parents=True, exist_ok=True)
    plot.write_text(benchmark_scaling_plot.svg(rows))
    print(f"Look at {table} and {plot}.")


if __name__ == "__main__":
    main()
