# SPDX-License-Identifier: BSD-3-Clause
"""Attaches the responses of two tools to a body and saves it; prints the names of the arrays.

    ./run python Plugin/Python/examples/attach_responses.py [OUTPUT.vtp]    (default: ball.vtp)
"""
import sys
from palpate import vtkContactTool, vtkToolContactResponse
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

step = vtkSphereSource()
step.SetRadius(50)                                          # mm
step.SetPhiResolution(64)
for name, specification in (("Finger", "sphere:6.35"), ("Punch", "flat:3")):
    tool = vtkContactTool()
    tool.SetSpecification(specification)
    response = vtkToolContactResponse()
    response.SetInputConnection(step.GetOutputPort())
    response.SetTool(tool)
    response.SetYoungsModulus(0.05)                         # MPa
    response.SetResponseName(name)                          # several tools, several names
    step = response

writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(step.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "ball.vtp")
writer.SetDataModeToBinary()                                # VTK 9.2 fails to read appended data here
writer.Write()
points = step.GetOutput().GetPointData()
print(writer.GetFileName(), *(points.GetArrayName(i) for i in range(points.GetNumberOfArrays())))
