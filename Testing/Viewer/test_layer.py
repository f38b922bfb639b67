# SPDX-License-Identifier: BSD-3-Clause
"""--layer: a layer on a rigid base, with a given thickness or the thickness from the scan."""
import re
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import bodies
from run_scene import SCAN
from session import PICTURES, SessionCase, peak_force

RADIUS, THICKNESS = 16.3, 6.0  # mm


def scanned_ball():
    """A ball made by bodies.ball_grey, with a dark core that is blurred in the same way."""
    size = 48
    core = bodies.distances(size, (0.5 * (size - 1),) * 3) - (RADIUS - THICKNESS)
    return bodies.image(numpy.minimum(
        bodies.ball_grey(size, RADIUS), numpy.clip(50.0 + 50.0 * core, 0.0, 100.0)))


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def array(body, name):
    return vtk_to_numpy(body.GetPointData().GetArray(name)).astype(float)


class Layer(SessionCase):
    def test_constant_layer_is_stiffer_the_thinner(self):
        forces = [peak_force(self.press(bodies.sphere(), "ball.vtp", *layer))
                  for layer in ((), ("--layer", "none"), ("--layer", "20"), ("--layer", "5"))]
        self.assertEqual(forces[0], forces[1])
        self.assertLess(forces[1], forces[2])
        self.assertLess(1.2 * forces[2], forces[3])

    def test_scan_of_a_user(self):
        path = bodies.write(scanned_ball(), self.folder / "ball.nii.gz")
        saved = self.folder / "saved.vtp"
        usual = ("--tool", "sphere:3", "--contour", "50", "--save", saved)
        plain = self.succeed(path, *usual)
        self.assertIn("half-space at every vertex", plain.stdout)
        self.assertFalse(read(saved).GetPointData().HasArray("LayerThickness"))
        layered = self.succeed(path, *usual, "--layer", "scan", pictures=(*PICTURES, "thickness"))
        # Tolerance: a tenth of a voxel for the base, and a tenth for the skin.
        thickness = array(read(saved), "LayerThickness")
        numpy.testing.assert_allclose(thickness, THICKNESS, atol=0.2)
        self.assertIn("at the 100 % of the vertices", layered.stdout)
        self.assertRegex(layered.stdout, r"times the force on a half-space: sphere:3 1\.[1-9]\d at")
        # The same scan in centimetres, and with no value that is considered bone.
        self.succeed(path, *usual, "--layer", "scan", "--length-unit", "cm", "--closing", "0",
                     "--depth", "0.5", pictures=(*PICTURES, "thickness"))
        self.assertAlmostEqual(array(read(saved), "LayerThickness").max(), 0.0)  # 60 mm is deeper than the search
        none = self.succeed(path, *usual, "--layer", "scan", "--base", "-1",
                            pictures=(*PICTURES, "thickness"))
        self.assertIn("the scan shows no bone", none.stdout)
        self.assertEqual(peak_force(none), peak_force(plain))

    def test_layers_on_each_other(self):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")

        def press(*options):
            return self.succeed(path, "--tool", "sphere:3", *options)

        one = peak_force(press("--layer", "6", "--young", "0.05", "--poisson", "0.45"))
        equal = press("--layers", "1.5:0.05:0.45,4.5:0.05:0.45")
        self.assertAlmostEqual(peak_force(equal) / one, 1.0, delta=2e-3)  # four printed digits
        self.assertIn("1.5 mm of 0.05 MPa, nu 0.45; 4.5 mm", equal.stdout)
        half_space = peak_force(press("--young", "0.05", "--poisson", "0.45"))
        on_equal = peak_force(press("--layers", "2:0.05:0.45,0:0.05:0.45"))
        self.assertAlmostEqual(on_equal / half_space, 1.0, delta=2e-3)
        self.assertAlmostEqual(peak_force(press("--layers", "6:0.05:0.45")) / one, 1.0, delta=2e-3)
        slips = peak_force(press("--layers", "1.5:0.05:0.45,4.5:0.05:0.45:slip"))
        slippery = peak_force(press("--layers", "1.5:0.05:0.45,4.5:0.05:0.45,slip"))
        self.assertLess(slips, 0.98 * one)
        self.assertLess(slippery, 0.98 * one)

    def test_layers_of_a_scan(self):
        path = bodies.write(scanned_ball(), self.folder / "ball.nii.gz")
        saved = self.folder / "saved.vtp"
        usual = ("--tool", "sphere:3", "--contour", "50", "--save", saved)
        result = self.succeed(path, *usual, "--layers", "2:0.2:0.48,scan:0.03:0.49", pictures=(*PICTURES, "thickness"))
        body = read(saved)
        numpy.testing.assert_allclose(array(body, "LayerThickness0"), 2.0)
        numpy.testing.assert_allclose(array(body, "LayerThickness1"), THICKNESS - 2.0, atol=0.2)
        stack = vtk_to_numpy(body.GetFieldData().GetArray("ResponseLayerStack"))
        numpy.testing.assert_allclose(stack[:, 1:3], [[0.2, 0.48], [0.03, 0.49]])
        self.assertIn("the rest of the soft tissue of 0.03 MPa", result.stdout)
        # On the soft base the force is less than with the first layer alone.
        self.assertIn("the first: sphere:3 0.", result.stdout)
        # At more than half of the points, the given thickness of the second layer is not possible.
        self.succeed(path, *usual, "--layers", "scan:0.03:0.49,50:0.2:0.48", pictures=(*PICTURES, "thickness"))
        body = read(saved)
        numpy.testing.assert_allclose(array(body, "LayerThickness0"), array(body, "LayerThickness1"))
        usual_layers = self.succeed(path, *usual, "--layers", "scan", pictures=(*PICTURES, "thickness"))
        self.assertIn("Pailler-Mattei", usual_layers.stdout)

    def test_only_a_scan_shows_its_layers(self):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        self.refuse(path, "--layers", "scan", words=("--layers scan", "no scan"))
        self.refuse(path, "--layers", "scan", "--young", "1", words=("--layers", "--young"))
        self.refuse(path, "--layers", "1:1:0.4", "--layer", "5", words=("--layers", "--layer"))

    def test_only_a_scan_shows_its_layer(self):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        self.refuse(path, "--layer", "scan", words=("ball.vtp", "no scan"))
        self.refuse(path, "--layer", "5", "--measured", "nowhere.csv", words=("--layer",))


@unittest.skipUnless(SCAN.exists(), f"{SCAN} is not installed (Debian: apt install mricron-data)")
class Head(SessionCase):
    """Colin 27. The ranges are our own reading of its grey values along the normal, with a margin of 2 mm. They detect
    a missing base or a wrong axis, but not an error below this margin."""

    def test_soft_tissue_over_the_skull(self):
        saved = self.folder / "head.vtp"
        result = self.succeed("--resolution", "3", "--no-curvature", "--save", saved,
                              pictures=(*PICTURES, "thickness"))
        body = read(saved)
        points = vtk_to_numpy(body.GetPoints().GetData()).astype(float) + (90, 125, 71)  # relative to the first voxel
        normals = array(body, "ResponseNormal")
        thickness = array(body, "LayerThickness")
        self.assertTrue((thickness >= 0.0).all() and (thickness <= 20.0).all())
        height = points[:, 2]
        forehead = (numpy.abs(points[:, 0] - 90) < 25) & (normals[:, 1] > 0.7) & (height > 70) & (height < 110)
        temple = (normals[:, 0] < -0.8) & (numpy.abs(points[:, 1] - 130) < 10) & (numpy.abs(height - 85) < 10)
        crown = height > 160
        neck = (normals[:, 1] < -0.7) & (height < 12)
        eyes = ((numpy.hypot(points[:, 0] - 125, height - 25) < 6) |
                (numpy.hypot(points[:, 0] - 57, height - 25) < 6)) & (normals[:, 1] > 0.5)
        for name, region, low, high in (("forehead", forehead, 4, 9), ("crown", crown, 8, 12),
                                        ("temple", temple, 9, 15)):
            with self.subTest(region=name):
                self.assertGreater(region.sum(), 20)
                self.assertGreater((thickness[region] > 0).mean(), 0.99)
                self.assertTrue(low < numpy.median(thickness[region]) < high,
                                numpy.median(thickness[region]))
        for name, region in (("neck", neck), ("eyes", eyes)):  # soft tissue without bone
            with self.subTest(region=name):
                self.assertGreater(region.sum(), 20)
                self.assertLess((thickness[region] > 0).mean(), 0.1)
        share = float(re.search(r"at the (\d+) % of the vertices", result.stdout).group(1))
        self.assertAlmostEqual(share, 100 * (thickness > 0).mean(), delta=0.6)
        # The force is larger over bone and equal elsewhere, where all points have the samples of
        # one tool on a half-space.
        deepest = array(body, "ResponseForce")[:, -1]
        half_space = numpy.median(deepest[thickness == 0])
        numpy.testing.assert_allclose(deepest[thickness == 0], half_space, rtol=1e-5)
        self.assertTrue((deepest[thickness > 0] > half_space).all())

    def test_half_space_on_request(self):
        result = self.succeed("--resolution", "3", "--layer", "none")
        self.assertIn("half-space at every vertex", result.stdout)
        self.assertNotIn("elastic layer", result.stdout)


if __name__ == "__main__":
    unittest.main()
