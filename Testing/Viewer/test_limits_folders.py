# SPDX-License-Identifier: BSD-3-Clause
"""Folders that are missing, that are files, or that are read-only, for every file that the program writes: it
reports this before the session starts. Without its cache it continues, and reports this once."""
import re
import unittest
from pathlib import Path

import bodies
import own_mount
from session import SessionCase, run

MATERIAL = ("--tool", "sphere:3", "--young", "0.1", "--poisson", "0.45")
OUTPUTS = {"--record": "record.csv", "--save": "saved.vtp", "--export": "saved.palpate",
           "--screenshot": "picture.png"}


class Folders(SessionCase):
    def setUp(self):
        super().setUp()
        self.body = bodies.write(bodies.sphere(), self.folder / "body.vtp")
        (self.folder / "file").write_text("mine")
        (self.folder / "read").mkdir()

    def refuse_at_once(self, option, path, reason, **more):
        """The refusal comes before any file is made, even before the output folder."""
        window = ("--window",) if option == "--screenshot" else ()
        self.refuse(self.body, *MATERIAL, option, path, *window, words=(f"'{path}'", reason), **more)
        self.assertFalse(self.output.exists())

    def test_outputs(self):
        for option, name in OUTPUTS.items():
            for path, reason in ((self.folder / "nowhere" / name, "No such file or directory"),
                                 (self.folder / "file" / name, "Not a directory"),
                                 (self.folder / "read", "Is a directory")):
                with self.subTest(option=option, path=path):
                    self.refuse_at_once(option, path, reason)
        self.assertEqual((self.folder / "file").read_text(), "mine")

    def test_outputs_where_one_may_only_read(self):
        place = self.folder / "read"
        if not own_mount.is_possible(place):
            self.skipTest("this machine lets nobody mount a disk that may only be read")
        before = own_mount.over(place, "ro")
        for option, name in OUTPUTS.items():
            with self.subTest(option=option):
                self.refuse_at_once(option, place / name, "Read-only file system", before=before)
        with self.subTest(option="--output"):
            for output in (place, place / "new"):
                result = run(self.body, *MATERIAL, "--output", output, before=before)
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn(str(output), result.stderr)
                self.assertIn("Read-only file system", result.stderr)

    def test_the_log_of_a_trial(self):
        for place, reason in ((self.folder / "nowhere", "No such file or directory"),
                              (self.folder / "file", "Not a directory")):
            with self.subTest(place=place):
                log = place / "log.csv"
                result = run(self.body, "--trial", "sphere:3,flat:3", "--log", log, answers="1\n")
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn(f"'{log}': {reason}", result.stderr)
                self.assertNotIn("1: X", result.stdout, "nobody was asked")

    def touch_scan(self, cache, **more):
        """Uses a scan as the scene of a head. Returns the message about the cache. Runs a trial, which draws nothing:
        the renderer has its own cache there and crashes on a full disk (Mesa 22)."""
        scan = self.folder / "ball.vti"
        if not scan.exists():
            image = bodies.image(bodies.ball_grey())
            image.SetOrigin(-23.5, -15.0 - 23.5, 14.0 - 23.5)  # position of the head in the scene
            bodies.write(image, scan)
        result = run("--scan", scan, "--contour", "50", "--layer", "none", "--site", "1,0,0",
                     *MATERIAL, "--trial", "young=0.1,young=0.2", "--log", self.folder / "log.csv",
                     environment={"XDG_CACHE_HOME": cache and str(cache), "HOME": ""}, answers="1\n",
                     **more)
        self.assertEqual(result.returncode, 0, result.stderr)
        (self.folder / "log.csv").unlink()
        return re.findall("cache.*", result.stderr)

    def test_the_cache(self):
        usual = self.folder / "cache"
        self.assertEqual(self.touch_scan(usual), [])
        self.assertEqual(len(list((usual / "palpate").iterdir())), 1)
        self.assertRegex(self.touch_scan(usual)[0], "cache .*skin-")
        for place in (self.folder / "file", Path("/proc/nowhere")):
            with self.subTest(place=place):
                said = self.touch_scan(place)
                self.assertEqual(len(said), 1, said)
                self.assertIn("cache not used", said[0])
                self.assertIn(str(place), said[0])
        with self.subTest("no place for a cache"):
            self.assertEqual(self.touch_scan(None), [])

    def test_a_cache_that_may_only_be_read(self):
        place = self.folder / "read"
        if not own_mount.is_possible(place):
            self.skipTest("this machine lets nobody mount a disk that may only be read")
        said = self.touch_scan(place, before=own_mount.over(place, "ro"))
        self.assertEqual(len(said), 1, said)
        self.assertIn("Read-only file system", said[0])

    def test_a_cache_that_is_full(self):
        place = self.folder / "read"
        if not own_mount.is_possible(place):
            self.skipTest("this machine lets nobody mount a small disk")
        kept = self.folder / "kept"
        kept.mkdir()
        said = self.touch_scan(place, before=own_mount.over(place, "size=16k", kept))
        self.assertEqual(len(said), 1, said)
        self.assertIn("No space left on device", said[0])
        self.assertEqual(list((kept / "palpate").iterdir()), [], "nothing half is left there")


if __name__ == "__main__":
    unittest.main()
