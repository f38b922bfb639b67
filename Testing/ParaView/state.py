# SPDX-License-Identifier: BSD-3-Clause
"""A pipeline saved as a state, XML or Python, comes back with its numbers: state.py FOLDER"""
import sys
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def build():
    ball = simple.Sphere(Radius=50, ThetaResolution=60, PhiResolution=60)
    body = simple.Calculator(Input=ball, ResultArrayName="Stiff", Function="0.05 + 0.001 * abs(coordsX)")
    body.UpdatePipeline()
    response = simple.ToolContactResponse(Input=body, YoungsModulusArrayMPa=["POINTS", "Stiff"],
                                          MaximumDeflectionmm=3, ResponseName="Cone")
    response.Tool.Shape = "Cone"
    response.Tool.HalfAngledegrees = 45
    tips = simple.Line(Point1=(53, 0, 5), Point2=(48, 0, 5), Resolution=4)
    probe = simple.ToolContactProbe(Body=response, Tips=tips, ResponseName="Cone", Indentationmm=0.25)
    dent = simple.ContactDeflection(Body=response, Tips=probe, ResponseName="Cone", TipIndex=3)
    curves = simple.ResponseCurves(Input=response, ResponseName="Cone", PointIds=[3, 7])
    for name, proxy in (("response", response), ("probe", probe), ("dent", dent), ("curves", curves)):
        simple.RenameSource(name, proxy)
    simple.Show(dent)


def result():
    """Every number that comes out of the pipeline, by source and array."""
    numbers = {}
    for name in ("response", "probe", "dent", "curves"):
        source = simple.FindSource(name)
        assert source is not None, name + " did not come back"
        data = servermanager.Fetch(source)
        arrays = data.GetRowData() if data.IsA("vtkTable") else data.GetPointData()
        for i in range(arrays.GetNumberOfArrays()):
            numbers[name, arrays.GetArrayName(i)] = vtk_to_numpy(arrays.GetArray(i))
    response = simple.FindSource("response")
    assert response.Tool.Shape == "Cone" and response.Tool.HalfAngledegrees == 45
    assert list(response.GlobalComplianceArraymmN)[1] in ("None", "")
    return numbers


build()
before = result()
assert before["probe", "NormalForce"][-1] > 0 and abs(before["dent", "ContactDisplacement"]).max() > 0.05
for suffix in (".pvsm", ".py"):
    file = sys.argv[1] + "/pipeline" + suffix
    simple.SaveState(file)
    simple.ResetSession()
    assert not simple.GetSources()
    simple.LoadState(file)
    after = result()
    assert after.keys() == before.keys()
    for key in before:
        np.testing.assert_array_equal(after[key], before[key], str(key))
