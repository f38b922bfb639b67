#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the results of the study of continuity in Data/Studies/continuity and a quick run agree with its README.

    test_continuity.py PROGRAM [UNITTEST ARGS]       PROGRAM: palpateContinuity

Times are not tested. The test ContinuityTest checks the formulas.
"""
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parents[2] / "Data" / "Studies" / "continuity"

import run          # noqa: E402

PROGRAM = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else None
FLOOR = {name: floor for name, _, floor in run.MEASURES}


class Committed(unittest.TestCase):
    def setUp(self):
        self.rows = run.read((DATA / "continuity.csv").read_text(encoding="utf-8"))

    def cases(self, **wanted):
        for body, normals in run.bodies(self.rows):
            rows = run.select(self.rows, body=body, normals=normals, **wanted)
            self.assertEqual(len(rows), 3)
            yield body, rows

    def test_everything_is_there(self):
        self.assertEqual(len(run.bodies(self.rows)), 4)
        self.assertEqual(len(self.rows), 4 * 3 * len(run.FORMS) * len(run.SURFACES))

    def test_the_tables_are_those_of_the_rows(self):
        self.assertEqual((DATA / "continuity.md").read_text(encoding="utf-8"), run.tables(self.rows))

    def test_smooth_surface_neither_jumps_nor_gains_with_equal_responses(self):
        for form in ("NormalizedDirection", "EnergyConsistent"):
            for _, rows in self.cases(surface="Smooth", form=form):
                for row in rows:
                    self.assertLess(row["jump_equal"], FLOOR["jump_equal"])
                    self.assertLess(row["loop_equal"], FLOOR["loop_equal"])

    def test_orders(self):
        # Largest values over the edges of a grid scatter by half an order.
        for form in ("Paper", "NormalizedDirection"):
            for _, rows in self.cases(surface="Facets", form=form):
                self.assertAlmostEqual(run.order(rows, "jump_equal", 0.0), 1.0, delta=0.55)
                self.assertGreater(run.order(rows, "loop_equal", 0.0), 1.6)
                self.assertAlmostEqual(run.order(rows, "error_size", 0.0), 2.0, delta=0.3)
        for _, rows in self.cases(surface="Smooth", form="EnergyConsistent"):
            self.assertAlmostEqual(run.order(rows, "jump_differing", 0.0), 1.0, delta=0.3)
            self.assertGreater(run.order(rows, "error_size", 0.0), 2.5)

    def test_only_an_energy_gains_nothing_where_responses_differ(self):
        for form in ("Paper", "NormalizedDirection"):
            for surface in run.SURFACES:
                for _, rows in self.cases(surface=surface, form=form):
                    self.assertGreater(rows[-1]["loop_differing"], 2e-3)
        for _, rows in self.cases(surface="Smooth", form="EnergyConsistent"):
            for row in rows:
                self.assertLess(row["loop_differing"], FLOOR["loop_differing"])


class Quick(unittest.TestCase):
    def test_runs(self):
        rows = run.read(run.measure(PROGRAM, True))
        self.assertEqual(len(rows), 4 * len(run.FORMS) * len(run.SURFACES))
        committed = run.read((DATA / "continuity.csv").read_text(encoding="utf-8"))
        for row in rows:
            same = run.select(committed, **{name: row[name] for name in ("body", "normals", "form", "surface", "edge_mm")})
            self.assertEqual(len(same), 1)
            # The quick run has a part of the paths and places: its largest value must not be larger (four digits).
            for name in FLOOR:
                self.assertLessEqual(row[name], 1.001 * max(same[0][name], FLOOR[name]))


if __name__ == "__main__":
    unittest.main()
