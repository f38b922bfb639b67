#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tutorial shows the output of its commands: each output block is compared with the program.

An output block follows the block of its command. "(...)" means any text. Lines that are not in the manual,
such as times, are not compared.
"""
import re
import subprocess
import unittest
from pathlib import Path

from run_scene import SCAN
from session import SessionCase, run

TUTORIAL = Path(__file__).resolve().parents[2] / "Plugin" / "Manual" / "Start" / "tutorial.md"
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def outputs():
    """(command or program text, expected lines) of each output block."""
    before = ("", "")
    for language, text in BLOCK.findall(TUTORIAL.read_text(encoding="utf-8")):
        if not text.startswith("./run") and not language and before[1].startswith("./run"):
            yield before[1].splitlines()[-1], text.splitlines()
        before = (language, text)


def pattern_of(line):
    return ".*".join(re.escape(part) for part in line.rstrip().split("(...)")) + "$"


class Tutorial(SessionCase):
    def check(self, expected, printed):
        for line in expected:
            with self.subTest(line=line):
                self.assertTrue(any(re.match(pattern_of(line), found) for found in printed.splitlines()),
                                f"the tutorial prints\n  {line}\nbut the program\n{printed}")

    def test_its_output_is_that_of_the_programs(self):
        found = list(outputs())
        self.assertEqual(len(found), 5)  # two of the head, two of the cylinder, one of Python
        saved = run("--scene", "cylinder", "--save", self.folder / "cylinder.vtp", "--no-pictures",
                    "--output", self.output)
        self.assertEqual(saved.returncode, 0, saved.stderr)
        for command, expected in found:
            words = command.split()
            if words[:2] == ["./run", "demo"]:
                arguments = [self.folder / word if word == "cylinder.vtp" else word
                             for word in words[2:] if word != "--offscreen"]
                if "cylinder.vtp" not in words and not SCAN.exists():
                    continue  # Debian's mricron-data is not installed
                result = run(*arguments, "--no-pictures", "--output", self.output)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.check(expected, result.stdout)
            else:
                self.assertEqual(words[:2], ["./run", "python"])
                self.check(expected, self.run_python(words[2]))

    def run_python(self, name):
        program = next(text for language, text in BLOCK.findall(TUTORIAL.read_text(encoding="utf-8"))
                       if language == "python")
        (self.folder / name).write_text(program, encoding="utf-8")
        result = subprocess.run(["/usr/bin/python3", name], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_a_stale_number_is_noticed(self):
        self.assertIsNone(re.match(pattern_of("  peak  force 0.1751 N"), "  peak  force 0.1723 N"))
        self.assertIsNotNone(re.match(pattern_of("  choice (...) at 5 %: (...)"), "  choice 4 laws, 2 mm at 5 %: there"))


if __name__ == "__main__":
    unittest.main()
