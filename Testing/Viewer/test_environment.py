# SPDX-License-Identifier: BSD-3-Clause
"""A missing or unsuitable environment of the program: display, scan, folders."""
import re
import unittest
from pathlib import Path

from bodies import sphere, write
from session import PICTURES, SessionCase, run

SCAN = Path("/usr/share/mricron/templates/ch2.nii.gz")


class Environment(SessionCase):
    def body(self):
        return write(sphere(), self.folder / "body.vtp")

    def test_no_display(self):
        self.refuse(self.body(), words=("DISPLAY", "xvfb-run"), environment={"DISPLAY": None})

    def test_display_that_does_not_answer(self):
        for display in (":987", "", "nowhere.invalid:0"):
            with self.subTest(display=display):
                self.refuse(self.body(), words=("DISPLAY", "xvfb-run"),
                            environment={"DISPLAY": display})

    def test_scan_that_is_not_there(self):
        self.refuse("--scan", "/nonexistent/head.nii.gz", words=("/nonexistent/head.nii.gz",))

    @unittest.skipIf(SCAN.exists(), "mricron-data is installed")
    def test_default_scan_that_is_not_installed(self):
        self.refuse(words=(SCAN, "mricron-data", "--scan"))

    def test_output_folder_that_is_a_file(self):
        self.output.write_text("mine")
        self.refuse(self.body(), words=(self.output,))
        self.assertEqual(self.output.read_text(), "mine")

    def test_output_folder_within_a_file(self):
        (self.folder / "file").write_text("mine")
        self.output = self.folder / "file" / "out"
        self.refuse(self.body(), words=(self.output,))

    def test_file_that_cannot_be_written(self):
        # A folder has the name of the file, so that not even root can write the file.
        for name in ("trajectory.csv", "overview.png", "curves.png"):
            with self.subTest(name=name):
                self.output = self.folder / f"out {name}"
                (self.output / name).mkdir(parents=True)
                result = self.run_into_output()
                self.assertGreater(result.returncode, 0)
                self.assertIn(str(self.output / name), result.stderr)

    def test_body_that_cannot_be_saved(self):
        save = self.folder / "nowhere" / "saved.vtp"
        result = self.run_into_output("--save", save)
        self.assertGreater(result.returncode, 0)
        self.assertIn(str(save), result.stderr)

    def test_output_folder_is_made_and_used_again(self):
        self.output = self.folder / "a" / "b"
        self.succeed(self.body(), pictures=PICTURES)
        self.succeed(self.body(), pictures=PICTURES)

    def test_without_pictures_no_display_is_needed_and_the_rest_is_the_same(self):
        with_pictures = self.succeed(self.body(), pictures=PICTURES)
        told = (self.output / "trajectory.csv").read_bytes()
        self.output = self.folder / "bare"
        without = self.succeed(self.body(), environment={"DISPLAY": None})
        self.assertEqual((self.output / "trajectory.csv").read_bytes(), told)
        for number in ("body", "session", "peak", "error"):
            lines = [re.search(rf"^  {number} .*", result.stdout, re.MULTILINE).group()
                     for result in (with_pictures, without)]
            self.assertEqual(*lines)

    def test_what_only_draws_cannot_do_without(self):
        for mode in ("--compare", "--map"):
            self.refuse(mode, "--no-pictures", words=(mode, "--pictures"))

    def run_into_output(self, *arguments):
        return run(self.body(), *arguments, "--output", self.output)


if __name__ == "__main__":
    unittest.main()
