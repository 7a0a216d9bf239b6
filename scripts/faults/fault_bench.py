"""Runs the tool with faults and checks what has to hold in any case: what the rows of the matrix share."""

import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import time

import small_scene

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANIFEST = "fluidymation.json"
NOBODY = 65534
PATIENCE_S = 120  # for one run; one that takes longer counts as hung


class Broken(Exception):
    """What had to hold and did not."""


class Skipped(Exception):
    """Why a row cannot be tried here."""


class Bench:
    """The program, the library that makes calls fail, a scene and what an undisturbed run makes of it."""

    def __init__(self, arguments, folder):
        self.folder = folder
        self.quick = arguments.quick
        self.kills = arguments.kills or (4 if arguments.quick else 50)
        # Copies, so that an ordinary user can run them wherever the originals lie
        self.program = folder / "fluidymation"
        shutil.copy(arguments.program, self.program)
        self.library = folder / "fault_injection.so"
        if arguments.library:
            shutil.copy(arguments.library, self.library)
        else:
            source = ROOT / "tests/support/fault_injection.cpp"
            subprocess.run(["c++", "-std=c++17", "-shared", "-fPIC", "-o", self.library, source, "-ldl"], check=True)
        self.scene = folder / "scene"
        self.frame_count = 6 if arguments.quick else 12
        small_scene.make(self.scene, 40 if arguments.quick else 160, self.frame_count)
        reference = folder / "reference"
        begun = time.monotonic()
        self.must_paint(self.run(reference))
        self.seconds = time.monotonic() - begun
        self.expected = files_of(reference)

    # Running

    def start(self, out, *more, scene=None, faults=None, limit=None, user=None):
        """faults: variables of the library by name, without their prefix. limit: address space in bytes."""
        command = [self.program, *small_scene.options(scene or self.scene, out)]
        command += ["--threads", "2", "--checkpoint-every", "1", *more]
        return self.start_command(command, faults, limit, user)

    def start_command(self, command, faults=None, limit=None, user=None):
        environment = dict(os.environ, OMP_WAIT_POLICY="passive")
        if faults:
            environment["LD_PRELOAD"] = str(self.library)
            for name, value in faults.items():
                environment["FLUIDYMATION_FAULT_" + name] = str(value)

        def prepare():
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, signal.SIG_DFL)  # a shell's background jobs ignore some
            if limit:
                resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

        ids = {"user": user, "group": user, "extra_groups": []} if user else {}
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
                                preexec_fn=prepare, cwd=self.folder, **ids)

    @staticmethod
    def end(process):
        try:
            out, err = process.communicate(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            raise Broken(f"still running after {PATIENCE_S} s")
        process.text = (out + err).decode(errors="surrogateescape")
        return process

    def run(self, out, *more, **how):
        return self.end(self.start(out, *more, **how))

    def paused(self, out, pause, times, action, *more, scene=None, user=None):
        """Runs until a path that contains `pause` is opened or renamed to for the given time; then calls
        `action`, with the process, and lets the run go on."""
        flag = self.folder / "pause-flag"
        process = self.start(out, *more, scene=scene, user=user,
                             faults={"PAUSE": pause, "PAUSE_AT": times, "FLAG": flag})
        begun = time.monotonic()
        while not flag.exists():
            if process.poll() is not None:
                raise Broken(f"never came to {pause} for the time {times}: {self.end(process).text}")
            if time.monotonic() - begun > PATIENCE_S:
                process.kill()
                raise Broken("never came to where it should pause")
            time.sleep(0.005)
        try:
            action(process)
        finally:
            flag.unlink(missing_ok=True)
        return self.end(process)

    def count_opens(self, name):
        """How often an input is opened in a run."""
        times = 1
        while True:
            try:
                self.paused(self.fresh("count"), f"scene/{name}", times, lambda _: None)
            except Broken:
                return times - 1
            times += 1

    def give_to_ordinary_user(self):
        """Root is not held back by permissions: gives everything to somebody who is. Returns whom to run as, or
        None for the caller."""
        if os.geteuid() != 0:
            return None
        for path in (self.folder, *self.folder.rglob("*")):
            os.chown(path, NOBODY, NOBODY, follow_symlinks=False)
        return NOBODY

    # What has to hold

    @staticmethod
    def must_paint(result):
        if result.returncode != 0:
            raise Broken(f"ended with {result.returncode}: {result.text.strip()}")

    @staticmethod
    def must_fail(result, *parts, code=1):
        """With this code, and in one line of errors or more, each with all these parts."""
        errors = [line for line in result.text.splitlines() if line.startswith("fluidymation: error: ")]
        if result.returncode != code:
            raise Broken(f"ended with {result.returncode}, not {code}: {result.text.strip()}")
        if not errors:
            raise Broken(f"no line of errors: {result.text.strip()}")
        for error in errors:
            for part in parts:
                if str(part) not in error:
                    raise Broken(f"'{part}' is not in '{error}'")

    def must_be_whole(self, out, leftovers=False):
        """All that is there is as the undisturbed run made it; states are checked by going on."""
        if not out.exists():
            return
        for path in out.rglob("*"):
            if not leftovers and re.match(r"\..*\.tmp\.", path.name):
                raise Broken(f"a temporary file stayed: {path.name}")
        for name, data in files_of(out).items():
            if name.endswith(".png") and not small_scene.is_whole_png(data):
                raise Broken(f"{name} is half written")
            if name.endswith(".png") and data != self.expected.get(name):
                raise Broken(f"{name} differs from the undisturbed run's")

    def must_go_on(self, out, *more, scene=None):
        """With --resume, to the undisturbed run's frames and manifest."""
        self.must_paint(self.run(out, "--resume", *more, scene=scene))
        self.must_equal(out)
        left = sorted(path.name for path in (out / ".fluidymation").iterdir())
        if left != ["times.json"]:
            raise Broken("left over: " + ", ".join(left))

    def must_equal(self, out):
        found = files_of(out)
        names = sorted(name for name in self.expected.keys() | found.keys()
                       if self.expected.get(name) != found.get(name))
        if names:
            raise Broken("these differ from the undisturbed run's: " + ", ".join(names))

    # Folders

    def fresh(self, name="out"):
        """A folder that is not there yet."""
        path = self.folder / name
        shutil.rmtree(path, ignore_errors=True)
        return path

    def own_scene(self):
        """A copy of the scene that may be spoiled."""
        path = self.fresh("spoiled")
        shutil.copytree(self.scene, path)
        return path


def files_of(folder):
    """Frames and manifest by name. The manifest without the place of inputs and frames."""
    files = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}
    if MANIFEST in files:
        files[MANIFEST] = re.sub(rb'"--[a-z-]*path": ("[^"]*"|\{[^}]*\})', b"", files[MANIFEST])
    return files
