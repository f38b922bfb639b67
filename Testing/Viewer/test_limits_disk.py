# SPDX-License-Identifier: BSD-3-Clause
"""If the disk is full while the program writes, it reports the file and the reason. The old file is kept. The
part of a recording that fits on the disk is kept and can be read."""
import unittest

import bodies
import own_mount
from session import SessionCase, run

TOO_LARGE = "File too large"  # message of the file size limit
FULL = "No space left on device"
MATERIAL = ("--tool", "sphere:3", "--young", "0.1", "--poisson", "0.45")



def rows_of(trajectory):
    """The lines with numbers, below the names of the columns and the lines on tool and material."""
    return [line for line in trajectory.splitlines() if not line.startswith("#")][1:]


class FullDisk(SessionCase):
    def setUp(self):
        super().setUp()
        self.body = bodies.write(bodies.sphere(), self.folder / "body.vtp")
        self.output.mkdir()

    def refuse(self, *arguments, words, **more):
        """The program must end with exit code 1 and the words, not by a signal."""
        result = run(self.body, *MATERIAL, *arguments, "--output", self.output, **more)
        self.assertEqual(result.returncode, 1, result.stderr)
        for word in words:
            self.assertIn(str(word), result.stderr)
        return result

    def hand(self, ticks):
        """Makes a file of a hand that presses 1 mm deep for `ticks` ticks."""
        script = self.folder / "hand.csv"
        script.write_text("time_s,tip_x_mm,tip_y_mm,tip_z_mm\n0,0.4,0.3,26\n"
                          f"{0.0005 * ticks},0.4,0.3,24\n{0.001 * ticks},0.4,0.3,24\n")
        return f"replay:{script}"

    def replay(self, record):
        """The program's own reader accepts the recording. Returns the number of ticks found."""
        again = self.folder / "again"
        result = run(self.body, *MATERIAL, "--device", f"replay:{record}", "--output", again)
        self.assertEqual(result.returncode, 0, result.stderr)
        return len(rows_of((again / "trajectory.csv").read_text()))

    def check_kept_rows(self, record, whole, result):
        """The rows that fit on the disk are the beginning of the whole recording, without partial rows, and the program
        can replay them."""
        part = record.with_name(record.name + ".part")
        kept = part.read_bytes()
        self.assertTrue(whole.startswith(kept))
        rows = len(rows_of(kept.decode()))
        self.assertGreater(rows, 10)
        self.assertIn(f"the first {rows} of {len(rows_of(whole.decode()))} rows are kept in "
                      f"'{part}'", result.stderr)
        # A replay ends with the last row. At the time of that row there is no tick.
        self.assertIn(self.replay(part), (rows - 1, rows))

    def test_a_trajectory(self):
        hand = self.hand(200)
        whole = run(self.body, *MATERIAL, "--device", hand, "--output", self.folder / "whole")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        record = self.output / "trajectory.csv"
        record.write_text("mine")
        result = self.refuse("--device", hand, words=(f"'{record}'", TOO_LARGE), room=10000)
        self.assertEqual(record.read_text(), "mine")
        self.check_kept_rows(record, (self.folder / "whole" / "trajectory.csv").read_bytes(), result)
        self.assertEqual({path.name for path in self.output.iterdir()},
                         {"trajectory.csv", "trajectory.csv.part"})

    def test_a_record_on_a_device_that_is_full(self):
        result = self.refuse("--device", self.hand(200), "--record", "/dev/full",
                           words=("'/dev/full'", FULL))
        self.assertNotIn(".part", result.stderr)
        self.assertTrue((self.output / "trajectory.csv").read_text().endswith("\n"))

    def test_a_picture(self):
        picture = self.output / "deflection.png"
        picture.write_text("mine")
        self.refuse("--device", self.hand(50), words=(f"'{picture}'", TOO_LARGE), room=15000)
        self.assertEqual(picture.read_text(), "mine")
        self.assertEqual({path.name for path in self.output.iterdir()},
                         {"trajectory.csv", "deflection.png"})

    def test_saved_bodies(self):
        saved = {"--save": self.folder / "saved.vtp", "--export": self.folder / "saved.palpate"}
        trial = ("--trial", "young=0.1,young=0.2", "--log", self.folder / "log.csv")  # a trial draws nothing
        first = run(self.body, *MATERIAL, *trial, *(word for pair in saved.items() for word in pair),
                    answers="")
        self.assertEqual(first.returncode, 0, first.stderr)
        for option, path in saved.items():
            with self.subTest(option=option):
                before = path.read_bytes()
                self.refuse("--tool", "flat:2", option, path, words=(f"'{path}'", TOO_LARGE),
                          room=len(before) // 2)
                self.assertEqual(path.read_bytes(), before)
                self.assertFalse(path.with_name(path.name + ".part").exists())
        with self.subTest("on a device that is full"):
            for option in saved:
                self.refuse(option, "/dev/full", words=("'/dev/full'", FULL))

    def test_answers_of_a_trial(self):
        log = self.folder / "log.csv"
        trial = ("--trial", "sphere:3,flat:3", "--rounds", "5", "--seed", "1", "--log")
        whole = run(self.body, *trial, log, answers="1\n" * 10)
        self.assertEqual(whole.returncode, 0, whole.stderr)
        head = [line for line in log.read_text().splitlines() if line.startswith("#")]
        size = sum(map(len, head)) + 200  # bytes; enough for the names of the columns and some answers
        short = self.folder / "short.csv"
        result = run(self.body, *trial, short, answers="1\n" * 10, room=size)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"'{short}': {TOO_LARGE}", result.stderr)
        lines = short.read_text().splitlines(keepends=True)
        rows = [line for line in lines if not line.startswith("#")][1:]
        self.assertTrue(all(line.endswith("\n") and line.count(",") == 7 for line in rows))
        self.assertEqual([row.split(",")[0] for row in rows],
                         [str(i + 1) for i in range(len(rows))])
        self.assertTrue(2 <= len(rows) < 10, rows)
        # Not even the head fits. No file remains that would block another attempt.
        none = self.folder / "none.csv"
        result = run(self.body, *trial, none, answers="", room=50)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"'{none}': {TOO_LARGE}", result.stderr)
        self.assertFalse(none.exists())

    def test_a_disk(self):
        if not own_mount.is_possible(self.output):
            self.skipTest("this machine lets nobody mount a small disk")
        kept = self.folder / "kept"
        kept.mkdir()
        record = self.output / "trajectory.csv"
        result = self.refuse("--device", self.hand(1500), words=(f"'{record}'", FULL),
                           before=own_mount.over(self.output, "size=64k", kept))
        lines = (kept / "trajectory.csv.part").read_text().splitlines()
        self.assertGreater(len(lines), 100)
        lines = [line for line in lines if not line.startswith("#")]
        self.assertEqual({line.count(",") for line in lines}, {13}, "whole rows only")
        self.assertIn(f"the first {len(lines) - 1} of 1500 rows", result.stderr)


if __name__ == "__main__":
    unittest.main()
