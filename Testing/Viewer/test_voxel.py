# SPDX-License-Identifier: BSD-3-Clause
"""A surface becomes a solid: --voxel fills it, finite elements tell how it gives way as a whole."""
import re
import unittest

import bodies
from session import SessionCase, peak_force
from vtkmodules.vtkFiltersSources import vtkSphereSource


class Voxel(SessionCase):
    def test_solid_on_its_lowest_side_is_softer_than_a_half_space(self):
        half_space = self.press(bodies.sphere(), "ball.vtp")
        solid = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4", "--fixed", "z-")
        self.assertRegex(solid.stderr, r"filled with \d+ hexahedra of 4 mm, held at z-")
        lowest, highest = map(float, re.search(
            r"gives way by (\S+) to (\S+) mm/N", solid.stderr).groups())
        self.assertLess(lowest, highest)
        # Pressed at the top: the whole ball yields on its small foot.
        self.assertLess(peak_force(solid), peak_force(half_space))
        self.assertIn("finite elements", solid.stdout)

    def test_held_on_more_sides_it_is_stiffer(self):
        foot = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4")
        clamped = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4", "--fixed", "z-,x-,x+,y-,y+")
        self.assertGreater(peak_force(clamped), peak_force(foot))

    def test_what_cannot_be_filled_is_refused(self):
        half = vtkSphereSource()
        half.SetRadius(25)
        half.SetEndTheta(200)
        half.Update()
        path = bodies.write(half.GetOutput(), self.folder / "half.vtp")
        self.refuse(path, "--voxel", "2", words=("closed",))
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        self.refuse(path, "--voxel", "80", words=("Spacing",))
        self.refuse(path, "--voxel", "4", "--poisson", "0.5", words=("0.499",))


if __name__ == "__main__":
    unittest.main()
