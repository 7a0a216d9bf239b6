#!/usr/bin/python3
"""Reads a shot list, and paints or checks a shot of it.

    shots.py names LIST                  names of the shots, one a line
    shots.py paint LIST NAME [OPTION..]  paints it, or goes on with it (--resume)
    shots.py check LIST NAME             compares its frames with their manifests (--verify)
    shots.py frames LIST NAME            the folder of its painted frames

A shot list is a table of tab-separated columns. Its first row names them: `name`, and options of fluidymation
without their dashes (`src-path`, `out-path`, `border-width`). Each further row is a shot: its name and the options'
values; where a cell is empty the option is not given. A column `options`, if there is one, holds what else is to be
given, as on the command line without quotes: `--keep-states --seed 3`. Empty lines and lines that begin with # do not
count. Paths are relative to the folder of the list, where the tool is started. Every shot has a folder
for its frames (`out-path`) of its own. NAME may also be @N, for the list's N-th shot.

The tool is the one of the environment variable FLUIDYMATION, else of this clone's build, else of PATH.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

WRONG_USAGE = 2
COMMANDS = ("names", "paint", "check", "frames")
SAFE_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")  # goes into names of files and jobs


def refuse(message):
    print(f"shots.py: {message}", file=sys.stderr)
    sys.exit(WRONG_USAGE)


def rows(path):
    """(line number, cells) of what counts in the list."""
    try:
        # utf-8-sig: spreadsheets put a byte order mark before the first column's name
        lines = pathlib.Path(path).read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        refuse(f"{path}: cannot be read ({error})")
    return [(number, [cell.strip() for cell in line.split("\t")])
            for number, line in enumerate(lines, 1) if line.strip() and not line.startswith("#")]


def columns_of(path, line, cells):
    for name in ("name", "out-path"):
        if name not in cells:
            refuse(f"{path}:{line}: no column '{name}'; wanted names of columns, separated by tabs")
    for name in cells:
        if not re.fullmatch(r"[a-z][a-z0-9-]*", name):
            refuse(f"{path}:{line}: column '{name}': wanted an option without its dashes, such as src-path")
        if cells.count(name) > 1:
            refuse(f"{path}:{line}: column '{name}': there twice")
    return cells


def read_list(path):
    """Shots by name, in the order of the list; each {column: value}."""
    table = rows(path)
    if not table:
        refuse(f"{path}: empty; wanted a row of column names, then a row a shot")
    columns = columns_of(path, *table[0])
    shots, folders = {}, {}
    for line, cells in table[1:]:
        if len(cells) > len(columns):
            refuse(f"{path}:{line}: {len(cells)} cells, but there are {len(columns)} columns")
        shot = {column: cell for column, cell in zip(columns, cells) if cell}
        name = shot.get("name", "")
        if not SAFE_NAME.fullmatch(name):
            refuse(f"{path}:{line}: name '{name}': wanted letters, digits, dots, dashes and underscores")
        if name in shots:
            refuse(f"{path}:{line}: name '{name}': there twice")
        if "out-path" not in shot:
            refuse(f"{path}:{line}: {name}: no out-path")
        folder = os.path.normpath(folder_of_frames(path, shot))
        if folder in folders:
            refuse(f"{path}:{line}: {name}: its frames would lie in the folder of those of {folders[folder]}")
        shots[name], folders[folder] = shot, name
    if not shots:
        refuse(f"{path}: no shots; wanted a row a shot below the names of the columns")
    return shots


def folder_of_frames(list_path, shot):
    return pathlib.Path(list_path).resolve().parent / pathlib.Path(shot["out-path"]).parent


def arguments(shot):
    result = []
    for column, value in shot.items():
        if column not in ("name", "options"):
            result.append(f"--{column}={value}")
    return result + shot.get("options", "").split()


def tool():
    built = pathlib.Path(__file__).resolve().parents[2] / "build/release/fluidymation"
    for candidate in (os.environ.get("FLUIDYMATION"), built, shutil.which("fluidymation")):
        if candidate and os.access(candidate, os.X_OK):
            return str(pathlib.Path(candidate).resolve())
    refuse("no fluidymation found; build it (README.md), or give its path in the variable FLUIDYMATION")


def paint(list_path, shot, more):
    """Becomes the tool, so that whoever started this one signals and waits for the tool itself."""
    given = arguments(shot) + more
    if "--restart" not in given and "--resume" not in given:
        given.append("--resume")
    program = tool()
    os.chdir(pathlib.Path(list_path).resolve().parent)
    os.execv(program, [program, *given])


def check(list_path, shot):
    folder = folder_of_frames(list_path, shot)
    manifests = sorted(folder.glob("*fluidymation.json"))
    if not manifests:
        print(f"{folder}: no manifest; nothing is painted there")
        return 1
    program = tool()
    return max(subprocess.run([program, "--verify", m], check=False).returncode for m in manifests)


def shot_called(name, shots, list_path):
    """By its name, or by @N its place in the list, from 1."""
    if re.fullmatch(r"@[0-9]{1,6}", name) and 1 <= int(name[1:]) <= len(shots):
        return list(shots.values())[int(name[1:]) - 1]
    if name in shots:
        return shots[name]
    refuse(f"'{name}': no such shot in {list_path}; there are {' '.join(shots)}, or @1 to @{len(shots)}")


def main(arguments_given):
    if arguments_given and arguments_given[0] in ("-h", "--help"):
        print(__doc__.strip())
        return 0
    if len(arguments_given) < 2 or arguments_given[0] not in COMMANDS:
        refuse(f"wanted {', '.join(COMMANDS)} and a shot list; see --help")
    command, list_path, *rest = arguments_given
    shots = read_list(list_path)
    if command == "names":
        print("\n".join(shots))
        return 0
    shot = shot_called(rest[0] if rest else "", shots, list_path)
    if command == "paint":
        paint(list_path, shot, rest[1:])
    if command == "frames":
        print(folder_of_frames(list_path, shot))
        return 0
    return check(list_path, shot)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
