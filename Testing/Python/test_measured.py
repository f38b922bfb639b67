#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""palpate.measured: a plate measured with a paraboloid according to Hertz's law and pressed with a flat punch; invalid
input."""
import inspect
import tempfile
import unittest
from pathlib import Path

import numpy as np
import palpate

MODULUS, RADIUS = 0.05, 3.0  # E* (MPa), mm
PLATE = (np.array([[-20, -20, 0], [20, -20, 0], [20, 20, 0], [-20, 20, 0]], float), np.array([[0, 1, 2], [0, 2, 3]]))


class Measured(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def curves(self, sign=1.0):
        """Readings 0.02 mm apart, from 1 mm before contact to 1 mm beyond."""
        file = self.folder / "curves.csv"
        depth = np.arange(-50, 51) / 50
        force = 4 / 3 * MODULUS * RADIUS**0.5 * np.maximum(depth, 0)**1.5
        head = ["# tool: paraboloid:%g" % RADIUS, "x_mm,y_mm,z_mm,deflection_mm,force_N"]
        rows = ["20,20,0,%.9g,%.9g" % (d + 1.2, sign * f) for d, f in zip(depth, force)]
        file.write_text("\n".join([*head, *rows]) + "\n")
        return file

    def test_felt_with_another_tool(self):
        found = palpate.measured(PLATE, self.curves(), tool="flat:1", maximum_deflection=0.4)
        (site,) = found.sites
        self.assertEqual((site["Verdict"], site["Model"]), ("identified", "half-space"))
        self.assertAlmostEqual(site["ReducedModulus (MPa)"], MODULUS, delta=1e-6 * MODULUS)  # the file has nine digits
        self.assertAlmostEqual(site["ContactOffset (mm)"], 1.2, delta=1e-6)
        curve = palpate.curves(found.body, 2, deflection=0.4)
        self.assertAlmostEqual(curve.force[0], 2 * 1 * MODULUS * 0.4, delta=1e-6 * MODULUS)  # 2 a E* δ, as floats

    def test_largest_strain(self):
        """The strain of a paraboloid is √(δ/R): 0.4 at 0.48 mm. Of 101 readings, 26 exceed this strain and one equals
        it."""
        remark = palpate.measured(PLATE, self.curves()).sites[0]["Remark"]
        self.assertRegex(remark, "2[67] of 101 readings are not used: .* largest strain of 0.4 allows")
        self.assertEqual(palpate.measured(PLATE, self.curves(), maximum_strain=0.6).sites[0]["Remark"], "")

    def test_what_is_wrong(self):
        file = self.curves()
        for words, arguments in (("model must be one of", {"model": "sponge"}), ("Reach", {"reach": -1}), ("none.csv", {"files": self.folder / "none.csv"}),
                                 ("Maximum Strain must be positive", {"maximum_strain": 0}),
                                 ("is compression negative here", {"files": self.curves(-1.0)})):
            with self.assertRaisesRegex(ValueError, words):
                palpate.measured(PLATE, **{"files": file, **arguments})
        with self.assertRaisesRegex(TypeError, "maximum_strain must be a number"):
            palpate.measured(PLATE, file, maximum_strain="much")

    def test_help(self):
        text = inspect.getdoc(palpate.measured)
        for argument in inspect.signature(palpate.measured).parameters:
            self.assertIn(argument, text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
