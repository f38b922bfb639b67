#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The short version of ./run study reduction: tests the number of numbers per scene, and that the forces do not change.

    test_reduction.py
"""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import run  # noqa: E402
import scenes  # noqa: E402


class Reduction(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = {row["scene"]: row for row in run.study(is_quick=True)}

    def test_all_scenes_are_there(self):
        expected = set(scenes.SCENES) - (set() if scenes.SCAN.exists() else {"head"})
        self.assertEqual(set(self.rows), expected)

    def test_numbers(self):
        # Numbers per vertex at 1 %: none for a homogeneous body, one for one law with many moduli,
        # four for soft tissue over bone.
        most = {"homogeneous": 0, "stiffness map": 1, "layer map": 4, "head": 4, "gives way": 4}
        for name, row in self.rows.items():
            with self.subTest(scene=name):
                self.assertLessEqual(row["numbers"], most[name])
                self.assertEqual(row["numbers_before"], 16)

    def test_tips_feel_the_same(self):
        for name, row in self.rows.items():
            with self.subTest(scene=name):
                self.assertLessEqual(row["largest_error"], row["tolerance"])
                # Between the depths that the filter checks an error may be a tenth larger.
                self.assertLessEqual(row["felt_error"], 1.1 * row["largest_error"] + 1e-6)


if __name__ == "__main__":
    unittest.main()
