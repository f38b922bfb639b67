# SPDX-License-Identifier: BSD-3-Clause
"""A sphere presses 1 mm into a ball and slides on; prints where it is and what it feels.

    ./run python Plugin/Python/examples/probe_trajectory.py
"""
from palpate import vtkContactTool, vtkToolContactProbe, vtkToolContactResponse
from vtkmodules.vtkFiltersSources import vtkArcSource, vtkSphereSource

ball = vtkSphereSource()
ball.SetRadius(50)                                          # mm
ball.SetThetaResolution(200)
ball.SetPhiResolution(200)
tool = vtkContactTool()
tool.SetSpecification("sphere:6.35")
response = vtkToolContactResponse()
response.SetInputConnection(ball.GetOutputPort())
response.SetTool(tool)
path = vtkArcSource()                                       # a polyline is one history of contact
path.SetPoint1(49, 0, 0)
path.SetPoint2(0, 34.65, 34.65)
path.SetResolution(6)
probe = vtkToolContactProbe()
probe.SetInputConnection(0, response.GetOutputPort())
probe.SetInputConnection(1, path.GetOutputPort())
probe.Update()
felt = probe.GetOutput().GetPointData()                     # the force is that on the tool
for i in range(probe.GetOutput().GetNumberOfPoints()):
    print("tip (%6.2f %6.2f %6.2f) mm" % probe.GetOutput().GetPoint(i), end="  ")
    print("%.3f mm deep" % felt.GetArray("Deflection").GetValue(i), end="  ")
    print("(%6.3f %6.3f %6.3f) N" % felt.GetArray("Force").GetTuple3(i))
