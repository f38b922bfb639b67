# SPDX-License-Identifier: BSD-3-Clause
"""Plays ChartsInGui.xml in the ParaView program: the rubber band selects points, and one Apply shows their curves.

    pvpython charts_gui.py PARAVIEW CHARTS_IN_GUI.XML FOLDER      needs an X server
"""
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from program import need_display, pixels, play

program, events, folder = sys.argv[1:]
need_display()
picture, state = folder + "/curves_chart.png", folder + "/curves_chart.pvsm"
for old in (picture, state):
    if os.path.exists(old):
        os.remove(old)

play(program, events, folder)
colours = pixels(picture)                                   # of the active view, which is the chart
assert (colours.max(axis=1) - colours.min(axis=1) > 60).sum() > 200 # coloured lines on white
assert (colours.min(axis=1) > 240).mean() > 0.7

simple.LoadState(state)
curves = simple.FindSource("ResponseCurves1")
assert curves.Selection is not None
body = servermanager.Fetch(simple.FindSource("ToolContactResponse1"))
points = vtk_to_numpy(body.GetPoints().GetData())
columns = servermanager.Fetch(curves).GetRowData()
names = [columns.GetArrayName(i) for i in range(columns.GetNumberOfArrays())]
assert names[0] == "Deflection (mm)" and 1 < len(names) < len(points), names
chosen = [int(name.split()[3]) for name in names[1:] if ", " not in name]   # excludes the bands
assert (points[chosen, 2] > 0).all(), chosen                # on the visible side
near, far = np.hypot(*points[chosen, :2].T).max(), np.hypot(*points[points[:, 2] > 0, :2].T).max()
assert near < far, (near, far)                              # the middle of the visible side

view = [view for view in simple.GetViews() if view.SMProxy.GetXMLName() == "XYChartView"]
assert len(view) == 1, view
shown = simple.GetRepresentation(curves, view[0])
assert set(shown.SeriesVisibility) == set(names[1:]), list(shown.SeriesVisibility)
