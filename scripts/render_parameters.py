#!/usr/bin/python3
"""Makes the pictures of docs/parameters/: one option at several values, from the samples alone.

    render_parameters.py [--program FILE] [NAME...]

Without names all strips; --program is build/release/fluidymation by default. A strip shows, from the left, one option
from low to high; where it has rows, they are frames that follow one another. Painted frames go to
output/parameters, strips to docs/images/parameters.
"""

import argparse
import dataclasses
import pathlib
import subprocess
import sys

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAINTED = pathlib.Path("output/parameters")
STRIPS = pathlib.Path("docs/images/parameters")
PAPER = (244, 241, 232)
GAP_PX = 6
PALETTE_COLOURS = 128  # a third of the bytes of true colour

# Exemplar and target of each pair, and the options that all its strips have.
PAIRS = {
    "watercolour-horse": ("watercolour", "horse", ["--target-scale", "0.4", "--border-width", "10"]),
    "ink-horse": ("ink", "horse", ["--target-scale", "0.4", "--border-width", "8"]),
    "rust-jump": ("rust", "jump", ["--blur-sigma", "3", "--mask-threshold", "0.45", "--border-width", "10"]),
    "rust-horse": ("rust", "horse", ["--target-scale", "0.4", "--blur-sigma", "2", "--mask-threshold", "0.45",
                                     "--border-width", "8"]),
    "ink-squiggle": ("ink", "squiggle", ["--target-scale", "0.4"]),
    "ink-genie": ("ink", "genie", ["--src-scale", "0.5", "--target-scale", "0.5"]),
}


@dataclasses.dataclass(frozen=True)
class Strip:
    """One picture: an option, its values from the left, and what is shown of which frames."""

    pair: str
    variants: tuple  # one list of options a column
    range: str  # --target-range
    frames: tuple = ()  # numbers to show, one a row; the last one painted if empty
    cut: tuple = (0.0, 0.0, 1.0, 1.0)  # left, top, right, bottom in shares of the frame
    enlarged: float = 1.0


def values(option, *each):
    """One variant for each value of an option."""
    return tuple([option, str(value)] for value in each)


HORSE = (0.14, 0.1, 0.9, 0.86)
HEAD = (0.55, 0.12, 0.9, 0.6)
NECK = (0.56, 0.25, 0.74, 0.45)
STRIPS_TO_MAKE = {
    # film and sizes
    "src-frames": Strip("watercolour-horse", values("--src-frames", 2, 6, 24), "1-6", cut=HORSE),
    "src-scale": Strip("watercolour-horse", values("--src-scale", 0.4, 1, 2), "1-4", cut=HORSE),
    "target-blur-sigma": Strip("watercolour-horse", values("--target-blur-sigma", 0, 1.8, 8), "1-4", cut=HORSE),
    "border-width": Strip("ink-horse", values("--border-width", 1, 8, 40), "1-4", cut=HORSE),
    # edges
    "mask-threshold": Strip("rust-jump", values("--mask-threshold", 0.1, 0.3, 0.5), "1-4", cut=(0.02, 0.4, 0.28, 1.0), enlarged=1.5),
    "dist-weight": Strip("ink-horse", values("--dist-weight", 0, 5, 500), "1-4", cut=HORSE),
    "thin-parts": Strip("ink-horse", tuple([*one, "--border-width", "14"] for one in values("--thin-parts", "fringe", "body")),
                        "1-4", cut=HORSE),
    # motion
    "flow-weight": Strip("ink-squiggle", tuple([*one, "--new-material", "plain"] for one in values("--flow-weight", 0, 0.1, 10)),
                         "1-40", frames=(40,)),
    "new-material": Strip("ink-squiggle", (["--new-material", "plain"], ["--new-material", "fresh"],
                                           ["--new-material", "plain", "--reverse", "on"]), "1-40", frames=(30,)),
    # time
    "prev-color-correction": Strip("ink-genie", values("--prev-color-correction", 0, 0.5, 1), "13-30", frames=(20, 26, 30),
                                   cut=(0.28, 0.32, 0.7, 1.0)),
    # texture and vote
    "vote-sigma": Strip("rust-horse", tuple([*one, "--detail-restoration", "0"] for one in values("--vote-sigma", 0.1, 0.35, 3)), "1-4", cut=NECK, enlarged=4),
    "seam-blending": Strip("rust-horse", tuple([*one, "--detail-restoration", "0"] for one in values("--seam-blending", 0, 0.3, 4)), "1-4", cut=NECK, enlarged=4),
    "detail-restoration": Strip("ink-horse", values("--detail-restoration", 0, 0.5, 1), "1-4", cut=NECK, enlarged=4),
    "opt-vote-sigma": Strip("rust-horse", values("--opt-vote-sigma", 0, 0.35, 0.5), "1-4", cut=NECK, enlarged=4),
    "coherence-weight": Strip("rust-horse", values("--coherence-weight", 0, 8, 200), "1-4", cut=NECK, enlarged=4),
    "lambda": Strip("watercolour-horse", values("--lambda", 0, 2, 200), "1-4", cut=HORSE),
    "tex-weight": Strip("watercolour-horse", values("--tex-weight", 0.01, 1, 100), "1-4", cut=HORSE),
    # effort
    "opt-iterations": Strip("rust-horse", (["--opt-iterations", "0"], ["--opt-iterations", "4,3,2"],
                                           ["--opt-iterations", "12"]), "1-4", cut=HEAD, enlarged=2),
}


def paint(program, name, column, strip, options):
    """Paints one column of a strip and gives the folder of its frames."""
    exemplar, target, common = PAIRS[strip.pair]
    given = options[0::2]
    kept = [word for i in range(0, len(common), 2) if common[i] not in given for word in common[i : i + 2]]
    folder = PAINTED / f"{name}-{column}"
    subprocess.run(
        [program, "--src-path", f"samples/source/{exemplar}/rgb", "--src-mask-path", f"samples/source/{exemplar}/mask",
         "--target-path", f"samples/target-mask/{target}", "--target-range", strip.range, *kept, *options,
         "--out-path", str(folder), "--overwrite", "--restart", "--quiet"],
        check=True, cwd=ROOT)
    return folder


def shown(file, strip):
    """The cut of a painted frame, over paper."""
    painted = Image.open(file)
    paper = Image.new("RGB", painted.size, PAPER)
    paper.paste(painted, mask=painted.getchannel("A"))
    left, top, right, bottom = strip.cut
    box = (left * paper.width, top * paper.height, right * paper.width, bottom * paper.height)
    cut = paper.crop(tuple(round(edge) for edge in box))
    return cut.resize((round(cut.width * strip.enlarged), round(cut.height * strip.enlarged)), Image.NEAREST)


def render(program, name, strip):
    """Paints a strip's columns and writes its picture."""
    folders = [paint(program, name, column, strip, options) for column, options in enumerate(strip.variants)]
    frames = strip.frames or (int(strip.range.split("-")[1]),)
    cuts = [[shown(ROOT / folder / f"{number:05d}.png", strip) for folder in folders] for number in frames]
    width, height = cuts[0][0].size
    sheet = Image.new("RGB", ((width + GAP_PX) * len(folders) - GAP_PX, (height + GAP_PX) * len(frames) - GAP_PX), "white")
    for row, pictures in enumerate(cuts):
        for column, picture in enumerate(pictures):
            sheet.paste(picture, (column * (width + GAP_PX), row * (height + GAP_PX)))
    (ROOT / STRIPS).mkdir(parents=True, exist_ok=True)
    sheet.quantize(PALETTE_COLOURS).save(ROOT / STRIPS / f"{name}.png", optimize=True)
    print(STRIPS / f"{name}.png", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/fluidymation"), metavar="FILE")
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(STRIPS_TO_MAKE))
    arguments = parser.parse_args()
    unknown = [name for name in arguments.names if name not in STRIPS_TO_MAKE]
    if unknown:
        sys.exit(f"render_parameters.py: {unknown[0]}: no such strip; there are: {' '.join(STRIPS_TO_MAKE)}")
    for name in arguments.names or STRIPS_TO_MAKE:
        render(str(pathlib.Path(arguments.program).resolve()), name, STRIPS_TO_MAKE[name])


if __name__ == "__main__":
    main()
