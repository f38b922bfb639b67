#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of the tick runs: all methods in the build agree and have their rows. Times are not checked.

    test_tick_benchmark.py PROGRAM METHOD ...    METHODs: the other methods that must be in the build
"""
import csv
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HEADER = ["method", "triangles", "cache", "median_ns", "p99_ns", "p999_ns", "max_ns", "build_s", "memory_mb"]
PALPATE = ["palpate-tick", "palpate-point", "palpate-onset-point", "palpate-onset-tick",
           "palpate-tick-servo", "palpate-tick-50-tips",
           "palpate-tick-1-law", "palpate-tick-4-laws", "palpate-tick-shuffled"]
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else ""
PEERS = sys.argv[2:]


class TickBenchmark(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            cls.run_ = subprocess.run(
                [PROGRAM, "--quick", "--triangles", "20000", "--output", folder],
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            path = Path(folder) / "tick.csv"
            cls.lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
        cls.rows = list(csv.DictReader(cls.lines))

    def test_succeeds(self):
        self.assertEqual(self.run_.returncode, 0, self.run_.stdout)

    def test_header(self):
        self.assertTrue(self.lines, self.run_.stdout)
        self.assertEqual(self.lines[0], ",".join(HEADER))

    def test_each_method_has_a_hot_and_a_cold_row(self):
        found = sorted((row["method"], row["cache"]) for row in self.rows)
        self.assertEqual(found, sorted((m, c) for m in PALPATE + PEERS for c in ("hot", "cold")))

    def test_numbers_are_numbers(self):
        for row in self.rows:
            with self.subTest(method=row["method"], cache=row["cache"]):
                self.assertEqual(row["triangles"], "20000")
                times = [float(row[name]) for name in HEADER[3:7]]
                self.assertTrue(all(math.isfinite(time) and time > 0 for time in times), row)
                self.assertEqual(times, sorted(times))
                self.assertGreater(float(row["build_s"]), 0.0)
                self.assertTrue(math.isfinite(float(row["memory_mb"])), row)

    def test_answers_were_compared(self):
        pattern = re.compile(
            r"^\s+(\S+)\s+(\d+) calls, distances within (\S+) mm \(bound (\S+)\), local minima 0$", re.MULTILINE)
        compared = {match[1]: match for match in pattern.finditer(self.run_.stdout)}
        self.assertEqual(sorted(compared), sorted(PALPATE + PEERS), self.run_.stdout)
        for match in compared.values():
            self.assertGreaterEqual(int(match[2]), 200)
            self.assertLessEqual(float(match[3]), float(match[4]))
            # Rounding of floats at 100 mm: 2^-18 mm per coordinate, times 2 √3. The sum over 50
            # tips has 50 times this rounding.
            self.assertLess(float(match[4]), (50 if "50" in match[1] else 1) * 1.4e-5)

    def test_wrong_options_are_refused(self):
        for options in (["--triangles", "none"], ["--output", "/nonexistent/folder"], ["--calls", "-1"]):
            with self.subTest(options=options):
                result = subprocess.run([PROGRAM, *options], capture_output=True, text=True, check=False)
                self.assertNotEqual(result.returncode, 0)
                self.assertIn(options[0], result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
