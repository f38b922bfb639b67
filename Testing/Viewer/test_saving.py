# SPDX-License-Identifier: BSD-3-Clause
"""--save: the file contains the body with the responses of all its tools, and can be used like any other body."""
import unittest

from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import bodies
from session import SessionCase, peak_force, vertices


class Saving(SessionCase):
    def test_save(self):
        saved = self.folder / "saved.vtp"
        first = self.press(bodies.sphere(), "body.stl", "--tool", "flat:2", "--save", saved)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(saved))
        reader.Update()
        body = reader.GetOutput()
        self.assertEqual(body.GetNumberOfPoints(), vertices(first))
        for prefix, tool in (("Response", "sphere"), ("Response2", "flat")):
            data = body.GetPointData()
            self.assertEqual(data.GetArray(f"{prefix}Force").GetNumberOfComponents(), 8)
            self.assertEqual(data.GetArray(f"{prefix}Force").GetDataTypeAsString(), "float")
            for suffix, components in (("Stiffness", 8), ("Normal", 3), ("Range", 1), ("Status", 1),
                                       ("Validity", 1), ("Limit", 1)):
                array = data.GetArray(prefix + suffix)
                self.assertEqual(array.GetNumberOfComponents(), components, prefix + suffix)
            self.assertEqual(data.GetArray(f"{prefix}Status").GetRange(), (0.0, 0.0))
            field = body.GetFieldData()
            self.assertIn(tool, field.GetAbstractArray(f"{prefix}Tool").GetValue(0))
            self.assertEqual(field.GetAbstractArray(f"{prefix}Units").GetValue(0), "mm,N,MPa")
        again = self.succeed(  # used like any other body
            saved, "--tool", "sphere:3", "--young", "0.1", "--poisson", "0.45")
        self.assertAlmostEqual(peak_force(again), peak_force(first), delta=1e-3 * peak_force(first))

    def test_a_stored_response_that_lacks_an_array_is_refused(self):
        saved = self.folder / "saved.vtp"
        self.press(bodies.sphere(), "body.stl", "--save", saved)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(saved))
        for missing in ("ResponseForce", "ResponseNormal", "ResponseValidity", "ResponseLimit"):
            reader.Modified()
            reader.Update()
            body = vtkPolyData()
            body.ShallowCopy(reader.GetOutput())
            body.GetPointData().RemoveArray(missing)
            broken = bodies.write(body, self.folder / "broken.vtp")
            self.refuse(broken, words=("broken.vtp", missing))
            self.succeed(broken, "--tool", "sphere:3")  # a new response does not use the old one


if __name__ == "__main__":
    unittest.main()
