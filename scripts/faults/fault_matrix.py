#!/usr/bin/env python3
"""Lets the system fail in every way we know while frames are painted, and checks what has to hold.

Prints one line a fault: whether what has to hold did, or what did not. In every row
  - the exit code is the one of README.md, and an error is one line that names the file;
  - no frame, manifest or state is half written, and no temporary file stays, but after kill -9 until
    the next run;
  - what is painted equals the undisturbed run's, byte for byte, as do frames and manifest of the run
    that goes on when the fault is gone.
Exit code 1 where any row failed. Rows that need what this machine does not have are skipped, and say so.

    scripts/faults/fault_matrix.py                 all of it: some minutes
    scripts/faults/fault_matrix.py --quick         few kills, no tmpfs: for every test run
    scripts/faults/fault_matrix.py --only 'disk|locale'
"""

import argparse
import errno
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import kill_and_resume
import small_scene
from fault_bench import MANIFEST, ROOT, Bench, Broken, Skipped, files_of


# ------------------------------------------------------------------------------------------------
# The rows: each raises Broken or Skipped, and may return a remark.


def killed(bench):
    """kill -9 at random times"""
    def command_of(out):
        return [str(bench.program), *small_scene.options(bench.scene, out), "--quiet", "--checkpoint-every", "1"]

    try:
        stages = kill_and_resume.kill_and_compare(command_of, bench.fresh(), bench.kills, seed=7)
    except kill_and_resume.Differs as difference:
        raise Broken(str(difference))
    return f"{sum(stages.values())} kills: " + ", ".join(f"{n} while {stage}" for stage, n in stages.most_common())


def interrupted(bench):
    """SIGINT and SIGTERM while painting"""
    for number in (signal.SIGINT, signal.SIGTERM):
        out = bench.fresh()
        result = bench.paused(out, THIRD, 1, lambda process: process.send_signal(number))
        if result.returncode != 128 + number:
            raise Broken(f"{number.name}: ended with {result.returncode}: {result.text.strip()}")
        bench.must_be_whole(out)
        bench.must_go_on(out)


THIRD = "/out/00003.png"  # opened by nobody, and renamed to when it is painted

DISK_FULL_PARTS = {"a frame": "00003.png", "a state": "state-", "the manifest": MANIFEST, "the times": "times.json"}


def disk_full_write(bench):
    """writes that fail with ENOSPC: frame, state, manifest, times"""
    return failing_writes(bench, errno.ENOSPC, "No space left on device")


def disk_error(bench):
    """writes that fail with EIO, ESTALE, EDQUOT (NFS)"""
    failing_writes(bench, errno.EIO, "Input/output error")
    if not bench.quick:
        failing_writes(bench, errno.ESTALE, "Stale file handle")
        failing_writes(bench, errno.EDQUOT, "Disk quota exceeded")


def failing_writes(bench, error, reason):
    for part in DISK_FULL_PARTS.values():
        for faults in ({}, {"AFTER": 20}, {"FLUSH": 1}):
            if bench.quick and faults and part != "state-":
                continue
            out = bench.fresh()
            result = bench.run(out, faults={"FILES": f"/.{part}", "ERROR": error, **faults})
            bench.must_fail(result, reason, part)
            bench.must_be_whole(out)
            bench.must_go_on(out)


def disk_full_tmpfs(bench):
    """a full disk (a tmpfs that is too small)"""
    if bench.quick:
        raise Skipped("only without --quick")
    disk = bench.folder / "disk"
    disk.mkdir()
    hit, painted = [], False
    size_kib = 16
    while not painted:
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size_kib}k", "tmpfs", disk],
                                 capture_output=True)
        if mounted.returncode != 0:
            raise Skipped("a tmpfs cannot be mounted here: " + mounted.stderr.decode().strip())
        try:
            out = disk / "out"
            result = bench.run(out)
            painted = result.returncode == 0
            if painted:
                bench.must_equal(out)
            else:
                bench.must_fail(result, disk, "No space left on device")
                bench.must_be_whole(out)
                hit.append(re.search(r"error: \S*?([^/: ]*)(: |$)", result.text).group(1))
                subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
                bench.must_go_on(out)
        finally:
            subprocess.run(["umount", disk], check=True)
        size_kib += 16
    return f"{len(hit)} sizes were too small, and named " + ", ".join(sorted(set(hit)))


def disk_full_waiting(bench):
    """a disk that fills up under the frames that wait for their turn (a tmpfs of 4 MiB)"""
    if bench.quick:
        raise Skipped("only without --quick")
    scene = bench.own_scene()
    small_scene.make_large_targets(scene, 640, bench.frame_count)  # 2 MB each, and 16 MiB wait in memory
    part = ("--render-frames", "1-2", "--opt-iterations", "1")
    reference = bench.fresh("large")
    bench.must_paint(bench.run(reference, *part, scene=scene))
    disk = bench.folder / "small_disk"
    disk.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "tmpfs", disk], capture_output=True)
    if mounted.returncode != 0:
        raise Skipped("a tmpfs cannot be mounted here: " + mounted.stderr.decode().strip())
    try:
        result = bench.run(disk / "out", *part, scene=scene)
        bench.must_fail(result, f"{disk}: the temporary file for frames that wait", "No space left on device",
                        "wanted more room there")
        if left := [path.name for path in disk.rglob("*")]:
            raise Broken("left over: " + ", ".join(left))
        room = os.statvfs(disk)
        if room.f_bfree < room.f_blocks - 1:  # the folder itself
            raise Broken(f"{room.f_blocks - room.f_bfree} blocks are still taken")
        subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
        bench.must_paint(bench.run(disk / "out", *part, scene=scene))
        for name, data in files_of(reference).items():
            if name.endswith(".png") and (disk / "out" / name).read_bytes() != data:
                raise Broken(f"{name} differs from the one painted elsewhere")
    finally:
        subprocess.run(["umount", disk], check=True)
    return None


def slow_writes(bench):
    """slow writes (20 ms each)"""
    out = bench.fresh()
    bench.must_paint(bench.run(out, faults={"FILES": str(out), "SLOW_MS": 20 if not bench.quick else 2}))
    bench.must_equal(out)


def read_only_folder(bench):
    """a read-only folder"""
    out = bench.fresh()
    out.mkdir()
    user = bench.give_to_ordinary_user()
    out.chmod(0o555)
    try:
        bench.must_fail(bench.run(out, user=user), out, "Permission denied")
    finally:
        out.chmod(0o755)
    if list(out.iterdir()):
        raise Broken("something was written")
    bench.must_go_on(out)


def read_only_while_running(bench):
    """a folder that becomes read-only while frames are painted"""
    out = bench.fresh()
    user = bench.give_to_ordinary_user()
    try:
        result = bench.paused(out, THIRD, 1, lambda _: out.chmod(0o555), user=user)
    finally:
        out.chmod(0o755)
    bench.must_fail(result, out, "Permission denied")
    # The third frame cannot even be renamed, nor its temporary name removed; the next run does that.
    bench.must_be_whole(out, leftovers=True)
    bench.must_go_on(out)


def permission_denied(bench):
    """permission denied: an input, the manifest's frame, a state"""
    scene = bench.own_scene()
    for name in ("src/00002.png", "mask/00003.png", "target/00004.png"):
        user = bench.give_to_ordinary_user()
        (scene / name).chmod(0)
        bench.must_fail(bench.run(bench.fresh(), scene=scene, user=user), scene / name, "Permission denied")
        (scene / name).chmod(0o644)
    out = bench.fresh()
    bench.run(out, faults={"FILES": "/.00004.png", "ERROR": errno.EIO})
    state = max((out / ".fluidymation").glob("state-*"))
    user = bench.give_to_ordinary_user()
    state.chmod(0)
    bench.must_fail(bench.run(out, "--resume", user=user), state, "Permission denied")
    state.chmod(0o644)
    bench.must_go_on(out)


def inputs_change(bench):
    """an input that is removed, replaced or truncated while it is read"""
    def remove(path):
        path.unlink()

    def replace(path):
        other = path.with_name("other")
        other.write_bytes(path.with_name("00001.png").read_bytes())
        other.replace(path)

    def truncate(path):
        with open(path, "r+b") as file:
            file.truncate(path.stat().st_size // 2)

    def rewrite(path):
        data = path.read_bytes()
        time.sleep(0.02)  # more than the clock of the file system
        path.write_bytes(data)

    ways = {"removed": remove, "replaced": replace, "truncated": truncate, "rewritten": rewrite}
    tried = 0
    for name in ("target/00004.png", "src/00002.png") if bench.quick else (
            "target/00001.png", "target/00004.png", "src/00002.png", "mask/00002.png"):
        opens = bench.count_opens(name)
        for way, change in ways.items():
            for times in (opens,) if bench.quick else range(1, opens + 1):
                scene, out = bench.own_scene(), bench.fresh()
                result = bench.paused(out, name, times, lambda _: change(scene / name), scene=scene)
                if result.returncode == 0:
                    raise Broken(f"{name} {way} before it was opened for the time {times} was not noticed")
                bench.must_fail(result, scene / name)
                bench.must_be_whole(out)
                tried += 1
    return f"{tried} moments"


def input_folder_vanishes(bench):
    """the input folder vanishes"""
    for name, times in (("target", 1), ("target", 2), ("src", 2), ("mask", 1)):
        scene, out = bench.own_scene(), bench.fresh()
        result = bench.paused(out, f"{name}/00002.png", times,
                              lambda _: (scene / name).rename(scene / "gone"), scene=scene)
        bench.must_fail(result, scene / name, "No such file or directory")
        bench.must_be_whole(out)
        (scene / "gone").rename(scene / name)
        bench.must_go_on(out, scene=scene)


def output_changes(bench):
    """a painted frame is removed, changed or truncated while running; its folder vanishes"""
    def removed(path):
        path.unlink()

    def changed(path):
        path.write_bytes(b"something else")

    def truncated(path):
        path.write_bytes(path.read_bytes()[:50])

    for spoil in (removed, changed, truncated):
        out = bench.fresh()

        bench.must_paint(bench.paused(out, THIRD, 1, lambda _: spoil(out / "00001.png")))
        result = bench.end(bench.start_command([bench.program, "--verify", out / MANIFEST]))
        if result.returncode != 1 or "00001.png" not in result.text:
            raise Broken(f"--verify did not name the frame that was {spoil.__name__}: {result.text.strip()}")

    out = bench.fresh()
    result = bench.paused(out, THIRD, 1, lambda _: out.rename(bench.fresh("moved")))
    bench.must_fail(result, out)
    bench.must_be_whole(bench.folder / "moved", leftovers=True)


def two_runs(bench):
    """two runs into one folder"""
    out, first_pid = bench.fresh(), []

    def second(_):
        result = bench.run(out)
        bench.must_fail(result, out)
        pids = re.findall(r"\b\d+\b", result.text)
        if not pids:
            raise Broken("the other run is not named: " + result.text.strip())
        for pid in pids:
            if pathlib.Path(f"/proc/{pid}/exe").exists() and \
                    os.path.samefile(f"/proc/{pid}/exe", bench.program):
                first_pid.append(pid)

    bench.must_paint(bench.paused(out, THIRD, 1, second))
    if not first_pid:
        raise Broken("the number that is named is not the first run's")
    bench.must_equal(out)


def out_of_memory(bench):
    """out of memory (ulimit -v)"""
    mib, failed, painted = 1 << 20, 0, 0
    for limit in range(20, 320, 50 if bench.quick else 6):
        out = bench.fresh()
        result = bench.run(out, limit=limit * mib)
        if result.returncode == 0:
            painted += 1
            bench.must_equal(out)
            continue
        if result.returncode == 127 and "error while loading shared libraries" in result.text:
            continue  # not even the program fits
        failed += 1
        bench.must_fail(result)
        if not re.search("memory|Cannot allocate|threads?", result.text):
            raise Broken(f"{limit} MiB: memory is not named: {result.text.strip()}")
        bench.must_be_whole(out)
        if out.exists():
            bench.must_go_on(out)
    if not painted or not failed:
        raise Broken(f"no limit between too little and enough: {failed} failed, {painted} painted")
    return f"{failed} limits were too small, {painted} enough"


def clock_backwards(bench):
    """a clock that runs backwards"""
    out = bench.fresh()
    bench.must_paint(bench.run(out, faults={"CLOCK": 1}))
    bench.must_equal(out)
    out = bench.fresh()
    result = bench.run(out, faults={"CLOCK": 1, "FILES": "/.00004.png", "ERROR": errno.EIO})
    bench.must_fail(result, "00004.png")
    bench.must_go_on(out)


def names_not_utf8(bench):
    """names that are no UTF-8"""
    scene = bench.own_scene()
    odd = scene / os.fsdecode(b"\xff\xfe odd")
    try:
        odd.mkdir()
    except OSError as error:
        raise Skipped(f"this file system does not take them: {error}")
    for name in ("src", "mask", "target"):
        (scene / name).rename(odd / name)
    out = odd / "out"
    pattern = os.fsdecode(b"\xe9%05d.png")
    command = [bench.program, *small_scene.options(odd, out)]
    command[command.index(f"{out}/%05d.png")] = f"{out}/{pattern}"
    result = bench.end(bench.start_command([*command, "--checkpoint-every", "1"],
                                           faults={"FILES": "00004.png", "ERROR": errno.ENOSPC}))
    bench.must_fail(result, "00004.png", "No space left on device")
    bench.must_paint(bench.end(bench.start_command([*command, "--resume"])))
    frames = {path.name[1:]: path.read_bytes() for path in out.glob("*.png")}
    if frames != {name: data for name, data in bench.expected.items() if name.endswith(".png")}:
        raise Broken("the frames differ from the undisturbed run's")
    (manifest,) = out.glob("*" + MANIFEST)
    bench.must_paint(bench.end(bench.start_command([bench.program, "--verify", manifest])))
    (out / pattern.replace("%05d", "00002")).unlink()
    result = bench.end(bench.start_command([bench.program, "--verify", manifest]))
    if result.returncode != 1 or "00002.png: missing" not in result.text:
        raise Broken("--verify does not see a missing frame: " + result.text.strip())


def decimal_comma(bench):
    """a locale with decimal comma"""
    name = "de_DE.UTF-8"
    places = bench.folder / "locales"
    places.mkdir(exist_ok=True)
    if shutil.which("localedef"):
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", places / name], capture_output=True)
    # Where it could not be made the system's own is taken.
    if any(places.iterdir()):
        os.environ["LOCPATH"] = str(places)
    os.environ["LC_ALL"] = name
    try:
        out = bench.fresh()
        result = bench.run(out, "--lambda", "2.0", faults={"LOCALE": name})
        if result.returncode == 77:
            raise Skipped(f"there is no locale {name}, and none could be made")
        bench.must_paint(result)
        bench.must_equal(out)
        result = bench.run(bench.fresh(), "--lambda", "1,5", faults={"LOCALE": name})
        bench.must_fail(result, "--lambda 1,5", code=2)
    finally:
        del os.environ["LC_ALL"]
        os.environ.pop("LOCPATH", None)


ROWS = [killed, interrupted, disk_full_write, disk_full_tmpfs, disk_full_waiting, disk_error, slow_writes,
        read_only_folder, read_only_while_running, permission_denied, inputs_change, input_folder_vanishes,
        output_changes, two_runs, out_of_memory, clock_backwards, names_not_utf8, decimal_comma]


def parsed_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/fluidymation"))
    parser.add_argument("--library", help="built from tests/support/fault_injection.cpp (default: built now)")
    parser.add_argument("--quick", action="store_true", help="few kills and a tiny scene")
    parser.add_argument("--kills", type=int, help="at least so many (default 50; 4 with --quick)")
    parser.add_argument("--only", default="", help="rows whose name or description this regular expression finds")
    return parser.parse_args()


def main():
    arguments = parsed_arguments()
    failures = 0
    with tempfile.TemporaryDirectory(prefix="fault-matrix-") as temporary:
        folder = pathlib.Path(temporary)
        folder.chmod(0o755)
        bench = Bench(arguments, folder)
        print(f"{bench.frame_count} frames; an undisturbed run takes {bench.seconds:.2f} s")
        for row in ROWS:
            if not re.search(arguments.only, row.__name__ + " " + row.__doc__):
                continue
            begun = time.monotonic()
            try:
                state, remark = "holds", row(bench) or ""
            except Skipped as reason:
                state, remark = "skipped", str(reason)
            except Broken as reason:
                state, remark = "BROKEN", str(reason)
                failures += 1
            seconds = time.monotonic() - begun
            print(f"{state:8} {seconds:6.1f} s  {row.__doc__}" + (f" ({remark})" if remark else ""), flush=True)
    print("all that was tried holds" if failures == 0 else f"{failures} rows are broken")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
