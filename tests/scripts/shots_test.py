#!/usr/bin/python3
"""Tests of scripts/batch/shots.py: shots_test.py SHOTS_PY. A stand-in takes the tool's place."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SHOTS = str(pathlib.Path(sys.argv.pop()).resolve())
TOOL = '#!/bin/sh\npwd\nfor argument; do echo "[$argument]"; done\n'


class Shots(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name).resolve()
        self.tool = self.folder / "tool"
        self.tool.write_text(TOOL)
        self.tool.chmod(0o755)

    def run_shots(self, text, command, *more):
        path = self.folder / "list.tsv"
        path.write_bytes(text.encode())
        return subprocess.run([SHOTS, command, path, *more], capture_output=True, text=True, check=False,
                              cwd="/", env={"FLUIDYMATION": str(self.tool), "PATH": "/usr/bin:/bin"})

    def refused(self, text, message):
        result = self.run_shots(text, "names")
        self.assertEqual(result.returncode, 2)
        self.assertIn(message, result.stderr)

    def test_paints_in_the_lists_folder_and_goes_on(self):
        text = ("# a comment\nname\tsrc-path\tseed\tout-path\toptions\n"
                "\na\ts p/%d.png\t\ta/%d.png\t\r\n"
                "b\tt/%d.png\t7\tb/%d.png\t--keep-states  --src-frames 3\n")
        self.assertEqual(self.run_shots(text, "names").stdout, "a\nb\n")
        first = self.run_shots(text, "paint", "a", "--quiet").stdout.splitlines()
        self.assertEqual(first, [str(self.folder), "[--src-path=s p/%d.png]", "[--out-path=a/%d.png]",
                                 "[--quiet]", "[--resume]"])
        second = self.run_shots(text, "paint", "@2", "--restart").stdout.splitlines()
        self.assertEqual(second[1:], ["[--src-path=t/%d.png]", "[--seed=7]", "[--out-path=b/%d.png]",
                                      "[--keep-states]", "[--src-frames]", "[3]", "[--restart]"])

    def test_takes_what_spreadsheets_write(self):
        self.assertEqual(self.run_shots("\ufeffname\tout-path\r\na\tx/%d.png\r\n", "names").stdout, "a\n")

    def test_names_the_place_of_a_mistake(self):
        self.refused("", "empty")
        self.refused("name\tout-path\n", "no shots")
        self.refused("name,out-path\n", "list.tsv:1: no column 'name'")
        self.refused("name\tout-path\t--seed\n", "list.tsv:1: column '--seed'")
        self.refused("name\tout-path\tseed\tseed\n", "'seed': there twice")
        self.refused("name\tout-path\na\tx/%d.png\na\ty/%d.png\n", "list.tsv:3: name 'a': there twice")
        self.refused("name\tout-path\n../a\tx/%d.png\n", "list.tsv:2: name '../a'")
        self.refused("name\tout-path\na\tx/%d.png\nb\t./x/%d.png\n", "of those of a")
        self.refused("name\tout-path\na\tx/%d.png\t5\n", "3 cells, but there are 2 columns")
        self.refused("name\tout-path\na\n", "no out-path")

    def test_knows_no_other_shot(self):
        for name in ("b", "@0", "@2", "@", ""):
            result = self.run_shots("name\tout-path\na\tx/%d.png\n", "paint", name)
            self.assertEqual((result.returncode, result.stdout), (2, ""), name)
            self.assertIn("no such shot", result.stderr)

    def test_checks_every_manifest_beside_the_frames(self):
        text = "name\tout-path\na\tx/%d.png\n"
        self.assertEqual(self.run_shots(text, "check", "a").returncode, 1)
        (self.folder / "x").mkdir()
        (self.folder / "x/fluidymation.json").touch()
        self.assertIn("[--verify]", self.run_shots(text, "check", "a").stdout)
        self.tool.write_text("#!/bin/sh\nexit 1\n")
        self.assertEqual(self.run_shots(text, "check", "a").returncode, 1)


if __name__ == "__main__":
    unittest.main()
