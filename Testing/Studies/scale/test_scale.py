#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The short version of ./run study scale: bytes per vertex and forces from 10^4 to 10^5 vertices. Times are not judged.

    test_scale.py PALPATE_SCALE
"""
import pathlib
import sys
import unittest

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else ""
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import run  # noqa: E402

SIZES = (1e4, 3e4, 1e5)
# 8 samples: force and stiffness, normal, range, validity; status and limit.
ARRAY_BYTES = 4 * (8 + 8 + 3 + 1 + 1) + 2
RECORD_BYTES = 80       # range, normal, 8 forces, 8 stiffnesses as floats
# The flat file adds x, y, z as doubles and two triangles of three int32 each.
FLAT_BYTES = 24 + 24 + ARRAY_BYTES


class Scale(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = [run.measure(PROGRAM, vertices, frames=False, quick=True) for vertices in SIZES]

    def test_sizes(self):
        for row, vertices in zip(self.rows, SIZES):
            self.assertAlmostEqual(row["vertices"], vertices, delta=0.02 * vertices)
            self.assertEqual(row["triangles"], 2 * (row["vertices"] - 2))  # closed: Euler

    def test_bytes_per_vertex_are_those_of_the_contract_at_any_size(self):
        for row in self.rows:
            with self.subTest(vertices=row["vertices"]):
                self.assertEqual(row["array_bytes_per_vertex"], ARRAY_BYTES)
                self.assertEqual(row["record_bytes_per_vertex"], RECORD_BYTES)
                # Header, texts, and ten arrays that begin at multiples of 64 bytes.
                self.assertAlmostEqual(row["flat_bytes_per_vertex"], FLAT_BYTES, delta=2000 / row["vertices"])

    def test_the_kernel_keeps_less_than_the_readme_says(self):
        # Numbers of the manual: 551 MB for 2 million vertices, 276 bytes each. On small bodies a
        # few pages of 2 MiB are added.
        row = self.rows[-1]
        self.assertLess(row["kernel_bytes_per_vertex"], 276 + 16 * 2 ** 20 / row["vertices"])

    def test_the_force_is_that_of_the_law_at_any_size(self):
        # F = 10 N (δ/1 mm)^1.5 at the depth under the facet. Samples and the kernel's records are
        # floats (6e-8); a cubic between them amplifies that by up to 10.
        for row in self.rows:
            self.assertLess(row["law_error"], 1e-6)

    def test_forces_near_those_of_the_smooth_body_as_triangles_shrink(self):
        # Facets are inside the smooth body by h²/8R at the middle of an edge h: proportional to
        # 1/vertices.
        slope, _ = run.fit(self.rows, "force_error")
        self.assertAlmostEqual(slope, -1.0, delta=0.15)  # 500 tips at random places of the facets
        # δ^1.5 at 1 mm: 1.5 times the sag. The sag is at most h²/(6 R) (in the middle of an
        # equilateral facet); its root mean square over a facet is about two thirds. R is from 30 mm
        # at convex places, -73 mm at concave ones.
        for row in self.rows:
            area = 4 * 3.14159 * 100 ** 2 / row["triangles"]
            self.assertLess(row["force_error"], 1.5 * area * 4 / 3 ** 0.5 / (6 * 30))

    def test_layers_need_few_numbers_at_any_size(self):
        self.assertEqual(len({row["choice_numbers"] for row in self.rows}), 1)
        self.assertLessEqual(self.rows[0]["choice_numbers"], 4)

    def test_table_and_slopes(self):
        rows = [{"vertices": n, "kernel_s": 2e-6 * n, "hot_ns": 300.0} for n in (1e4, 1e5, 1e6)]
        slope, off = run.fit(rows, "kernel_s")
        self.assertAlmostEqual(slope, 1.0)
        self.assertAlmostEqual(off, 1.0)
        self.assertEqual(run.table(rows).count("straight"), 2)
        rows[1]["kernel_s"] *= 4  # off by 4^(2/3): the fitted line itself rises by 4^(1/3)
        self.assertAlmostEqual(run.fit(rows, "kernel_s")[1], 4 ** (2 / 3))
        self.assertEqual(run.table(rows).count("straight"), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
