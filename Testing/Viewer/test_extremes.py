# SPDX-License-Identifier: BSD-3-Clause
"""Bodies, tools and materials at the limits: the forces follow the law, or the program refuses with a clear message."""
import math
import unittest

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

import bodies
from session import PICTURES, SessionCase, peak_force, vertices


def triangle():
    """Three vertices, facing +z."""
    points, cells = vtkPoints(), vtkCellArray()
    cells.InsertNextCell(3)
    for place in ((-15.0, -10.0, 0.0), (15.0, -10.0, 0.0), (0.0, 20.0, 0.0)):
        cells.InsertCellPoint(points.InsertNextPoint(place))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def many_balls(number):
    """Octahedra of 1 mm on a lattice in the plane z = 0."""
    side = math.ceil(math.sqrt(number))
    points, cells = vtkPoints(), vtkCellArray()
    corners = ((1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
    faces = ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (1, 0, 5), (2, 1, 5), (3, 2, 5), (0, 3, 5))
    for i in range(number):
        first = points.GetNumberOfPoints()
        x, y = 3.0 * (i % side - side // 2), 3.0 * (i // side - side // 2)
        for corner in corners:
            points.InsertNextPoint(corner[0] + x, corner[1] + y, corner[2])
        for face in faces:
            cells.InsertNextCell(3)
            for k in face:
                cells.InsertCellPoint(first + k)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def far(data, away):
    """The same body, `away` mm from the origin along each axis, with points in double precision."""
    move = vtkTransform()
    move.Translate(away, away, away)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(move)
    moved.SetInputData(data)
    moved.SetOutputPointsPrecision(1)
    moved.Update()
    return moved.GetOutput()


class Extremes(SessionCase):
    def test_one_triangle(self):
        felt = self.press(triangle(), "triangle.vtp", pictures=PICTURES)
        self.assertEqual(vertices(felt), 3)
        self.assertGreater(peak_force(felt), 0.0)

    def test_a_tool_larger_than_the_body_is_said_to_be_beyond_validity(self):
        path = bodies.write(bodies.sphere(5.0), self.folder / "pea.vtp")
        felt = self.succeed(path, "--tool", "sphere:1000", "--young", "0.1")
        self.assertTrue(math.isfinite(peak_force(felt)))
        self.assertRegex(felt.stdout, "(?m)^  error +± .*, mainly due to curvature of the body; above ± 5 % in 100 % of the contact$")

    def test_force_in_proportion_to_the_modulus(self):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        forces = [peak_force(self.succeed(path, "--tool", "sphere:3", "--young", young))
                  for young in ("1e-6", "1e6")]
        self.assertLess(abs(forces[1] / (1e12 * forces[0]) - 1.0), 0.02)  # the summary has three digits

    def test_materials_that_do_not_exist_are_refused(self):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        for option, value in (("--young", "0"), ("--young", "nan"), ("--poisson", "0.51")):
            with self.subTest(option=option, value=value):
                self.refuse(path, option, value, words=(option,))

    def test_voxels_that_do_not_fit_the_memory_are_refused_before_they_are_made(self):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        for spacing in ("0.02", "1e-300"):
            with self.subTest(spacing=spacing):
                self.refuse(path, "--voxel", spacing, words=("--voxel", "hexahedra", "MiB"))

    def test_a_kilometre_away_it_feels_the_same(self):
        here = peak_force(self.press(bodies.sphere(), "ball.vtp"))
        there = peak_force(self.press(far(bodies.sphere(), 1e6), "far.vtp", pictures=PICTURES))
        self.assertLess(abs(there / here - 1.0), 0.01)  # the summary has three digits

    def test_ten_thousand_pieces(self):
        felt = self.press(many_balls(101 ** 2), "pieces.vtp", pictures=PICTURES)
        self.assertEqual(vertices(felt), 6 * 101 ** 2)


if __name__ == "__main__":
    unittest.main()
