#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of the servo thread runs and prints its rows, with and without rendering. Times are not judged.

    test_servo_benchmark.py PROGRAM
"""
import csv
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HEADER = ("rate_hz,load,policy,wakeup_median_us,p99,p999,max,"
          "tick_median_us,tick_p99,missed,ticks").split(",")
SECONDS = 0.3
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else ""


def run(*options):
    """The result of the program, its rows, and the first line of its file."""
    with tempfile.TemporaryDirectory() as folder:
        result = subprocess.run([PROGRAM, "--quick", "--output", folder, *options],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        path = Path(folder) / "servo.csv"
        lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else [""]
    return result, list(csv.DictReader(lines)), lines[0]


class ServoBenchmark(unittest.TestCase):
    def check(self, rates, load, *options):
        result, rows, header = run("--rates", ",".join(rates), "--load", load, *options)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertEqual(header.split(","), HEADER)
        # SCHED_FIFO is expected only if the output says that the system granted it.
        fifo = "SCHED_FIFO 80 granted" in result.stdout
        policies = ["SCHED_OTHER", "SCHED_FIFO"] if fifo else ["SCHED_OTHER"]
        expected = [(rate, name, policy) for name in ("idle", load) for rate in rates for policy in policies]
        self.assertEqual([(row["rate_hz"], row["load"], row["policy"]) for row in rows], expected)
        for row in rows:
            with self.subTest(**row):
                wake = [float(row[name]) for name in HEADER[3:7]]
                tick = [float(row[name]) for name in HEADER[7:9]]
                self.assertTrue(all(math.isfinite(time) and time >= 0 for time in wake + tick))
                self.assertEqual(wake, sorted(wake))
                self.assertLessEqual(tick[0], tick[1])
                self.assertGreater(tick[0], 0.0)
                # Ticks and misses add up to all periods of SECONDS. A late start or stop may change
                # the sum, but by less than half.
                periods = int(row["ticks"]) + int(row["missed"])
                self.assertGreater(periods, 0.5 * SECONDS * float(row["rate_hz"]))
        return result.stdout

    def test_beside_memory_traffic(self):
        said = self.check(["1000", "4000"], "memory")
        self.assertRegex(said, r"memory: \d+ threads that read \d+ MiB each")
        # The load uses all processors: one thread per processor reads memory without a pause.
        busy = re.search(r"memory: (\d+\.\d+) of (\d+) processors were at work", said)
        self.assertIsNotNone(busy, said)
        self.assertGreater(float(busy[1]), 0.5 * int(busy[2]))

    def test_beside_a_renderer(self):
        if not os.environ.get("DISPLAY"):
            result, rows, _ = run("--rates", "1000", "--load", "rendering")
            self.assertEqual(result.returncode, 0, result.stdout)
            self.assertIn("No DISPLAY: nothing is drawn", result.stdout)
            self.assertEqual({row["load"] for row in rows}, {"idle"})
        else:
            self.assertIn("VTK draws", self.check(["1000"], "rendering"))

    def test_wrong_options_are_refused(self):
        for options in (["--rates", "0"], ["--output", "/nonexistent/folder"], ["--load", "none"]):
            with self.subTest(options=options):
                result = subprocess.run([PROGRAM, *options], capture_output=True, text=True, check=False)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(options[0], result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
