#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the study of coverage: the committed cases and a few new random cases with another seed reach the goal.

    test_coverage.py [UNITTEST ARGS]
"""
import csv
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parents[2] / "Data" / "Studies" / "coverage"
sys.path.insert(0, str(HERE))

import run  # noqa: E402


class Committed(unittest.TestCase):
    def setUp(self):
        with open(DATA / "cases.csv", newline="", encoding="utf-8") as file:
            self.cases = list(csv.DictReader(file))

    def test_every_family_is_covered(self):
        for family in run.FAMILIES:
            some = [case for case in self.cases if case["family"] == family]
            self.assertGreaterEqual(len(some), 100, family)
            self.assertGreaterEqual(sum(int(case["covered"]) for case in some), run.GOAL * len(some), family)

    def test_errors_are_those_of_the_forces(self):
        for case in self.cases:
            error = abs(float(case["force_N"]) / float(case["true_N"]) - 1.0)
            self.assertAlmostEqual(error, float(case["true_error"]), delta=2e-5)  # six digits in the rows


class Drawn(unittest.TestCase):
    def test_new_cases_are_covered(self):
        for family in run.FAMILIES:
            cases = run.draw(family, 8, seed=1234)
            self.assertGreaterEqual(sum(case["covered"] for case in cases), 7, (family, cases))

    def test_a_stated_error_of_zero_would_be_noticed(self):
        cases = [dict(case, stated_error=0.0) for case in run.draw("finite strain", 8, seed=5)]
        self.assertLess(sum(case["true_error"] <= case["stated_error"] + 0.005 for case in cases), 8)


if __name__ == "__main__":
    unittest.main()
