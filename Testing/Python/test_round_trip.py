#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A body with its response that is saved as .vtp is complete: a separate Python with only numpy and VTK's reader gets
the same curves from the file.

The data are inline. Testing/Cxx/Response/TestRoundTrip.cxx states the reason against appended data.
"""
import os
import tempfile
import unittest

import numpy as np

from palpate import contract, vtkContactTool, vtkToolContactResponse
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter


class RoundTrip(unittest.TestCase):
    def test_saved_curves_are_the_same(self):
        ball = vtkSphereSource()
        ball.SetRadius(30.0)
        tool = vtkContactTool()
        tool.SetSpecification("sphere:6.35")
        response = vtkToolContactResponse()
        response.SetInputConnection(ball.GetOutputPort())
        response.SetTool(tool)
        response.SetResponseName("Sphere")
        response.CurvatureCorrectionOff()  # uncorrected law of the tool
        with tempfile.TemporaryDirectory() as folder:
            writer = vtkXMLPolyDataWriter()
            writer.SetInputConnection(response.GetOutputPort())
            writer.SetFileName(os.path.join(folder, "body.vtp"))
            writer.SetDataModeToBinary()
            self.assertEqual(writer.Write(), 1)
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(writer.GetFileName())
            reader.Update()
        field = reader.GetOutput().GetFieldData()
        self.assertEqual(field.GetAbstractArray("SphereTool").GetValue(0), "sphere:6.35")
        self.assertEqual(field.GetAbstractArray("SphereUnits").GetValue(0), "mm,N,MPa")
        before = contract.load(response.GetOutput(), "Sphere")
        after = contract.load(reader.GetOutput(), "Sphere")
        for key, value in before.items():
            np.testing.assert_array_equal(after[key], value)
        # The storage error of an exact sphere of this size is below 5e-4 (benchmark StorageError).
        modulus = 0.1 / (1 - 0.45 ** 2)
        for depth in np.linspace(0.02, 2.0, 50):
            force, _ = contract.evaluate(after, 3, depth)
            self.assertAlmostEqual(float(force) / tool.GetForce(depth, modulus), 1.0, delta=5e-4)


if __name__ == "__main__":
    unittest.main(verbosity=2)
