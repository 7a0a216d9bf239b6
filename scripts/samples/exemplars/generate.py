#!/usr/bin/python3
"""Makes the sample exemplars again: rgb/%05d.png and mask/%05d.png for each name.

    generate.py [--out DIR] [NAME...]

Without names all exemplars are made; without --out they go to samples/source of this checkout.
Needs numpy, scipy and Pillow (Debian: python3-numpy python3-scipy python3-pil).
"""

import argparse
import os
import pathlib
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")  # sums of a fixed order: the same bytes every time
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import ink  # noqa: E402  (after the settings above, which numpy reads when it is loaded)
import rust  # noqa: E402
import watercolour  # noqa: E402

EXEMPLARS = {module.NAME: module for module in (watercolour, ink, rust)}
DEFAULT_OUT = pathlib.Path(__file__).resolve().parents[3] / "samples" / "source"


def main():
    """Reads the command line and makes the exemplars asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, default=DEFAULT_OUT, metavar="DIR")
    parser.add_argument("names", nargs="*", metavar="NAME", help="of: " + ", ".join(EXEMPLARS))
    arguments = parser.parse_args()
    unknown = sorted(set(arguments.names) - set(EXEMPLARS))
    if unknown:
        parser.error(f"no exemplar called {', '.join(unknown)}; there are {', '.join(EXEMPLARS)}")
    for name in arguments.names or EXEMPLARS:
        start = time.monotonic()
        EXEMPLARS[name].generate(arguments.out / name)
        print(f"{name}: {arguments.out / name}, {time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    main()
