# SPDX-License-Identifier: BSD-3-Clause
"""Files in metres and centimetres; a size that looks like a mistaken unit gives a question."""
import unittest

import bodies
from session import SessionCase, peak_force


class Units(SessionCase):
    def test_length_unit(self):
        metres = self.press(bodies.sphere(0.025), "metres.vtp", "--length-unit", "m")
        self.assertIn("scaled by 1000 to millimetres", metres.stderr)
        centimetres = self.press(bodies.sphere(2.5), "centimetres.vtp", "--length-unit", "cm")
        millimetres = self.press(bodies.sphere(25.0), "millimetres.vtp", "--length-unit", "mm")
        self.assertNotIn("scaled", millimetres.stderr)
        for other in (metres, centimetres):
            self.assertAlmostEqual(peak_force(other), peak_force(millimetres), delta=1e-3)

    def test_length_unit_that_makes_no_sense(self):
        path = bodies.write(bodies.sphere(), self.folder / "body.vtp")
        for unit in ("0", "-5"):
            self.refuse(path, f"--length-unit={unit}", words=("--length-unit", unit))

    def test_size_that_looks_like_another_unit_is_asked_about(self):
        small = self.press(bodies.sphere(1.5), "small.vtp", "--depth", "0.05")
        self.assertIn("is --length-unit right?", small.stderr)
        self.assertRegex(small.stderr, r"longest side is (3|2\.99\d*) mm")
        usual = self.press(bodies.sphere(50.0), "usual.vtp")
        self.assertNotIn("--length-unit", usual.stderr)


if __name__ == "__main__":
    unittest.main()
