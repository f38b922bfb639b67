# SPDX-License-Identifier: BSD-3-Clause
"""The choice None for an array leaves the filter's index unset; an array sets the index; None unsets it again."""
import numpy as np
import palpate  # noqa: F401 - gives the client-side objects their class
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

ball = simple.Sphere(Radius=50)
# The active scalars of the body, which ParaView would choose by default.
body = simple.Calculator(Input=ball, ResultArrayName="Stiff", Function="0.05 + 0.001 * abs(coordsX)")
body.UpdatePipeline()
response = simple.ToolContactResponse(Input=body, CurvatureCorrection=0, WholeBody=0)  # closed forms
made = response.GetClientSideObject()


def indices_set():
    response.UpdateVTKObjects()
    return [i for i in range(4) if made.GetInputArrayInformation(i).Has(made.INPUT_PORT())]


def modulus():
    """The modulus that the filter used, from the force on a flat punch, 2 a E* depth."""
    data = servermanager.Fetch(response)
    force = vtk_to_numpy(data.GetPointData().GetArray("ResponseForce"))[:, -1]
    return force / (2 * 5 * 2) * (1 - 0.45**2)


response.Tool.Shape = "Flat"
assert indices_set() == [], indices_set()
assert response.YoungsModulusArrayMPa[1] == "None"
np.testing.assert_allclose(modulus(), 0.1, rtol=1e-6)

response.YoungsModulusArrayMPa = ["POINTS", "Stiff"]
assert indices_set() == [0]
stiff = vtk_to_numpy(servermanager.Fetch(body).GetPointData().GetArray("Stiff"))
np.testing.assert_allclose(modulus(), stiff, rtol=1e-6)

response.GlobalComplianceArraymmN = ["POINTS", "Stiff"]
response.PoissonsRatioArray = ["POINTS", "Stiff"]
assert indices_set() == [0, 2, 3]

for none in (None, ["POINTS", "None"], ["POINTS", ""]):
    response.YoungsModulusArrayMPa = ["POINTS", "Stiff"]
    assert indices_set() == [0, 2, 3]
    response.YoungsModulusArrayMPa = none
    assert indices_set() == [2, 3], none
response.GlobalComplianceArraymmN = response.PoissonsRatioArray = None
assert indices_set() == []
np.testing.assert_allclose(modulus(), 0.1, rtol=1e-6)
