# SPDX-License-Identifier: BSD-3-Clause
"""A sphere 1 mm deep in a plate is dragged to and fro; prints where it is and what it feels.

    ./run python Plugin/Python/examples/friction_loop.py
"""
from palpate import vtkContactTool, vtkToolContactProbe, vtkToolContactResponse
from vtkmodules.vtkFiltersSources import vtkPolyLineSource, vtkRegularPolygonSource

plate = vtkRegularPolygonSource()                           # one triangle around the origin, facing -z
plate.SetNumberOfSides(3)
plate.SetRadius(5)                                          # mm
response = vtkToolContactResponse()                         # E 0.1 MPa, Poisson's ratio 0.45
response.SetInputConnection(plate.GetOutputPort())
response.SetTool(vtkContactTool())                          # a sphere of 5 mm
path = vtkPolyLineSource()                                  # a polyline is one history, with friction
path.SetNumberOfPoints(41)
for i, step in enumerate((*range(8), *range(8, -8, -1), *range(-8, 9))):
    path.SetPoint(i, 0.05 * step, 0.1, 1)                   # x from 0 to 0.4, to -0.4, to 0.4 mm
probe = vtkToolContactProbe()
probe.SetInputConnection(0, response.GetOutputPort())
probe.SetTipConnection(path.GetOutputPort())
probe.SetFrictionCoefficient(0.5)
probe.SetTangentialStiffness(0.8)                           # N/mm, while it sticks
probe.Update()
felt = probe.GetOutput().GetPointData()
for i in range(41):
    x, friction = probe.GetOutput().GetPoint(i)[0], felt.GetArray("FrictionForce").GetComponent(i, 0)
    sticks = felt.GetArray("ContactState").GetValue(i) == 1
    print("x %5.2f mm  friction %7.4f N " % (x, friction), "sticks" if sticks else "slides")
