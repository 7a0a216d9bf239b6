"""Times whole runs of the tool: what the benchmark scripts share."""

import os
import pathlib
import subprocess
import sys
import time
from typing import NamedTuple

import numpy as np
from PIL import Image

OPAQUE_FROM = 128  # alpha of a pixel that counts as inside


class Cost(NamedTuple):
    """Seconds: of the clock, and of all processors together (user and system)."""

    wall: float
    cpu: float


def timed(command):
    """Runs a command to its end; ends this script when it fails."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    message = process.stderr.read().decode(errors="replace")
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}\nended with code {process.returncode}: {message.strip()}")
    return Cost(wall, usage.ru_utime + usage.ru_stime)


def per_frame(many, few, frames):
    """Cost of a frame from a run of many and one of few: what does not depend on frames cancels."""
    return Cost((many.wall - few.wall) / frames, (many.cpu - few.cpu) / frames)


def command(program, source, masks, target, out, frames, *options):
    """A run of the tool on folders of numbered PNG files."""
    pattern = "/%05d.png"
    return [str(program), "--quiet", "--src-path", f"{source}{pattern}",
            "--src-mask-path", f"{masks}{pattern}", "--target-path", f"{target}{pattern}",
            "--out-path", f"{out}{pattern}", "--target-frames", str(frames), *map(str, options)]


def mask_pixels(folder, first, last):
    """Mean number of pixels inside, of the painted frames first to last."""
    counts = []
    for number in range(first, last + 1):
        alpha = np.asarray(Image.open(pathlib.Path(folder) / f"{number:05d}.png").getchannel("A"))
        counts.append(int((alpha >= OPAQUE_FROM).sum()))
    return float(np.mean(counts))
