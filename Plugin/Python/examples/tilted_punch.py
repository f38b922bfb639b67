# SPDX-License-Identifier: BSD-3-Clause
"""A tilted flat end: prints and draws force and torque at one depth of its deepest point, with boundary elements.

    ./run python Plugin/Python/examples/tilted_punch.py [OUTPUT.png]    (default: tilted_punch.png)
"""
import csv
import pathlib
import sys
import numpy as np
import palpate
import vtkmodules.vtkRenderingContextOpenGL2                # draws charts
import vtkmodules.vtkRenderingFreeType                      # draws the texts of charts
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
from vtkmodules.util.numpy_support import numpy_to_vtk

POISSON, RADIUS, DEPTH = 0.45, 1.0, 0.2                     # -, mm, mm: depth of the deepest point, at the rim
YOUNG = 1 - POISSON**2                                      # MPa: a reduced modulus of 1 MPa

plane = np.array([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0.0]]), np.array([[0, 1, 2], [0, 2, 3]])
body = palpate.response(plane, "flat:%g" % RADIUS, YOUNG, POISSON, maximum_deflection=0.5, tilt=30)


def feel(degrees):
    """Returns force (N) and torque about the middle of the end (N mm), positive if it turns the tool upright."""
    sine, cosine = np.sin(np.radians(degrees)), np.cos(np.radians(degrees))
    zeros = np.zeros_like(degrees)
    axis, tips = np.stack((sine, zeros, cosine), 1), np.stack((zeros, zeros, RADIUS * sine - DEPTH), 1)
    felt = palpate.probe(body, tips, axis=axis)
    return felt.normal_force, -felt.torque[:, 1]


table = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Reference" / "tilt" / "tilt_bem.csv"
with open(table, encoding="utf-8") as file:
    solved = [row for row in csv.DictReader(file) if row["tool"] == "flat" and float(row["D"]) == DEPTH]
solved = np.array([[float(row[name]) for name in ("theta_deg", "F_over_Estar", "Mtip_vertical")] for row in solved])
solved = solved[(solved[:, 0] > 0) & (solved[:, 0] <= 25)]
upright = feel(np.zeros(1))[0][0]
print("upright: %.4f N" % upright)
for angle, *true, force, torque in np.column_stack((solved, *feel(solved[:, 0]))):
    print("%4.1f degrees: %.4f N, %.3f of upright, and %.4f N mm; boundary elements %.4f N, %.4f N mm" % (
        angle, force, force / upright, torque, *true))

fine = np.linspace(0, 25, 251)
view, chart = vtkContextView(), vtkChartXY()
for axis, text in ((vtkAxis.BOTTOM, "tilt (degrees)"), (vtkAxis.LEFT, "force (N)"), (vtkAxis.RIGHT, "torque (N mm)")):
    chart.GetAxis(axis).SetTitle(text)
for kind, rows, whose in ((vtkChart.LINE, np.column_stack((fine, *feel(fine))), ""),
                          (vtkChart.POINTS, solved, ", boundary elements")):
    for column, (name, colour) in enumerate((("force", (0, 80, 180)), ("torque", (210, 90, 0))), 1):
        data, plot = vtkTable(), chart.AddPlot(kind)
        for label, values in (("tilt", rows[:, 0]), (name + whose, rows[:, column])):
            array = numpy_to_vtk(values, deep=True)
            array.SetName(label)
            data.AddColumn(array)
        plot.SetInputData(data, 0, 1)
        plot.SetColor(*colour, 255)
        plot.SetWidth(2)
        chart.SetPlotCorner(plot, column - 1)               # force at the left axis, torque at the right axis
chart.SetTitle("A flat end of 1 mm radius, its rim 0.2 mm deep in 1 MPa")
chart.SetShowLegend(True)
view.GetRenderWindow().SetOffScreenRendering(1)
view.GetRenderWindow().SetSize(700, 500)
view.GetScene().AddItem(chart)
view.GetRenderWindow().Render()
grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
grab.SetInput(view.GetRenderWindow())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "tilted_punch.png")
writer.SetInputConnection(grab.GetOutputPort())
writer.Write()
