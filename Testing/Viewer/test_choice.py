# SPDX-License-Identifier: BSD-3-Clause
"""--auto, the default: the program uses the simplest response that keeps the forces; --verbose reports it."""
import re
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import bodies
from session import SessionCase, peak_force


def choice(result):
    """The sentence in the summary that states the choice."""
    return re.search(r"^  choice +(.+)$", result.stdout, re.MULTILINE).group(1)


class Choice(SessionCase):
    def trajectory(self):
        rows = numpy.genfromtxt(self.output / "trajectory.csv", delimiter=",", names=True, usecols=range(9))
        return rows["deflection_mm"], rows["normal_force_N"]

    def test_one_law_suffices_for_a_homogeneous_body_and_is_felt_as_before(self):
        flat = "--no-curvature"  # without it, the curvature of the mesh differs in the last digits of a float
        self.assertNotIn("choice  ", self.press(bodies.sphere(), "ball.vtp", flat).stdout)
        said = self.press(bodies.sphere(), "ball.vtp", flat, "--verbose")
        depth, force = self.trajectory()
        self.assertIn("one law suffices", choice(said))
        self.assertIn("0 instead of 16 numbers per point", choice(said))
        whole = self.press(bodies.sphere(), "ball.vtp", "--no-auto", flat, "--verbose")
        self.assertNotIn("choice  ", whole.stdout)
        depth_before, before = self.trajectory()
        numpy.testing.assert_allclose(depth, depth_before, rtol=1e-12, atol=1e-12)
        numpy.testing.assert_allclose(force, before, rtol=1e-12)  # sums in another order
        self.assertEqual(peak_force(said), peak_force(whole))

    def test_the_law_has_what_the_force_needs(self):
        said = self.press(bodies.sphere(), "ball.vtp", "--strain", "auto", "--verbose")
        self.assertRegex(choice(said), "Terms of its law: the body's curvature is in the law: without it the force is off by .* %; ")

    def test_responses_of_a_file_are_judged_too(self):
        saved = self.folder / "saved.vtp"
        self.press(bodies.sphere(), "ball.vtp", "--save", saved, "--no-curvature", "--error-tolerance", "0")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(saved))
        reader.Update()
        random = numpy.random.default_rng(4)
        points = reader.GetOutput().GetNumberOfPoints()
        moduli = random.permutation(numpy.linspace(0.5, 2.0, points))[:, None]
        for factors, words in (
                # First body: only Young's modulus varies. Second body: every sample of every point
                # has its own error.
                (lambda shape: moduli, ("one law suffices, times a number per point", "1 instead of 16")),
                (lambda shape: random.uniform(0.9, 1.1, shape), ("a response per vertex is needed", "all 16 numbers"))):
            body = vtkPolyData()
            body.ShallowCopy(reader.GetOutput())
            for name in ("ResponseForce", "ResponseStiffness"):
                values = vtk_to_numpy(body.GetPointData().GetArray(name))
                array = numpy_to_vtk((values * factors(values.shape)).astype(numpy.float32), deep=True)
                array.SetName(name)
                body.GetPointData().AddArray(array)
            # See the manual, Reference/arrays.md, for why the file is binary.
            path = bodies.write(body, self.folder / "uneven.vtp", DataMode=1)
            said = choice(self.succeed(path, "--verbose"))
            for word in words:
                self.assertIn(word, said)
            # The error by strain under a sphere of 3 mm is acceptable up to 0.5 mm.
            self.assertIn("1 mm is beyond the validity of the law at 100 % of the points (mostly small strain)", said)

    def test_a_body_that_gives_way_is_asked_for_its_regime(self):
        solid = self.press(bodies.sphere(), "ball.vtp", "--voxel", "4", "--verbose")
        self.assertRegex(choice(solid), r"the shape of the tool is felt 1 mm deep at [\d.]+ % of the points")

    def test_tolerances_that_make_no_sense_are_refused(self):
        for wrong in ("0", "-1", "nan", "soft"):
            self.refuse("--tolerance", wrong, words=("--tolerance",))


if __name__ == "__main__":
    unittest.main()
