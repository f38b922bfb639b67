#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The package palpate: its exports, and a complete script in the form that a user would write."""
import importlib
import math
import os
import pkgutil
import unittest

import palpate
from palpate import (vtkContactDeflection, vtkContactTool, vtkContactToolSource, vtkResponseCurves,
                     vtkToolContactProbe, vtkToolContactResponse)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkFiltersCore import vtkTriangleFilter


def half_space(size=20.0, cells=40):
    """A square of triangles in z = 0, facing +z."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-size, -size, 0)
    plane.SetPoint1(size, -size, 0)
    plane.SetPoint2(-size, size, 0)
    plane.SetResolution(cells, cells)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(plane.GetOutputPort())
    return triangles


def tips_at(*positions):
    points = vtkPoints()
    for position in positions:
        points.InsertNextPoint(position)
    tips = vtkPolyData()
    tips.SetPoints(points)
    return tips


class Package(unittest.TestCase):
    def test_every_wrapped_class_is_exported(self):
        modules = [module.name for module in pkgutil.iter_modules(palpate.__path__)
                   if module.name.startswith("palpate")]
        self.assertIn("palpateResponse", modules)
        for name in modules:
            wrapped = importlib.import_module("palpate." + name)
            classes = [key for key in dir(wrapped) if key.startswith("vtk")]
            self.assertTrue(classes, name)
            for key in classes:
                self.assertIs(getattr(palpate, key), getattr(wrapped, key))

    def test_package_comes_from_this_build(self):
        for folder in palpate.__path__:
            self.assertTrue(os.path.isfile(os.path.join(folder, "contract.py")))

    def test_printing(self):
        for kind in (vtkContactTool, vtkContactToolSource, vtkToolContactResponse,
                     vtkToolContactProbe, vtkContactDeflection, vtkResponseCurves):
            self.assertIn(kind.__name__, str(kind()))


class Tool(unittest.TestCase):
    def test_displacement_fills_a_list(self):
        tool = vtkContactTool()
        tool.SetShapeToFlat()
        tool.SetRadius(2.0)
        u = [0.0, 0.0]
        tool.GetSurfaceDisplacement(4.0, 0.3, 0.5, u)
        self.assertEqual(u[0], 0.0)  # incompressible: no radial displacement
        self.assertAlmostEqual(u[1], 2 * 0.3 / math.pi * math.asin(0.5), delta=1e-15)

    def test_specification(self):
        tool = vtkContactTool()
        self.assertTrue(tool.SetSpecification("paraboloid:6.35"))
        self.assertEqual(tool.GetSpecification(), "paraboloid:6.35")
        self.assertAlmostEqual(tool.GetForce(0.5, 3.45), 4.09826182667726, delta=1e-13)  # golden.csv

    def test_every_shape_in_writing(self):
        tool = vtkContactTool()
        for shape, text in (("Flat", "flat:1.6"), ("Paraboloid", "paraboloid:2"), ("Sphere", "sphere:2"),
                            ("Cone", "cone:60"), ("TruncatedCone", "truncated:1,60"),
                            ("BluntedCone", "blunted:1,60"), ("RoundedFlat", "rounded:1.2,0.4"),
                            ("PowerLaw", "power:4,0.01"), ("Profile", "profile:0,0;1,0.25;2,1")):
            self.assertTrue(tool.SetSpecification(text))
            self.assertEqual(tool.GetShape(), getattr(vtkContactTool, shape))
            self.assertEqual(tool.GetSpecification(), text)
            force = tool.GetForce(0.3, 1.0)
            getattr(tool, "SetShapeTo" + shape)()
            self.assertEqual(tool.GetForce(0.3, 1.0), force)

    def test_profile_from_points(self):
        points = vtkPoints()
        for r, f in ((0, 0), (1, 0.25), (2, 1)):
            points.InsertNextPoint(r, f, 0)
        tool = vtkContactTool()
        tool.SetShapeToProfile()
        tool.SetProfile(points)
        self.assertEqual(tool.GetProfile(1.5), 0.625)
        self.assertEqual(tool.GetProfilePoints().GetNumberOfPoints(), 3)
        self.assertEqual(tool.GetDepthLimit(), math.inf)

    def test_error_becomes_nan_and_an_event(self):
        tool = vtkContactTool()
        seen = []
        tool.AddObserver("ErrorEvent", lambda caller, event: seen.append(event))
        tool.SetRadius(-1)
        self.assertTrue(math.isnan(tool.GetForce(1, 1)))
        self.assertEqual(seen, ["ErrorEvent"])


class Script(unittest.TestCase):
    def test_end_to_end(self):
        body = half_space()
        tool = vtkContactTool()
        tool.SetShapeToParaboloid()
        tool.SetRadius(5.0)

        response = vtkToolContactResponse()
        response.SetInputConnection(body.GetOutputPort())
        response.SetTool(tool)
        response.SetYoungsModulus(0.03)
        response.SetPoissonRatio(0.5)
        response.Update()
        force = vtk_to_numpy(response.GetOutput().GetPointData().GetArray("ResponseForce"))
        self.assertEqual(force.shape, (41 * 41, 8))

        probe = vtkToolContactProbe()
        probe.SetInputConnection(response.GetOutputPort())
        probe.SetTipData(tips_at((0.1, 0.2, -1.0), (0.1, 0.2, 1.0)))
        probe.Update()
        felt = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("Force"))
        # Hertz. The tolerance is half a unit in the last place of a stored float, and the same for
        # the float coordinates of the tips.
        hertz = 4 / 3 * (0.03 / 0.75) * math.sqrt(5.0) * 1.0 ** 1.5
        self.assertAlmostEqual(felt[0, 2], hertz, delta=2e-7 * hertz)
        self.assertEqual(list(felt[1]), [0.0, 0.0, 0.0])

        deflection = vtkContactDeflection()
        deflection.SetInputConnection(response.GetOutputPort())
        deflection.SetTipConnection(probe.GetOutputPort())
        deflection.SetTipIndex(0)
        deflection.Update()
        moved = vtk_to_numpy(
            deflection.GetOutput().GetPointData().GetArray("ContactDisplacement"))
        # At most the deflection. The nearest vertex (0, 0) is 0.22 mm away; there the displacement
        # is smaller by r²/2R.
        self.assertAlmostEqual(-moved[:, 2].min(), 1.0 - 0.05 / 10.0, delta=1e-6)

        curves = vtkResponseCurves()
        curves.SetInputConnection(response.GetOutputPort())
        curves.AddPointId(7)
        curves.SetNumberOfRows(5)
        curves.Update()
        table = curves.GetOutput()
        self.assertEqual(table.GetNumberOfRows(), 5)
        self.assertAlmostEqual(table.GetValue(2, 1).ToDouble(), hertz, delta=2e-7 * hertz)  # 1 mm

        shape = vtkContactToolSource()
        shape.SetTool(tool)
        shape.Update()
        self.assertGreater(shape.GetOutput().GetNumberOfCells(), 100)


if __name__ == "__main__":
    unittest.main(verbosity=2)
