# SPDX-License-Identifier: BSD-3-Clause
"""--voxel fills a surface to make a solid, and finite elements compute its global compliance."""
import re
import unittest

import bodies
import numpy
from session import PICTURES, SessionCase, peak_force
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


class Voxel(SessionCase):
    def test_solid_on_its_lowest_side_is_softer_than_a_half_space(self):
        half_space = self.press(bodies.sphere(), "ball.vtp")
        solid = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4", "--fixed", "z-", pictures=PICTURES)
        self.assertRegex(solid.stderr, r"filled with \d+ hexahedra of 4 mm, held at z-")
        lowest, highest = map(float, re.search(
            r"gives way by (\S+) to (\S+) mm/N", solid.stderr).groups())
        self.assertLess(lowest, highest)
        # The ball is pressed at the top, so the whole ball deflects on its small foot.
        self.assertLess(peak_force(solid), peak_force(half_space))
        self.assertIn("finite elements", solid.stdout)

    def test_held_on_more_sides_it_is_stiffer(self):
        foot = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4")
        clamped = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4", "--fixed", "z-,x-,x+,y-,y+")
        self.assertGreater(peak_force(clamped), peak_force(foot))

    def test_six_modes_of_its_motion_come_with_the_compliance(self):
        saved = self.folder / "saved.vtp"
        solid = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4", "--save", saved)
        self.assertRegex(solid.stderr, r"the 6 modes that are drawn leave out \d+ %")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(saved))
        reader.Update()
        body = reader.GetOutput()
        points = {name: vtk_to_numpy(body.GetPointData().GetArray(name)) for name in
                  ("GlobalCompliance", "ResponseNormal", *(f"GlobalMode{k}" for k in range(6)))}
        signs = vtk_to_numpy(body.GetFieldData().GetArray("GlobalModeSign"))
        # A force of 1 N moves its own point inward by C_g. The modes must reproduce this
        # displacement.
        moved = sum(signs[k] * (points["ResponseNormal"] * points[f"GlobalMode{k}"]).sum(axis=1) ** 2
                    for k in range(6))
        # Only points far from the foot are compared. There the compliance comes only from valid
        # points, within six voxels.
        far = vtk_to_numpy(body.GetPoints().GetData())[:, 2] > -10.0
        error = (moved - points["GlobalCompliance"])[far]
        self.assertLess(numpy.sqrt((error ** 2).mean()),
                        0.1 * numpy.sqrt((points["GlobalCompliance"][far] ** 2).mean()))

    def test_a_side_that_is_held_has_a_compliance_too(self):
        self.press(bodies.block(), "block.vtu", "--voxel", "2.5")

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
