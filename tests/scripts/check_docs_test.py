#!/usr/bin/python3
"""Tests of scripts/check_docs.py: check_docs_test.py CHECK_DOCS_PY. A stand-in takes the tool's place."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = str(pathlib.Path(sys.argv.pop()).resolve())
TOOL = "#!/bin/sh\necho '  --border-width X   width'\n"


class CheckDocs(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "docs/images").mkdir(parents=True)
        self.tool = self.folder / "tool"
        self.tool.write_text(TOOL)
        self.tool.chmod(0o755)

    def check(self, text):
        """Faults of a README.md, and that the exit code says whether there are any."""
        (self.folder / "README.md").write_text(text)
        answer = subprocess.run([sys.executable, CHECK, "--program", str(self.tool), str(self.folder)],
                                capture_output=True, text=True)
        self.assertEqual(answer.stderr, "")
        self.assertEqual(answer.returncode, 1 if answer.stdout else 0)
        return answer.stdout.splitlines()

    def test_links_that_lead_somewhere_are_no_faults(self):
        (self.folder / "docs/a.md").write_text("# One, `two` and *three*\n")
        self.assertEqual(self.check("# Top\n[a](docs/a.md), [b](docs/a.md#one-two-and-three), [c](#top), [d](https://example.org/x)"), [])

    def test_missing_files_headings_and_pictures_are_named_with_their_line(self):
        (self.folder / "docs/a.md").write_text("# One\n")
        self.assertEqual(self.check("# Top\n[a](docs/b.md)\n[b](docs/a.md#two) ![c](docs/images/c.png)\n[d](#bottom)"),
                         ["README.md:2: docs/b.md: there is no such file", "README.md:3: docs/a.md#two: there is no such heading",
                          "README.md:3: docs/images/c.png: there is no such file", "README.md:4: #bottom: there is no such heading"])

    def test_links_of_pages_begin_at_the_page(self):
        (self.folder / "docs/a.md").write_text("[a](images/a.png) [b](docs/images/a.png)\n")
        (self.folder / "docs/images/a.png").touch()
        self.assertEqual(self.check("text"), ["docs/a.md:1: docs/images/a.png: there is no such file"])

    def test_code_holds_no_links_and_headings_of_code_are_none(self):
        self.assertEqual(self.check("`[a](b)`\n\n    [a](b)\n\n```\n[a](b)\n# Top\n```\n[c](#top)"), ["README.md:9: #top: there is no such heading"])

    def test_pictures_that_nobody_shows_are_named(self):
        (self.folder / "docs/images/a.png").touch()
        self.assertEqual(self.check("text"), ["docs/images/a.png: no page shows it"])

    def test_options_are_the_programs(self):
        fault = "fluidymation has no such option"
        self.assertEqual(self.check("`--border-width 3` `--border-widht 3`\n\n    fluidymation \\\n      --old 1\n"),
                         [f"README.md:1: --border-widht: {fault}", f"README.md:3: --old: {fault}"])

    def test_options_of_other_programs_are_theirs(self):
        self.assertEqual(self.check("`cmake --preset x`\n\n    scripts/demo.sh --help\n"), [])

    def test_options_of_scripts_are_known_by_themselves(self):
        (self.folder / "scripts").mkdir()
        (self.folder / "scripts/a.sh").write_text("#!/bin/sh\n# Usage: scripts/a.sh [--fast]\ntrue --slow\n")
        self.assertEqual(self.check("`--fast` and `--slow`"), ["README.md:1: --slow: fluidymation has no such option"])


if __name__ == "__main__":
    unittest.main()
