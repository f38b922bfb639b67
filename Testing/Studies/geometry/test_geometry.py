#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests forces on a tip at difficult geometry: compares the numbers of ./run study geometry with the expected numbers and
with the table in Data/Studies/geometry.

    test_geometry.py
"""
import csv
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import bodies  # noqa: E402
import run  # noqa: E402

TABLE = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Studies" / "geometry" / "summary.csv"


class Geometry(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.felt = {make().name: run.Felt(make()) for make in bodies.CASES}
        cls.found = {(name, what): (found, expected) for name, felt in cls.felt.items()
                     for what, found, expected in run.NUMBERS[name](felt)}

    def check(self, case, what, tolerance):
        found, expected = self.found[case, what]
        self.assertLessEqual(abs(found - expected), tolerance, (case, what, found, expected))

    def test_slab(self):
        self.check("slab", "force_up_share_of_ticks", 0.0)
        self.check("slab", "deepest_mm", 1e-6)          # float32 coordinates
        self.check("slab", "force_at_deepest_N", 1e-4)  # 8 samples to 4 mm

    def test_groove(self):
        for side in ("left", "right"):
            self.check("groove", f"wall_{side}_direction_x", 1e-6)
        self.check("groove", "bottom_direction_y", 1e-6)
        # The force does not jump at the bottom: it changes by at most 0.02 mm times the law's 0.6 N/mm per tick.
        self.assertLess(self.found["groove", "greatest_force_step_N"][0], 0.02 * 0.6)

    def test_edge(self):
        x, _ = self.found["edge", "changes_sides_at_x_mm"]
        self.assertTrue(0.0 < x <= 0.5, x)  # in the facet at the edge
        self.check("edge", "force_before_N", 1e-4)
        self.check("edge", "force_after_N", 1e-4)

    def test_cone(self):
        # A flat facet of 48 is inside the cone by at most 1 - cos(π/48) = 0.2 % of the radius, 1.4
        # mm.
        self.check("cone", "depth_error_mm", 0.003)
        self.assertLess(self.found["cone", "sideways_before_axis_N"][0], -0.2)
        self.assertGreater(self.found["cone", "sideways_after_axis_N"][0], 0.2)

    def test_saddle(self):
        self.check("saddle", "depth_least_mm", 0.017)     # sag of the facets, 0.008 in each direction
        self.check("saddle", "depth_greatest_mm", 0.017)
        self.check("saddle", "direction_error_rad", 0.06)  # the turn over half a facet

    def test_border(self):
        self.check("border", "force_at_border_N", 1e-4)
        self.check("border", "lost_share_of_ticks_beyond", 0.0)
        self.check("border", "greatest_pull_back_N", 1e-9)
        # Smooth ramp: the slope of (1 - l)²(1 + 2l) is at most 1.5 per depth, and a tick is 0.02 of
        # that depth.
        self.assertLess(self.found["border", "greatest_force_step_N"][0],
                        1.6 * 0.02 * self.found["border", "force_at_border_N"][0])

    def test_no_tick_pulls(self):
        for name, felt in self.felt.items():
            self.assertTrue(np.isfinite(felt.Force).all(), name)
            # The force points away from the body, along the outward normal, towards the contact
            # point.
            inside = felt.inside & (felt.ContactState != run.LOST)
            out = felt.ContactPoint - felt.tips
            self.assertTrue(((felt.Force * out).sum(1)[inside] >= 0.0).all(), name)

    def test_table_is_of_this_code(self):
        with open(TABLE, encoding="utf-8", newline="") as file:
            rows = {(row["case"], row["what"]): row["found"] for row in csv.DictReader(file)}
        self.assertEqual(set(rows), set(self.found))
        for key, text in rows.items():
            self.assertAlmostEqual(float(text), self.found[key][0], delta=1e-5 * max(1.0, abs(float(text))), msg=key)


if __name__ == "__main__":
    unittest.main()
