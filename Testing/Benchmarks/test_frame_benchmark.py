#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of frames runs and prints its rows. Times are not checked.

    test_frame_benchmark.py PROGRAM
"""
import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else ""


class FrameBenchmark(unittest.TestCase):
    def test_rows(self):
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([PROGRAM, "--quick", "--output", folder], stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, text=True, check=False)
            self.assertEqual(result.returncode, 0, result.stdout)
            with open(Path(folder) / "frame.csv", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual([row["path"] for row in rows], ["plain", "shader", "filter"])
        for row in rows:
            self.assertGreater(int(row["triangles"]), 15000)
            self.assertGreaterEqual(int(row["frames"]), 1)
            self.assertLessEqual(float(row["median_ms"]), float(row["p90_ms"]))
            self.assertAlmostEqual(float(row["ratio"]) * float(rows[0]["median_ms"]),
                                   float(row["median_ms"]), delta=0.01 * float(row["median_ms"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
