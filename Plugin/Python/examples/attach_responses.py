# SPDX-License-Identifier: BSD-3-Clause
"""Attaches the responses of two tools to a body and saves it; prints the names of the arrays.

    ./run python Plugin/Python/examples/attach_responses.py [OUTPUT.vtp]    (default: ball.vtp)
"""
import sys
import palpate
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

ball = vtkSphereSource()
ball.SetRadius(50)                                          # mm
ball.SetPhiResolution(64)
body = palpate.response(ball, tool="sphere:6.35", young=0.05, name="Finger", compliance=None)
# Several tools need several names.
body = palpate.response(body, tool="flat:3", young=0.05, name="Punch", compliance=None)

writer = vtkXMLPolyDataWriter()
writer.SetInputData(body)
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "ball.vtp")
writer.SetDataModeToBinary()                                # VTK 9.2 fails to read appended data here
writer.Write()
points = body.GetPointData()
print(writer.GetFileName(), *(points.GetArrayName(i) for i in range(points.GetNumberOfArrays())))
