#!/usr/bin/python3
"""Paints pairs of exemplar and target with several sets of options and compares the figures.

    measure.py --judge quality.py --pairs PAIRS.tsv --variants VARIANTS.tsv --out DIR
               [--data DIR] [--program FILE ...] [--frames N] [--jobs N] [--pair NAME ...] [--masks-as-given]

--judge is a program that compares a painting with its exemplar and target (`judge_command` has its
options), and writes JSON: {"metrics": {row: {"title": ..., "value": ..., "score": ...}}}. PAIRS.tsv
has the columns name, exemplar folder (with rgb/ and mask/), target folder, first target frame, mask
blur (sigma in px, for both sequences), further options; "{data}" in a folder stands for --data. VARIANTS.tsv has the columns name, options and, if wanted, the program to use
instead of --program. Lines that begin with "#" are skipped.

With --masks-as-given the tool smooths the masks by its own defaults, and the judge does not smooth them.

What has been painted and judged already is kept as long as program, judge and command are the same.
Writes DIR/figures.tsv (variant, pair, row, value) and DIR/table.md (rows x variants, the mean over
all pairs, then each pair), and prints the first part of it.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

DEFAULT_PROGRAM = "build/release/fluidymation"
MASK_THRESHOLD = "0.3"  # the tool's default, so that tool and judge see the same masks
SECONDS = "processor seconds per frame"  # a row of our own


def lines(path, columns):
    """Fields of the lines of a TSV file that are neither empty nor comments."""
    for text in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
        if not text.strip() or text.startswith("#"):
            continue
        fields = [field.strip() for field in text.split("\t")]
        if len(fields) > len(columns):
            sys.exit(f"measure.py: {path}: {text!r}: wanted at most {len(columns)} columns")
        yield dict(zip(columns, fields + [""] * (len(columns) - len(fields))))


def digest(path):
    """What tells one build of the program from another."""
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def paint_command(program, pair, options, frames, out):
    """The command line that paints `frames` frames of a pair into `out`."""
    exemplar = pathlib.Path(pair["exemplar"])
    return [
        program,
        "--src-path", str(exemplar / "rgb/%05d.png"),
        "--src-mask-path", str(exemplar / "mask/%05d.png"),
        "--target-path", str(pathlib.Path(pair["target"]) / "%05d.png"),
        "--target-start", pair["start"], "--target-frames", str(frames),
        "--out-path", str(out / "%05d.png"), "--quiet", "--threads", "1",
        *options,
    ]  # fmt: skip


def settings(words):
    """Options and their values from a list of alternating words; exits at what is none."""
    names, values = words[::2], words[1::2]
    if len(names) != len(values) or any(not n.startswith("--") or "=" in n for n in names):
        sys.exit(f"measure.py: {shlex.join(words)}: wanted pairs of --option and value")
    return dict(zip(names, values))


def smoothing(options, masks_as_given):
    """What the judge has to be told to see the masks that the tool sees; nothing where it is to see them as given."""
    if masks_as_given:
        return []
    if "--target-blur-sigma" in options:
        sys.exit("measure.py: --target-blur-sigma: the judge smooths both sequences alike")
    threshold = options.get("--mask-threshold", MASK_THRESHOLD)
    return ["--mask-blur", options["--blur-sigma"], "--mask-threshold", threshold]


def judge_command(judge, pair, smoothed, frames, out, result):
    """The command line that judges what `paint_command` has painted, with masks that are `smoothed` like this."""
    exemplar = pathlib.Path(pair["exemplar"])
    return [
        "/usr/bin/python3", judge, "--quick",
        "--style-rgb", str(exemplar / "rgb/%05d.png"),
        "--style-mask", str(exemplar / "mask/%05d.png"),
        "--target-mask", str(pathlib.Path(pair["target"]) / "%05d.png"),
        "--target-start", pair["start"], "--frames", str(frames),
        "--output", str(out / "%05d.png"), "--output-start", pair["start"],
        *smoothed,
        "--json", str(result),
    ]  # fmt: skip


def run(command, environment=None):
    """Runs a command and returns its processor time, s, which other work hardly changes.

    Raises RuntimeError with its complaint when it fails.
    """
    with tempfile.TemporaryFile("w+", encoding="utf-8") as complaint:
        process = subprocess.Popen(
            command, stdout=subprocess.DEVNULL, stderr=complaint, env=environment
        )
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            complaint.seek(0)
            raise RuntimeError(f"{shlex.join(command)}\n{complaint.read()[-2000:]}")
    return usage.ru_utime + usage.ru_stime


def figures_of(judged):
    """What the judge says in a JSON file: {row: [title, value, score]}."""
    metrics = json.loads(judged.read_text(encoding="utf-8"))["metrics"]
    return {row: [m["title"].strip(), m["value"], m["score"]] for row, m in metrics.items()}


def measure(arguments, pair, variant):
    """Figures of one variant on one pair: {row: value}, {row: title}."""
    folder = arguments.out / variant["name"] / pair["name"]
    program = variant["program"] or arguments.program
    # What a variant says replaces what the pair says
    options = {
        **({} if arguments.masks_as_given else {"--blur-sigma": pair["blur"]}),
        **settings(shlex.split(pair["options"])),
        **settings(shlex.split(variant["options"])),
    }
    words = [word for option in options.items() for word in option]
    command = paint_command(program, pair, words, arguments.frames, folder)
    smoothed = smoothing(options, arguments.masks_as_given)
    stamp = "\n".join(
        [digest(program), digest(arguments.judge), shlex.join(command), shlex.join(smoothed), ""]
    )
    result = folder / "figures.json"
    if result.exists() and (folder / "command").read_text(encoding="utf-8") == stamp:
        return json.loads(result.read_text(encoding="utf-8"))
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    seconds = run(command, {**os.environ, "OMP_WAIT_POLICY": "passive"})
    judged = folder / "judged.json"
    run(judge_command(arguments.judge, pair, smoothed, arguments.frames, folder, judged))
    figures = figures_of(judged)
    painted = max(1, len(list(folder.glob("*.png"))))
    figures["seconds"] = [SECONDS, seconds / painted, None]
    (folder / "command").write_text(stamp, encoding="utf-8")
    result.write_text(json.dumps(figures), encoding="utf-8")
    return figures


def mean(values):
    """Mean of the numbers among `values`; None where there are none."""
    numbers = [value for value in values if isinstance(value, (int, float))]
    return sum(numbers) / len(numbers) if numbers else None


def shown(value):
    """A figure as it stands in a table."""
    return "n/a" if value is None else f"{value:.3f}"


def table(title, rows, variants, cell):
    """A Markdown table of rows x variants."""
    text = [f"### {title}", "", "| row | " + " | ".join(variants) + " |"]
    text.append("|---" * (len(variants) + 1) + "|")
    for row, name in rows.items():
        text.append(f"| {name} | " + " | ".join(cell(row, v) for v in variants) + " |")
    return "\n".join(text) + "\n"


def main():
    """Reads the command line, measures everything, writes the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--judge", required=True)
    parser.add_argument("--pairs", required=True)
    parser.add_argument("--variants", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--data", default="")
    parser.add_argument("--program", default=DEFAULT_PROGRAM)
    parser.add_argument("--frames", type=int, default=16)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--pair", action="append", help="only this pair; may be repeated")
    parser.add_argument("--masks-as-given", action="store_true")
    arguments = parser.parse_args()

    pairs = list(lines(arguments.pairs, ["name", "exemplar", "target", "start", "blur", "options"]))
    pairs = [p for p in pairs if not arguments.pair or p["name"] in arguments.pair]
    for pair in pairs:
        for key in ("exemplar", "target"):
            pair[key] = pair[key].replace("{data}", arguments.data)
    variants = list(lines(arguments.variants, ["name", "options", "program"]))

    figures = {}
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        tasks = {
            pool.submit(measure, arguments, pair, variant): (variant["name"], pair["name"])
            for variant in variants
            for pair in pairs
        }
        for task in concurrent.futures.as_completed(tasks):
            try:
                figures[tasks[task]] = task.result()
            except RuntimeError as failure:
                pool.shutdown(cancel_futures=True)
                sys.exit(f"measure.py: failed: {failure}")
            print(*tasks[task], file=sys.stderr)

    names = [variant["name"] for variant in variants]
    rows = {row: figure[0] for some in figures.values() for row, figure in some.items()}
    with (arguments.out / "figures.tsv").open("w", encoding="utf-8") as out:
        for (variant, pair), some in sorted(figures.items()):
            for row, figure in some.items():
                print(variant, pair, row, figure[1], figure[2], sep="\t", file=out)

    def average(row, variant):
        return shown(mean([figures[variant, p["name"]].get(row, [0, None])[1] for p in pairs]))

    def single(pair):
        return lambda row, variant: shown(figures[variant, pair].get(row, [0, None])[1])

    means = table(f"Mean of {len(pairs)} pairs", rows, names, average)
    each = [table(p["name"], rows, names, single(p["name"])) for p in pairs]
    (arguments.out / "table.md").write_text("\n".join([means, *each]), encoding="utf-8")
    print(means)


if __name__ == "__main__":
    main()
