# SPDX-License-Identifier: BSD-3-Clause
"""Plays ResponseInGui.xml in the ParaView program, which must end without an error, and checks its output.

    pvpython gui.py PARAVIEW RESPONSE_IN_GUI.XML FOLDER      needs an X server
"""
import os
import sys
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from program import need_display, pixels, play

program, events, folder = sys.argv[1:]
need_display()
picture, state = folder + "/response.png", folder + "/response.pvsm"
for old in (picture, state):
    if os.path.exists(old):
        os.remove(old)

play(program, events, folder)
colours = pixels(picture)
ball = (colours[:, 0] > colours[:, 2] + 40).mean() # normals towards the viewer are red
assert 0.05 < ball < 0.5, ball

simple.LoadState(state)
response = simple.FindSource("ToolContactResponse1")
assert response.Tool.Shape == "Cone" and response.Tool.HalfAngledegrees == 20
response.CurvatureCorrection = 0                            # uncorrected law of the cone
force = vtk_to_numpy(servermanager.Fetch(response).GetPointData().GetArray("ResponseForce"))
cone = 2 / np.pi * np.tan(np.radians(20)) * 0.1 / (1 - 0.45**2) * 3**2
np.testing.assert_allclose(force[:, -1], cone, rtol=1e-6)    # float rounding
