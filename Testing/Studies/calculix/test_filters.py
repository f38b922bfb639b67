#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the project's filters with the committed finite-element curves: the response of vtkToolContactResponse
for a half-space, a bonded layer and a plate in series is that of the bodies in CalculiX.

The tolerances are those of test_curves.py, plus 0.3 % for the storage in eight samples from 5 % of the range on.
"""
import unittest

import numpy as np

import cases
import compare
from palpate import contract, vtkContactTool, vtkToolContactResponse
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

STORAGE = 0.003


def response(case, layer=0.0, compliance=None):
    """Returns the force of the filter's response at the depths of the case, on a plane square."""
    square, triangles = vtkPlaneSource(), vtkTriangleFilter()
    triangles.SetInputConnection(square.GetOutputPort())
    triangles.Update()
    body = triangles.GetOutput()
    tool = vtkContactTool()
    getattr(tool, "SetShapeTo" + case.tool.shape.capitalize())()
    tool.SetRadius(case.tool.radius)
    laws = vtkToolContactResponse()
    if compliance is not None:
        array = numpy_to_vtk(np.full(body.GetNumberOfPoints(), compliance), deep=1)
        array.SetName("GlobalCompliance")
        body.GetPointData().AddArray(array)
        laws.SetInputArrayToProcess(2, 0, 0, 0, "GlobalCompliance")
    laws.SetInputData(body)
    laws.SetTool(tool)
    laws.SetYoungsModulus(cases.YOUNGS_MODULUS)
    laws.SetPoissonRatio(case.body.poisson_ratio)
    laws.SetLayerThickness(layer)
    laws.SetMaximumDeflection(case.largest_deflection)
    laws.Update()
    return contract.evaluate(contract.load(laws.GetOutput()), 0, cases.deflections(case))[0]


def curve(body, tool, material):
    name = "{}-{}-{}".format(body.name, tool.name, material)
    return cases.CASES[name], compare.read_curve(compare.DATA / (name + ".csv"))[1]


class TestFilters(unittest.TestCase):
    def test_half_space_and_layer(self):
        # The filters solve the small-strain problem of the flat exactly; the spheres are compared
        # at finite strain.
        for body, thickness in ((cases.BLOCK, 0.0), (cases.LAYER, cases.LAYER.thickness)):
            for tool, material, allowed in ((cases.FLAT, "linear", 0.002), (cases.LARGE, "neohooke", 0.03),
                                            (cases.SMALL, "neohooke", 0.015)):
                case, forces = curve(body, tool, material)
                np.testing.assert_allclose(response(case, thickness) / forces, 1, atol=allowed + STORAGE,
                                           err_msg=case.name)

    def test_layer_is_not_a_half_space(self):
        # The comparison above would detect a wrong body, because the layer is at least 15 % stiffer.
        case, forces = curve(cases.LAYER, cases.FLAT, "linear")
        self.assertTrue(np.all(forces > 1.15 * response(case)))

    def test_plate_in_series(self):
        # The compliance is identified from the flat's curve; the filter then predicts the spheres.
        for body in (cases.CLAMPED, cases.EDGES):
            flat, forces = curve(body, cases.FLAT, "linear")
            identified = compare.compliance(flat, cases.deflections(flat), forces)[0]
            for tool in (cases.LARGE, cases.SMALL):
                case, forces = curve(body, tool, "linear")
                np.testing.assert_allclose(response(case, compliance=identified)[1:] / forces[1:], 1,
                                           atol=0.013 + STORAGE, err_msg=case.name)


if __name__ == "__main__":
    unittest.main()
