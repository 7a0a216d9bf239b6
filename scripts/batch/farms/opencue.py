#!/usr/bin/env python3
"""Untested. Submits a shot list to OpenCue: a layer a shot, then one that checks frames and makes previews.

    opencue.py LIST SHOW [CORES]

Wanted: pyoutline and a reachable Cuebot (CUEBOT_HOSTS), and this clone and the list under the same path on all
hosts. CORES is what a shot gets (default 2); OMP_NUM_THREADS follows it. OpenCue ends frames with SIGKILL: a shot that
is retried goes on from its last saved state.
"""

import getpass
import pathlib
import subprocess
import sys

import outline
import outline.cuerun
from outline.modules.shell import ShellCommand

BATCH = pathlib.Path(__file__).resolve().parents[1]
DEFAULT_CORES = 2


def main(list_path, show, cores=DEFAULT_CORES):
    shot_list = str(pathlib.Path(list_path).resolve())
    shots = str(BATCH / "shots.py")
    names = subprocess.run([shots, "names", shot_list], check=True, capture_output=True,
                           text=True).stdout.split()
    job = outline.Outline(f"fluidymation-{pathlib.Path(list_path).stem}", shot="batch", show=show,
                          user=getpass.getuser())
    check = ShellCommand("check", command=[str(BATCH / "finish.sh"), "--previews", shot_list])
    for name in names:
        paint = ShellCommand(name, threads=float(cores), command=[
            "env", f"OMP_NUM_THREADS={int(cores)}", shots, "paint", shot_list, name])
        job.add_layer(paint)
        check.depend_all(paint)
    job.add_layer(check)
    outline.cuerun.launch(job, use_pycuerun=False)


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
