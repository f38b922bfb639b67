#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the results of the study of errors in Data/Studies/error: the stated error holds, and is about as large as the true
error.

    test_error.py [UNITTEST ARGS]

Testing/Cxx/Laws/RandomContactTest.cxx solves a few cases again.
"""
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parents[2] / "Data" / "Studies" / "error"
sys.path.insert(0, str(HERE))

import run  # noqa: E402


class Committed(unittest.TestCase):
    def setUp(self):
        self.rows = run.read(DATA / "cases.csv")

    def test_the_bound_holds_in_95_of_100_of_every_family(self):
        for family in run.FAMILIES:
            some = [row for row in self.rows if row["family"] == family]
            self.assertGreaterEqual(len(some), 9, family)
            held = sum(float(row["error"]) <= float(row["stated"]) + run.SOLVER for row in some)
            self.assertGreaterEqual(held, 0.95 * len(some), family)

    def test_it_is_no_more_than_three_times_too_wide_for_most(self):
        ratios = sorted(float(row["stated"]) / max(float(row["error"]), 0.005) for row in self.rows)
        self.assertLess(ratios[len(ratios) // 2], 3.0)

    def test_errors_are_those_of_the_forces(self):
        for row in self.rows:
            error = abs(float(row["exact_N"]) / float(row["force_N"]) - 1.0)
            self.assertAlmostEqual(error, float(row["error"]), delta=2e-5)  # the rows have six and five digits

    def test_the_bound_holds_in_95_of_100_on_a_true_shape(self):
        rows = run.read(DATA / "solid.csv")
        self.assertEqual({row["tool"] for row in rows}, {"sphere:6.35", "flat:1.6", "sphere:1.6"})
        for row in rows:
            self.assertGreater(int(row["compared"]), 1000)
            self.assertLess(float(row["beyond_stated"]), 0.05, row)

    def test_the_bound_of_true_shape_holds_against_direct_contact(self):
        rows = run.read(DATA / "direct.csv")
        self.assertEqual({row["tool"] for row in rows}, {"sphere:6.35", "flat:1.6", "sphere:1.6"})
        covered = [row for row in rows if float(row["stated"]) <= 0.05]
        self.assertGreaterEqual(len(covered), 18)
        for those in (covered, rows):
            self.assertGreaterEqual(sum(map(run.holds, those)), 0.95 * len(those))

    def test_the_bound_of_the_default_response_holds_against_direct_contact(self):
        rows = run.read(DATA / "whole_body.csv")
        self.assertEqual({row["tool"] for row in rows}, {"sphere:6.35", "flat:1.6", "sphere:1.6"})
        covered = [row for row in rows if float(row["stated"]) <= 0.05]
        self.assertGreaterEqual(len(covered), 40)
        for those in (covered, rows):
            self.assertGreaterEqual(sum(map(run.holds, those)), 0.95 * len(those))
        stated, true = (sorted(abs(float(row[name])) for row in covered) for name in ("stated", "error"))
        self.assertLess(stated[len(stated) // 2], 3.5 * true[len(true) // 2])

    def test_direct_contact_covers_bunny_and_dragon(self):
        rows = run.read(DATA / "pressed.csv")
        self.assertEqual({row["tool"] for row in rows}, {"sphere:6.35", "flat:1.6", "sphere:1.6"})
        for row in rows:
            law, both, of_these = (float(row[name]) for name in ("share_by_law", "share_by_both", "share_of_these"))
            self.assertGreaterEqual(int(row["pressed"]), 40)
            self.assertLessEqual(both, law + (1.0 - law) * of_these + 1e-3)  # the rows have three digits
            self.assertGreaterEqual(both, law)
            self.assertGreaterEqual(both, {"bunny": 0.95, "dragon": 0.8}[row["body"]], row)


if __name__ == "__main__":
    unittest.main()
