#!/usr/bin/env python3
"""Runs the tool again and again into one folder, with options for going on drawn at random, killed at random times,
while somebody edits, removes and adds frames, manifest and states. After each step this has to hold:

  - what somebody has put there or edited is replaced by nothing but --overwrite, or --restart after a run that was stopped;
  - --skip-existing changes nothing that is there;
  - no frame is half written, and no temporary file stays behind a run that has painted;
  - a run that succeeds has painted the frames it was asked for, and --verify finds them as painted; one over the whole shot
    has painted those of an undisturbed run with its --seed, byte for byte;
  - a refusal names what works: each option that it offers is tried on a copy, and is not refused in turn.

Prints each step with --talk, else the number of steps. Exit code 1 where something did not hold, with the
steps that led there; the same --seed takes the same steps, though kills come at other moments.

    scripts/faults/continuation_storm.py --program build/release/fluidymation --minutes 5
"""

import argparse
import collections
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import small_scene

FRAMES = 6
FOREIGN = b"a picture of somebody else's"
SEEDS = ("1", "2")
SLOW = ("--opt-iterations", "60")  # leaves time to be killed in


class Broken(Exception):
    """What did not hold."""


def parsed_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--minutes", type=float, default=1.0)
    parser.add_argument("--steps", type=int, default=10**9, help="at most")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--large", action="store_true", help="frames that wait on the disk, not in memory alone")
    parser.add_argument("--talk", action="store_true")
    return parser.parse_args()


class Storm:
    """A scene, a folder that it is painted into, and what is known of that folder."""

    def __init__(self, arguments, folder):
        self.program = arguments.program.resolve()
        self.folder = folder
        self.random = random.Random(arguments.seed)
        self.talk = arguments.talk
        self.scene = folder / "scene"
        small_scene.make(self.scene, 32, FRAMES)
        self.options = ["--checkpoint-every", "1", *SLOW]
        if arguments.large:
            small_scene.make_large_targets(self.scene, 640, FRAMES + 4)
            self.options = ["--checkpoint-every", "1", "--opt-iterations", "1", "--target-frames", str(FRAMES)]
        self.out = folder / "out"
        self.history = []
        self.foreign = {}  # names and bytes of what somebody has put there
        self.edits = 0
        self.granted = set()  # names of those of them that a --restart was allowed to replace, and may not have yet
        self.has_parts = False  # painted by runs over parts of the shot
        self.seed = SEEDS[0]
        self.counts = collections.Counter()
        self.references = {}  # the frames of undisturbed runs, by seed
        for seed in SEEDS:
            reference = folder / f"reference-{seed}"
            begun = time.monotonic()
            self.must_succeed(self.run(reference, ["--seed", seed]))
            self.seconds = time.monotonic() - begun
            self.references[seed] = self.frames(reference)

    def command(self, out, more):
        return [str(self.program), *small_scene.options(self.scene, out), *self.options, *more]

    def run(self, out, more, kill_after=None, number=signal.SIGKILL):
        """@return  exit code, negative where a signal ended it, and what it said"""
        with subprocess.Popen(self.command(out, more), stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
            try:
                text, _ = process.communicate(timeout=kill_after)
            except subprocess.TimeoutExpired:
                process.send_signal(number)
                text, _ = process.communicate(timeout=60)
        return process.returncode, text.decode(errors="replace")

    @staticmethod
    def must_succeed(result):
        if result[0] != 0:
            raise Broken(f"ended with {result[0]}: {result[1].strip()}")

    # What is there

    def frame(self, number):
        return self.out / f"{number:05d}.png"

    def frames(self, folder=None):
        return {path.name: path.read_bytes() for path in sorted((folder or self.out).glob("*.png"))}

    def put(self, path, data):
        """Somebody's own file, other than any before."""
        self.edits += 1
        path.unlink(missing_ok=True)
        path.write_bytes(data + str(self.edits).encode())
        self.foreign[path.name] = path.read_bytes()
        self.granted.discard(path.name)

    # Steps

    def edit(self):
        """Somebody edits, removes or adds something."""
        self.out.mkdir(exist_ok=True)
        path = self.frame(self.random.randint(1, FRAMES))
        hidden = self.out / ".fluidymation"
        states = sorted(hidden.glob("state-*")) if hidden.exists() else []
        kind = self.random.choice(["add", "add", "edit", "remove", "remove", "manifest", "hidden", "state", "spoil"])
        if kind == "edit" and path.exists():
            self.put(path, path.read_bytes() + b"edited")
        elif kind in ("add", "edit"):
            self.put(path, FOREIGN)
        elif kind == "remove":
            path.unlink(missing_ok=True)
            self.foreign.pop(path.name, None)
        elif kind == "manifest":
            (self.out / "fluidymation.json").unlink(missing_ok=True)
        elif kind == "hidden":
            shutil.rmtree(hidden, ignore_errors=True)
        elif kind == "state" and states:
            self.random.choice(states).unlink()
        elif kind == "spoil" and states:
            state = self.random.choice(states)
            state.write_bytes(state.read_bytes()[: self.random.randint(0, 3000)])
        return f"{kind} {path.name}"

    def paint(self):
        """A run with some options."""
        more = list(self.random.choice([[], [], ["--resume"], ["--resume"], ["--resume"], ["--restart"], ["--overwrite"],
                                        ["--skip-existing"], ["--skip-existing"], ["--resume", "--overwrite"],
                                        ["--restart", "--overwrite"]]))
        if self.random.random() < 0.4:
            first = self.random.randint(1, FRAMES)
            more += ["--render-frames", f"{first}-{self.random.randint(first, FRAMES)}"]
        if self.random.random() < 0.2:
            more.append("--keep-states")
        if self.random.random() < 0.25:
            self.seed = self.random.choice(SEEDS)
        more += ["--seed", self.seed]
        more += ["--threads", str(self.random.choice([1, 2]))]
        kill_after = self.random.uniform(0.01, self.seconds) if self.random.random() < 0.5 else None
        number = self.random.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM])
        before = self.frames()
        result = self.run(self.out, more, kill_after, number)
        step = f"{' '.join(more)}: " + (f"killed after {kill_after:.2f} s, " if kill_after else "") + f"{result[0]}"
        self.history.append(step + (" " + result[1].strip().splitlines()[-1] if result[1].strip() else ""))
        self.check(more, before, *result)
        return None

    def check(self, more, before, code, text):
        self.counts["runs"] += 1
        self.counts[{0: "succeeded", 1: "refused", 2: "refused"}.get(code, "killed")] += 1
        after = self.frames()
        if code not in (0, 1, -signal.SIGKILL, 128 + signal.SIGTERM, -signal.SIGTERM):
            raise Broken(f"ended with {code}: {text}")
        if "internal error" in text:
            raise Broken(text)
        may_replace = "--overwrite" in more or "--restart" in more
        for name, data in list(self.foreign.items()):
            if after.get(name) == data:
                continue
            if not may_replace and name not in self.granted:
                raise Broken(f"{name}, which somebody else has made, was replaced")
            del self.foreign[name]
            self.granted.discard(name)
        if ("--render-frames" in more or "--skip-existing" in more) and code not in (1, 2):
            self.has_parts = True
        if "--restart" in more and code not in (1, 2):
            self.granted |= set(self.foreign)  # stopped, it is gone on with by --resume, which may as much
        if "--skip-existing" in more:
            for name, data in before.items():
                if after.get(name) != data:
                    raise Broken(f"{name} was there and did not stay")
        for name, data in after.items():
            if name not in self.foreign and not small_scene.is_whole_png(data):
                raise Broken(f"{name} is half written")
        if code == 0 and re.search(r"frames? in \d", text):
            left = [path.name for path in self.out.rglob(".*.tmp.*")]
            if left:
                raise Broken("temporary files stayed: " + ", ".join(left))
        if code == 0:
            self.check_success(more, text, after)
        if code == 1:
            self.check_offers(more, text)

    def check_success(self, more, text, after):
        first, last = 1, FRAMES
        if "--render-frames" in more:
            first, last = map(int, more[more.index("--render-frames") + 1].split("-"))
        for number in range(first, last + 1):
            name = self.frame(number).name
            if name not in after:
                raise Broken(f"{name} is missing after a run that succeeded")
            if "--skip-existing" not in more and name in self.foreign:
                raise Broken(f"{name} is somebody else's after a run that succeeded")
        if "--render-frames" in more or "--skip-existing" in more:
            return  # other frames may be edited ones
        if f"painting {FRAMES} frames" in text:
            self.has_parts = False
        if not self.has_parts:  # a part may have started afresh, and differ
            self.counts["compared with an undisturbed run"] += 1
            if after != self.references[self.seed]:
                raise Broken(f"the frames are not those of an undisturbed run with --seed {self.seed}")
        verified = subprocess.run([self.program, "--verify", self.out / "fluidymation.json"], capture_output=True)
        if verified.returncode != 0:
            raise Broken("--verify: " + verified.stdout.decode() + verified.stderr.decode())

    def check_offers(self, more, text):
        """Each option that the refusal offers works, on a copy."""
        error = next((line for line in text.splitlines() if "error: " in line), "")
        if not error:
            raise Broken(f"refused without a word: {text}")
        offered = [option for option in ("--resume", "--restart", "--overwrite", "--skip-existing")
                   if re.search(rf"(?<!\w){option}\b", error.split("error: ", 1)[1])]
        if not offered:
            raise Broken(f"nothing is offered: {error}")
        for option in offered:
            self.counts["offers tried"] += 1
            copy = self.folder / "copy"
            shutil.rmtree(copy, ignore_errors=True)
            shutil.copytree(self.out, copy)
            kept = list(more)
            for other in ("--resume", "--restart", "--skip-existing"):
                if option != "--overwrite" and other in kept:
                    kept.remove(other)
            part = re.search(r"(--render-frames) (\d+-\d+) --resume", error)
            if part and option == "--resume":
                kept = [word for word in kept if not re.fullmatch(r"--render-frames|\d+-\d+", word)]
                kept += part.groups()
            code, said = self.run(copy, [*kept, option])
            # Two things may be wrong: then the next refusal is another one
            again = next((line for line in said.splitlines() if "error: " in line), "")
            if code != 0 and again.replace(str(copy), "") == error.replace(str(self.out), ""):
                raise Broken(f"{option} is offered, and refused in turn: {error}")
            if code != 0:
                self.counts["offers met by another refusal"] += 1
                if self.talk:
                    print(f"    {option} after\n      {error}\n      {again}")

    def step(self):
        word = self.random.random()
        if word < 0.05:
            shutil.rmtree(self.out, ignore_errors=True)
            self.foreign.clear()
            self.granted.clear()
            self.has_parts = False
            self.history = ["a new folder"]
        elif word < 0.35:
            self.history.append("somebody: " + self.edit())
        else:
            self.paint()
        if self.talk:
            print(self.history[-1], flush=True)


def main():
    arguments = parsed_arguments()
    with tempfile.TemporaryDirectory(prefix="storm-") as name:
        storm = Storm(arguments, pathlib.Path(name))
        end = time.monotonic() + 60 * arguments.minutes
        steps = 0
        while time.monotonic() < end and steps < arguments.steps:
            steps += 1
            try:
                storm.step()
            except Broken as fault:
                print(f"step {steps}: {fault}\nAfter:\n  " + "\n  ".join(storm.history))
                return 1
        print(f"{steps} steps: " + ", ".join(f"{n} {what}" for what, n in storm.counts.items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
