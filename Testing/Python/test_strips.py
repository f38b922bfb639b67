#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Triangle strips made by vtkStripper: each filter that takes a surface uses them, or its error names the filter that
converts them to triangles."""
import tempfile
import unittest
from pathlib import Path

import numpy as np
import palpate
from palpate import _filters
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkStripper, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

RADIUS = 20.0
ADVICE = r"\d+ triangle strips; apply Triangulate \(vtkTriangleFilter\) first"


def ball():
    source = vtkSphereSource()
    source.SetRadius(RADIUS)
    source.SetThetaResolution(24)
    source.SetPhiResolution(24)
    source.Update()
    return source.GetOutput()


def stripped(surface):
    filter = vtkStripper()
    filter.SetInputData(surface)
    filter.Update()
    strips = filter.GetOutput()
    assert strips.GetNumberOfStrips() > 0 and strips.GetNumberOfPolys() == 0
    return strips


def tool():
    made = palpate.vtkContactTool()
    made.SetSpecification("sphere:3")
    return made


def tip():
    points = vtkPoints()
    points.InsertNextPoint(0.0, 0.0, RADIUS - 0.5)
    made = vtkPolyData()
    made.SetPoints(points)
    return made


def scan():
    made = vtkImageData()
    made.SetDimensions(6, 6, 6)
    made.SetOrigin(-25, -25, -25)
    made.SetSpacing(10, 10, 10)
    made.AllocateScalars(VTK_FLOAT, 1)
    made.GetPointData().GetScalars().Fill(10)
    return made


def solid(spacing):
    made = palpate.vtkVoxelBody()    # in every build, while vtkGradedBody needs CGAL
    made.SetInputData(ball())
    made.SetSpacing(spacing)
    made.SetFixedFaces("z-:3")
    return made


class Strips(unittest.TestCase):
    def advises(self, filter, *others):
        with self.assertRaisesRegex(RuntimeError, ADVICE):
            _filters.run(filter, RuntimeError, others)
        self.assertEqual(filter.GetOutputDataObject(0).GetNumberOfElements(0), 0)   # no partial result

    def test_filters_of_bodies_and_responses(self):
        strips = stripped(ball())
        for kind in ("vtkToolContactResponse", "vtkContactRegime", "vtkBodyCompliance", "vtkGradedBody", "vtkVoxelBody"):
            with self.subTest(kind=kind):
                made = getattr(palpate, kind)()
                made.SetInputData(strips)
                if hasattr(made, "SetTool"):
                    made.SetTool(tool())
                self.advises(made)

    def test_thickness(self):
        made = palpate.vtkLayerThickness()
        made.SetInputData(0, stripped(ball()))
        made.SetScanData(scan())
        self.advises(made)

    def test_measured_response(self):
        with tempfile.TemporaryDirectory() as folder:
            name = Path(folder) / "curves.csv"
            name.write_text("# tool: sphere:3\nsite,x_mm,y_mm,z_mm,deflection_mm,force_N\n" + "".join(
                "1,0,0,20,%g,%g\n" % (depth, 0.1 * depth ** 1.5) for depth in np.linspace(0.05, 1, 20)), encoding="utf-8")
            made = palpate.vtkMeasuredContactResponse()
            made.SetInputData(stripped(ball()))
            made.AddFileName(str(name))
            made.SetTool(tool())
            self.advises(made)

    def test_true_shape(self):
        body, coarser = solid(5), solid(8)
        felt = palpate.vtkElasticContactResponse()
        felt.SetInputConnection(body.GetOutputPort())
        felt.SetTool(tool())
        felt.SetSourceSpacing(8)
        felt.SetSurfaceData(stripped(ball()))
        self.advises(felt)
        direct = palpate.vtkDirectContactResponse()
        direct.SetInputData(0, stripped(palpate.response(ball(), tool(), compliance=None)))
        direct.SetBodyConnection(body.GetOutputPort())
        direct.SetCoarserConnection(coarser.GetOutputPort())
        direct.SetTool(tool())
        self.advises(direct)

    def test_filters_of_bodies_with_responses(self):
        felt = stripped(palpate.response(ball(), tool(), compliance=None))
        for kind in ("vtkToolContactProbe", "vtkContactDeflection", "vtkToolTouch"):
            with self.subTest(kind=kind):
                made = getattr(palpate, kind)()
                made.SetInputData(0, felt)
                if hasattr(made, "SetTipData"):
                    made.SetTipData(tip())
                self.advises(made)

    def test_filters_of_arrays_use_strips(self):
        """A reduction and a choice of form change only the arrays of points."""
        made = palpate.response(ball(), tool(), compliance=None)
        for kind in ("vtkReducedContactResponse", "vtkResponseChoice", "vtkResponseCurves"):
            outputs = []
            for body in (made, stripped(made)):
                filter = getattr(palpate, kind)()
                filter.SetInputData(0, body)
                outputs.append(_filters.run(filter, RuntimeError).GetOutputDataObject(0))
            with self.subTest(kind=kind):
                data = [output.GetRowData() if kind == "vtkResponseCurves" else output.GetPointData()
                        for output in outputs]
                self.assertEqual(data[0].GetNumberOfArrays(), data[1].GetNumberOfArrays())
                for i in range(data[0].GetNumberOfArrays()):
                    if data[0].GetArray(i) is not None:
                        np.testing.assert_array_equal(*(vtk_to_numpy(each.GetArray(i)) for each in data))

    def test_body_surface_cuts_strips(self):
        body = ball()
        surface = palpate.vtkBodySurface()
        surface.SetInputData(stripped(body))
        made = _filters.run(surface).GetOutput()
        self.assertEqual(made.GetNumberOfPolys(), body.GetNumberOfPolys())
        self.assertEqual(made.GetNumberOfStrips(), 0)

    def test_the_advice_helps(self):
        triangles = vtkTriangleFilter()
        triangles.SetInputData(stripped(ball()))
        triangles.Update()
        felt, expected = (palpate.response(body, tool(), compliance=None) for body in (triangles.GetOutput(), ball()))
        np.testing.assert_allclose(*(vtk_to_numpy(each.GetPointData().GetArray("ResponseForce"))
                                     for each in (felt, expected)), rtol=1e-5)  # floats; another order of triangles

    def test_functions_on_arrays(self):
        with self.assertRaisesRegex(ValueError, ADVICE):
            palpate.response(stripped(ball()), tool())


if __name__ == "__main__":
    unittest.main(verbosity=2)
