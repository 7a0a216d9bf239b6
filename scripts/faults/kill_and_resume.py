#!/usr/bin/env python3
"""Kills a run at random times, goes on with --resume and another number of threads, and compares.

Every run is killed after a random time, until one has painted all frames; then frames and manifest
have to be those of a run that nobody killed, byte for byte, and nothing may be left over. That is
repeated until there were enough kills. Prints one line a round, and how many kills hit which stage.
Exit code 1 at the first difference.

    scripts/faults/kill_and_resume.py --kills 50 --frames 12 watercolour horse
"""

import argparse
import collections
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def parsed_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("exemplar", nargs="?", default="rust", help="of samples/source (default rust)")
    parser.add_argument("target", nargs="?", default="jump", help="of samples/target-mask (default jump)")
    parser.add_argument("--kills", type=int, default=20, help="at least so many (default 20)")
    parser.add_argument("--frames", type=int, default=8, help="of the target (default 8)")
    parser.add_argument("--seed", type=int, default=1, help="of the times (default 1)")
    parser.add_argument("--every", type=int, help="--checkpoint-every (default: the tool's)")
    parser.add_argument("--program", default=str(ROOT / "build/release/fluidymation"))
    return parser.parse_args()


def command_of(arguments, out):
    source = ROOT / "samples/source" / arguments.exemplar
    command = [
        arguments.program,
        "--src-path", f"{source}/rgb/%05d.png",
        "--src-mask-path", f"{source}/mask/%05d.png",
        "--target-path", f"{ROOT}/samples/target-mask/{arguments.target}/%05d.png",
        "--target-frames", str(arguments.frames),
        "--out-path", f"{out}/%05d.png",
        "--quiet",
    ]
    if arguments.every:
        command += ["--checkpoint-every", str(arguments.every)]
    return command


def files_of(folder):
    """Frames and manifest by name, without how long they took."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def stage_of(folder):
    """What a killed run was doing, as far as its folder tells."""
    half_written = [path.name for path in folder.rglob(".*.tmp.*")]
    for name in half_written:
        return "writing " + ("a frame" if ".png.tmp." in name else "a state" if "state-" in name else "a manifest")
    if not any(folder.glob("*.png")):
        return "reading"
    return "painting"


class Differs(Exception):
    """What a killed and resumed run made that an undisturbed one does not."""


def kill_and_compare(command_of, folder, kills, seed, tell=lambda line: None):
    """Kills runs until there were so many kills. Returns how many there were by stage; raises Differs.

    command_of: gives the command that paints into a folder. tell: is given a line each round.
    """
    times = random.Random(seed)
    stages = collections.Counter()
    begun = time.monotonic()
    subprocess.run(command_of(folder) + ["--threads", "2"], check=True)
    longest = time.monotonic() - begun
    expected = files_of(folder)
    while sum(stages.values()) < kills:
        shutil.rmtree(folder)
        here = 0
        while True:
            process = subprocess.Popen(command_of(folder) + ["--resume", "--threads", times.choice("123")])
            try:
                code = process.wait(timeout=times.uniform(0.0, longest))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                here += 1
                stages[stage_of(folder) if folder.exists() else "reading"] += 1
                continue
            if code != 0:
                raise Differs(f"a resumed run ended with exit code {code} after {here} kills")
            break
        found = files_of(folder)
        if found != expected:
            names = sorted(name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name))
            raise Differs(f"after {here} kills these differ: {', '.join(names)}")
        left = sorted(path.name for path in (folder / ".fluidymation").iterdir())
        if left != ["times.json"]:
            raise Differs(f"after {here} kills these are left over: {', '.join(left)}")
        tell(f"{len(found) - 1} frames and the manifest are the same after {here} kills")
    return stages


def main():
    arguments = parsed_arguments()
    with tempfile.TemporaryDirectory() as temporary:
        try:
            stages = kill_and_compare(lambda out: command_of(arguments, out), pathlib.Path(temporary) / "out",
                                      arguments.kills, arguments.seed, lambda line: print(line, flush=True))
        except Differs as difference:
            sys.exit(str(difference))
    print(f"{sum(stages.values())} kills: "
          + ", ".join(f"{count} while {stage}" for stage, count in stages.most_common()))


if __name__ == "__main__":
    main()
