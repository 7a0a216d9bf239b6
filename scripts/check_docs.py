#!/usr/bin/python3
"""Checks what README.md, docs/ and the other Markdown files point to; prints every fault and exits with 1 if there is one.

    check_docs.py [--program FILE] [FOLDER]

- Relative links and images lead to files that are there, and their #anchors to headings.
- Every picture in docs/images is shown somewhere.
- With --program: every option (--word) that is written in code, in a line or in a span, is one of the program's, of its
  commands' or of the project's scripts', unless the line or span calls another program.

FOLDER is the project's, by default the one above this script.
"""

import argparse
import pathlib
import re
import subprocess
import sys

FENCE = re.compile(r"^ {0,3}(```|~~~)")
HEADING = re.compile(r"^#{1,6} +(.*?) *#*$")
LINK = re.compile(r"!?\[(?:[^\]\[]|\[[^\]]*\])*\]\(([^()\s]+)\)")
SPAN = re.compile(r"(`+)(.+?)\1", re.DOTALL)
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z0-9-]*")
COMMANDS = ("inspect", "preview", "mask", "layers")
# Programs whose options are none of ours, when the line or span calls them and not fluidymation.
OTHERS = re.compile(r"(?:^|[\s(/])(?:cmake|cpack|ctest|ffmpeg|git|apt|sbatch|scancel|squeue|qemu\S*|perf|clang\S*|dpkg\S*"
                    r"|brew|parallel|\w+\.(?:sh|py)|\.ci/run)(?=\s|$)")
# Options of other programs that are written without their program's name: Slurm's.
OF_OTHERS = {"--signal", "--cpus-per-task"}


def markdown_files(root):
    """Every Markdown file of the project, but for what builds and runs have left."""
    def is_left(path):
        return any(part in ("build", "output") or part.startswith(".") for part in path.relative_to(root).parts)

    return [path for path in sorted(root.rglob("*.md")) if not is_left(path)]


def without_fences(text):
    """The text with fenced blocks, indented lines and code spans emptied: there brackets are no links."""
    kept, fenced = [], False
    for line in text.split("\n"):
        if FENCE.match(line):
            fenced = not fenced
            line = ""
        kept.append("" if fenced or line.startswith("    ") else line)
    return SPAN.sub(lambda m: "\n" * m.group().count("\n"), "\n".join(kept))


def anchors(path):
    """The anchors that GitHub gives the headings of a file."""
    found, fenced, seen = set(), False, {}
    for line in path.read_text(encoding="utf-8").split("\n"):
        if FENCE.match(line):
            fenced = not fenced
        heading = None if fenced else HEADING.match(line)
        if not heading:
            continue
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(1)).lower()
        slug = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        again = seen.get(slug, 0)
        seen[slug] = again + 1
        found.add(f"{slug}-{again}" if again else slug)
    return found


def check_links(root, files):
    """Faults of relative links, and pictures that no file shows."""
    faults, shown = [], set()
    for path in files:
        for number, line in enumerate(without_fences(path.read_text(encoding="utf-8")).split("\n"), 1):
            for target in LINK.findall(line):
                if re.match(r"[a-z]+:", target):
                    continue
                name, _, anchor = target.partition("#")
                place = (path.parent / name).resolve() if name else path.resolve()
                where = f"{path.relative_to(root)}:{number}: {target}"
                if not place.exists():
                    faults.append(f"{where}: there is no such file")
                elif anchor and place.suffix == ".md" and anchor not in anchors(place):
                    faults.append(f"{where}: there is no such heading")
                shown.add(place)
    for picture in sorted((root / "docs/images").rglob("*.*")):
        if picture.resolve() not in shown:
            faults.append(f"{picture.relative_to(root)}: no page shows it")
    return faults


def commands_and_spans(text):
    """(line number, code) of each line of code, with those that go on after a backslash, and of each span."""
    prose, fenced, pending, begin = [], False, "", 0
    for number, line in enumerate(text.split("\n"), 1):
        if FENCE.match(line):
            fenced = not fenced
            prose.append("")
        elif fenced or line.startswith("    "):
            prose.append("")
            begin = begin if pending else number
            pending += line.strip()
            if pending.endswith("\\"):
                pending = pending[:-1] + " "
                continue
            yield begin, pending
            pending = ""
        else:
            prose.append(line)
    joined = "\n".join(prose)
    for span in SPAN.finditer(joined):
        yield joined.count("\n", 0, span.start()) + 1, span.group(2)


def script_options(root):
    """Options of the project's scripts, as their usage says, and of its benchmark."""
    found = set()
    for script in [*root.glob("scripts/**/*.sh"), *root.glob("scripts/**/*.py")]:
        text = script.read_text(encoding="utf-8")
        usage = [line for line in text.split("\n") if line.startswith("# ")]
        found |= set(OPTION.findall("\n".join(usage)))
        found |= set(re.findall(r"add_argument\(\s*\"(--[a-z][a-z0-9-]*)\"", text))
    for source in root.glob("tests/bench/*.cpp"):
        found |= set(re.findall(r"\"(--[a-z][a-z0-9-]*)[ \",]", source.read_text(encoding="utf-8")))
    return found


def known_options(program):
    """All options of the program and its commands, from their help."""
    found = set()
    for command in ((), *((name,) for name in COMMANDS)):
        answer = subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True)
        found |= set(OPTION.findall(answer.stdout))
    return found


def check_options(root, files, program):
    """Faults of options that the program does not have."""
    known = known_options(program) | script_options(root) | OF_OTHERS
    faults = []
    for path in files:
        for number, code in sorted(commands_and_spans(path.read_text(encoding="utf-8"))):
            if OTHERS.search(code) and "fluidymation " not in code:
                continue
            faults += [f"{path.relative_to(root)}:{number}: {option}: fluidymation has no such option"
                       for option in OPTION.findall(code) if option not in known]
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", metavar="FILE")
    parser.add_argument("folder", nargs="?", default=pathlib.Path(__file__).resolve().parent.parent, type=pathlib.Path)
    arguments = parser.parse_args()
    root = arguments.folder.resolve()
    files = markdown_files(root)
    if not files:
        sys.exit(f"check_docs.py: {root}: no Markdown files")
    faults = check_links(root, files)
    if arguments.program:
        faults += check_options(root, files, arguments.program)
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
