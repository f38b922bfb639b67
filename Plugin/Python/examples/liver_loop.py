# SPDX-License-Identifier: BSD-3-Clause
"""Presses a slab of liver 5 mm deep at 1 mm/s and releases it; prints the energy loss of the loop, and draws the loop.

    ./run python Plugin/Python/examples/liver_loop.py [OUTPUT.png]    (default: liver_loop.png)
"""
import sys

import numpy as np
import palpate
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
from vtkmodules.util.numpy_support import numpy_to_vtk
import vtkmodules.vtkRenderingContextOpenGL2                # draws charts
import vtkmodules.vtkRenderingFreeType                      # draws the texts of charts

points = [[-30, -30, 0], [30, -30, 0], [0, 30, 0]]          # mm
slab = np.array(points, dtype=float), np.array([[0, 1, 2]]) # one triangle, facing +z
body = palpate.response(slab, tool="paraboloid:6.35", young=0.01, poisson=0.5, layer=10, maximum_deflection=5,
                        samples=16, relax=[(0.5, 0.5), (0.5, 10)]) # strength, and time in s, of two branches

depth, speed = 5, 1                                         # mm, mm/s
time = np.arange(0, 2 * depth / speed, 0.001)               # s
tips = np.zeros((len(time), 3))
tips[:, 2] = np.abs(speed * time - depth) - depth           # down and up
felt = palpate.probe(body, tips, path=True, time=time)
slow = felt.normal_force - felt.memory
touches = felt.contact_cell >= 0

way = np.diff(felt.deflection[touches])
mean = (felt.normal_force[touches][1:] + felt.normal_force[touches][:-1]) / 2
work, loss = (mean * way)[way > 0].sum(), (mean * way).sum()
print("loss %.1f %% of the work" % (100 * loss / work))
print("peak %.3f N, %.2f times the slow force" % (felt.normal_force.max(), felt.normal_force.max() / slow.max()))
print("let go %.2f mm deep" % felt.deflection[touches][-1])

chart = palpate.vtkResponseChart()
chart.SetTitle("A slab of liver, 1 mm/s")
for label, force in (("felt", felt.normal_force), ("slow", slow)):
    curve = vtkTable()
    for name, values in (("Deflection (mm)", felt.deflection), ("Force (N)", force)):
        column = numpy_to_vtk(values[touches], deep=True)
        column.SetName(name)
        curve.AddColumn(column)
    chart.AddCurve(curve, label)
view = vtkContextView()
view.GetRenderWindow().SetOffScreenRendering(1)
view.GetRenderWindow().SetSize(700, 500)
view.GetScene().AddItem(chart.GetChart())
view.GetRenderWindow().Render()
grab = vtkWindowToImageFilter()
grab.SetInput(view.GetRenderWindow())
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "liver_loop.png")
writer.SetInputConnection(grab.GetOutputPort())
writer.Write()
