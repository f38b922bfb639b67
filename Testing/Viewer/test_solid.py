# SPDX-License-Identifier: BSD-3-Clause
"""--solid: a surface is filled with tetrahedra, and each of its points has the response of the body's true shape."""
import pathlib
import re
import unittest

import bodies
import numpy
from session import CACHE, SessionCase, peak_force
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

RADIUS = 25.0
BOTTOM = -15.0
SPACING = 5.0  # a fifth of the radius
COARSE = 8.0  # where forces are not checked


def dome():
    """A ball with a flat bottom. The contact area of a round bottom would depend on the cells."""
    body = bodies.sphere(RADIUS)
    places = vtk_to_numpy(body.GetPoints().GetData())
    places[:, 2] = numpy.maximum(places[:, 2], BOTTOM)
    return body


def cached():
    return list(pathlib.Path(CACHE.name).glob("palpate/solid-*.vtp"))


class SolidCase(SessionCase):
    def setUp(self):
        super().setUp()
        for file in cached():
            file.unlink()

    def responses(self, *arguments, spacing=SPACING):
        saved = self.folder / "saved.vtp"
        self.result = self.press(dome(), "dome.vtp", "--solid", spacing, "--save", saved,
                                 *arguments)
        if "PALPATE_USE_CGAL" in self.result.stderr:
            self.skipTest("built without CGAL")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(saved))
        reader.Update()
        self.body = reader.GetOutput()
        return {name: vtk_to_numpy(self.body.GetPointData().GetArray(f"Response{name}"))
                for name in ("Force", "Stiffness", "Range", "Status", "Normal")}


class Solid(SolidCase):
    def test_several_tools_share_the_solid(self):
        found = self.responses("--tool", "sphere:6.35", "--tool", "flat:1.6", spacing=COARSE)
        second = vtk_to_numpy(self.body.GetPointData().GetArray("Response2Force"))
        top = found["Normal"][:, 2].argmax()
        self.assertNotEqual(second[top, 1], found["Force"][top, 1])
        self.assertRegex(self.result.stderr, r"\d tools in")

    def test_the_second_time_it_is_there(self):
        first = self.responses("--tool", "sphere:4", spacing=COARSE)
        self.assertIn("filled with", self.result.stderr)
        again = self.responses("--tool", "sphere:4", spacing=COARSE)
        self.assertRegex(self.result.stderr, r"its solid's responses taken from the cache .*solid-\w+\.vtp")
        self.assertNotIn("filled with", self.result.stderr)
        for name, values in first.items():
            numpy.testing.assert_array_equal(values, again[name])
        # With other held points, or with a truncated cache file, the solid is solved again.
        self.responses("--tool", "sphere:4", "--fixed", "z-:4", spacing=COARSE)
        self.assertIn("filled with", self.result.stderr)
        self.assertEqual(len(cached()), 2)
        for file in cached():
            file.write_bytes(file.read_bytes()[:5000])
        broken = self.responses("--tool", "sphere:4", spacing=COARSE)
        self.assertIn("filled with", self.result.stderr)
        numpy.testing.assert_array_equal(first["Force"], broken["Force"])

    def test_all_warnings_are_told(self):
        body = bodies.sphere(RADIUS)
        body.BuildCells()
        for cell in (700, 701):
            body.DeleteCell(cell)
        body.RemoveDeletedCells()
        path = bodies.write(body, self.folder / "hole.vtp")
        result = self.refuse(path, "--solid", "5", "--fixed", "z-:1000", words=("every point of the body is fixed",))
        for warning in ("holes were filled", "held part ends at whole cells, since nothing of the body would be left"):
            self.assertEqual(result.stderr.count(warning), 1, result.stderr)

    def test_what_cannot_be_filled_is_refused(self):
        half = vtkSphereSource()
        half.SetRadius(25)
        half.SetEndTheta(200)
        half.Update()
        path = bodies.write(half.GetOutput(), self.folder / "half.vtp")
        self.refuse(path, "--solid", "2", words=("closed",))
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        self.refuse(path, "--solid", "0.001", words=("Surface Spacing", "MiB"))
        self.refuse(path, "--solid", "5", "--poisson", "0.5", words=("0.499",))


class SolidForces(SolidCase):
    """Forces compared with other methods and by symmetry; takes half a minute."""

    def test_the_surface_feels_its_solid(self):
        found = self.responses()
        self.assertRegex(self.result.stderr,
                         r"filled with \d+ tetrahedra of \d+ nodes, 5 mm at the surface, held at z-")
        places = vtk_to_numpy(self.body.GetPoints().GetData()).astype(float)
        above = places[:, 2] > BOTTOM + 2.0
        radial = places[above] / numpy.linalg.norm(places[above], axis=1)[:, None]
        self.assertGreater((radial * found["Normal"][above]).sum(axis=1).min(), 0.99)
        held = places[:, 2] < BOTTOM + 0.01
        self.assertTrue((found["Status"][held] != 0).all())
        self.assertTrue((found["Force"][held] == 0.0).all())
        away = places[:, 2] > 0.0
        self.assertTrue((found["Status"][away] == 0).all())
        self.assertTrue((found["Range"][away] == 2.0).all())
        # The ball is a body of revolution, but its cells are not: 0.3 % error from the cells, and
        # 0.3 % from interpolation.
        deepest = found["Force"][:, -1]
        for latitude in {round(z, 3) for z in places[away, 2] if z < 24.9}:
            ring = deepest[numpy.abs(places[:, 2] - latitude) < 2e-3]
            self.assertEqual(len(ring), 64)
            self.assertLess(numpy.ptp(ring) / ring.mean(), 0.03)
        self.assertTrue((numpy.diff(found["Force"][away], axis=1) > 0.0).all())
        self.assertTrue((found["Stiffness"][away][:, 1:] > 0.0).all())

    def test_it_agrees_with_local_law_and_compliance_in_series(self):
        """Another method on other elements: the law of a curved half-space in series with the compliance of voxels."""
        self.responses("--depth", "0.5")
        series = self.press(dome(), "dome.vtp", "--voxel", "2.5", "--depth", "0.5")
        # The series model uses the compliance of a point for the compliance of the contact, which
        # gives an error of some per cent.
        self.assertLess(abs(peak_force(self.result) / peak_force(series) - 1.0), 0.06)

    def test_the_size_is_chosen_from_body_and_tool(self):
        result = self.press(bodies.sphere(6.0), "small.vtp", "--solid", "--tool", "sphere:3", "--depth", "0.2")
        if "PALPATE_USE_CGAL" not in result.stderr:
            chosen = float(re.search(r"nodes, (\S+) mm at the surface \(chosen", result.stderr).group(1))
            self.assertLess(chosen, 6.0 / 3.0)

    def test_a_scan_of_few_points_is_felt(self):
        """The facets of the scan are longer than the contact, and irregular. This gives a warning, not a failure."""
        source = vtkSphereSource()
        source.SetRadius(RADIUS)
        source.SetThetaResolution(20)
        source.SetPhiResolution(12)
        source.Update()
        body = source.GetOutput()
        places = vtk_to_numpy(body.GetPoints().GetData())
        places *= 1.0 + 0.02 * numpy.random.default_rng(1).uniform(-1.0, 1.0, len(places))[:, None]
        saved = self.folder / "coarse-saved.vtp"
        result = self.press(body, "coarse.vtp", "--solid", "6", "--depth", "0.5", "--save", saved)
        if "PALPATE_USE_CGAL" in result.stderr:
            self.skipTest("built without CGAL")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(saved))
        reader.Update()
        between = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("ResponseSurfaceError"))
        self.assertGreater((between > 0.05).mean(), 0.1)  # the filter warns about this error


if __name__ == "__main__":
    unittest.main()
