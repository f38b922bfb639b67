#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The arguments that `./run demo` passes to the program. Nothing is built: the program is replaced by `echo`."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

RUN = Path(__file__).resolve().parents[2] / "run"
# Replacements of functions of `run`, and of xvfb-run.
PARTS = """
build_release() { :; }
xvfb-run() { shift 3; "$@"; }
"""


class Demo(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        shutil.copy(RUN, self.folder / "run")
        parts, programs = self.folder / "Plugin/Run", self.folder / "build/release/bin"
        parts.mkdir(parents=True)
        programs.mkdir(parents=True)
        for part in ("packages", "build", "measure", "suites"):
            (parts / (part + ".sh")).write_text(PARTS, encoding="utf-8")
        (programs / "palpate").write_text('#!/bin/sh\necho "[$*]"\n', encoding="utf-8")
        (programs / "palpate").chmod(0o755)

    def given(self, *arguments, display=":7"):
        environment = {**os.environ, "DISPLAY": display}
        result = subprocess.run([str(self.folder / "run"), "demo", *arguments], env=environment, capture_output=True,
                                text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout.splitlines()[0]

    def test_offscreen_is_taken_at_any_place(self):
        for arguments in (["--offscreen", "a b.vtp"], ["a b.vtp", "--offscreen"]):
            output = self.folder / "build/demo"
            self.assertEqual(self.given(*arguments), "[--output %s a b.vtp]" % output)
        self.assertEqual(self.given("--depth", "1", "--offscreen", "--output", str(self.folder / "o")),
                         "[--depth 1 --output %s]" % (self.folder / "o"))

    def test_with_a_display_there_is_a_window(self):
        self.assertEqual(self.given(), "[--window]")
        self.assertEqual(self.given("a.vtp", "--depth", "1"), "[--window a.vtp --depth 1]")
        # The program opens the window with the map, so no option is added.
        self.assertEqual(self.given("a.nii", "--tissue", "1:0.1:0.4"), "[a.nii --tissue 1:0.1:0.4]")
        self.assertEqual(self.given("a.nii", "--tissue=1:0.1:0.4"), "[a.nii --tissue=1:0.1:0.4]")
        self.assertEqual(self.given("a.vtp", display=""), "[--output %s a.vtp]" % (self.folder / "build/demo"))


if __name__ == "__main__":
    unittest.main()
