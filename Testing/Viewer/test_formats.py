# SPDX-License-Identifier: BSD-3-Clause
"""The session runs on files of every kind."""
import unittest

from vtkmodules.vtkFiltersCore import vtkReverseSense

import bodies
from session import SessionCase, peak_force, vertices


class Formats(SessionCase):
    def test_surfaces(self):
        # Hertz: 4/3 E* sqrt(R) d^1.5 with E* = 0.1/(1 - 0.45²), for a ball on a ball of 25 mm. The
        # exact sphere is slightly softer.
        hertz = 4.0 / 3.0 * 0.1 / (1.0 - 0.45 ** 2) * (1 / (1 / 3.0 + 1 / 25.0)) ** 0.5
        for name, settings in (
                ("ascii.stl", {"FileType": 1}), ("binary.stl", {"FileType": 2}),
                ("ascii.ply", {"FileType": 1}), ("binary.ply", {"FileType": 2}),
                ("body.obj", {}), ("ASCII.VTK", {}), ("body.vtk", {"FileType": 2}),
                ("ascii.vtp", {"DataMode": 0}), ("inline.vtp", {"DataMode": 1}),
                ("appended raw.vtp", {"DataMode": 2, "EncodeAppendedData": 0}),
                ("appended.vtp", {"DataMode": 2, "EncodeAppendedData": 1})):
            with self.subTest(name=name):
                result = self.press(bodies.sphere(), name, **settings)
                self.assertEqual(vertices(result), 64 * 62 + 2)
                self.assertAlmostEqual(peak_force(result), hertz, delta=0.05 * hertz)
                self.assertIn(name, result.stdout)

    def test_volume_mesh(self):
        for name in ("block.vtu", "block.vtk"):
            with self.subTest(name=name):
                result = self.press(bodies.block(), name)
                self.assertEqual(vertices(result), 21 * 21 * 11 - 19 * 19 * 9)
                self.assertIn("surface extracted from", result.stderr)

    def test_scans(self):
        scan = bodies.image(bodies.ball_grey())
        for name in ("scan.vti", "scan.nii.gz", "scan.vtk"):
            with self.subTest(name=name):
                result = self.press(scan, name, "--contour", "50")
                self.assertIn("outer skin of a scan of 48 x 48 x 48 voxels", result.stderr)
                self.assertGreater(vertices(result), 2000)

    def test_inside_out_body_is_turned(self):
        turned = vtkReverseSense()
        turned.SetInputData(bodies.sphere())
        turned.Update()
        result = self.press(turned.GetOutput(), "inside out.stl")
        self.assertIn("wound inward", result.stderr)
        self.assertGreater(peak_force(result), 0.1)


if __name__ == "__main__":
    unittest.main()
