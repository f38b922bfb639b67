#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every option of `palpate --help` is in the man page and in the bash completion, and both are well-formed."""

import gzip
import os
import re
import shutil
import subprocess
import unittest

from installation import BUILD

PROGRAM = os.path.join(BUILD, "bin", "palpate")
DESCRIBED = os.path.join(BUILD, "share", "described")


def offered(line):
    """What bash offers after this command line."""
    words = line.split(" ")
    script = (f'source "{DESCRIBED}/palpate"; COMP_WORDS=({" ".join(repr(word) for word in words)}); '
              f'COMP_CWORD={len(words) - 1}; _palpate; printf "%s\\n" "${{COMPREPLY[@]}}"')
    return subprocess.run(["bash", "-c", script], check=True, capture_output=True, text=True).stdout.split()


class Described(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        told = subprocess.run([PROGRAM, "--help"], check=True, capture_output=True, text=True).stdout
        names = re.findall(r"^\s+(-.*)$", told, re.MULTILINE)
        cls.options = sorted({name for line in names
                              for name in re.findall(r"(?<![\w-])--?[a-z][\w-]*", re.split(r"(?<=\S)\s+(?=[^-\s])", line)[0])})
        with gzip.open(os.path.join(DESCRIBED, "palpate.1.gz"), "rt", encoding="utf-8") as file:
            cls.page = file.read()

    def test_there_are_options(self):
        self.assertGreater(len(self.options), 40)
        self.assertLessEqual({"--help", "--tool", "--no-auto", "--trial", "--map"}, set(self.options))

    def test_every_option_is_in_the_man_page(self):
        for option in self.options:
            self.assertRegex(self.page, r"\\fB" + re.escape(option.replace("-", "\\-")) + r"\\fR", option)

    def test_every_option_is_completed(self):
        self.assertLessEqual(set(self.options), set(offered("palpate -")))
        self.assertEqual(offered("palpate --scr"), ["--screenshot"])

    def test_values_are_completed(self):
        self.assertEqual(sorted(offered("palpate --scene ")), ["cylinder", "head", "phantom"])
        self.assertEqual(offered("palpate --tool sph"), ["sphere:"])
        self.assertEqual(sorted(offered("palpate --layer ")), ["none", "scan"])

    def test_the_man_page_is_well_formed(self):
        if not shutil.which("groff"):
            self.skipTest("groff is not installed")
        told = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=self.page, check=True,
                              capture_output=True, text=True)
        self.assertEqual(told.stderr, "")


if __name__ == "__main__":
    unittest.main()
