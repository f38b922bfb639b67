# SPDX-License-Identifier: BSD-3-Clause
"""Plays ResponseInGui.xml in the ParaView program, which must end well, and looks at what it leaves.

    pvpython gui.py PARAVIEW RESPONSE_IN_GUI.XML FOLDER      needs an X server
"""
import os
import subprocess
import sys
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

program, events, folder = sys.argv[1:]
if not os.environ.get("DISPLAY"):
    print("no DISPLAY: the program was not started")
    sys.exit(77)
picture, state = folder + "/response.png", folder + "/response.pvsm"
for old in (picture, state):
    if os.path.exists(old):
        os.remove(old)

played = subprocess.run([program, "--dr", "--test-script=" + events, "--test-directory=" + folder, "--exit"],
                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=240, check=False)
print(played.stdout)
assert played.returncode == 0, played.returncode

reader = vtkPNGReader()
reader.SetFileName(picture)
reader.Update()
pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
ball = (pixels[:, 0] > pixels[:, 2].astype(int) + 40).mean() # red, for normals towards the viewer
assert 0.05 < ball < 0.5, ball

simple.LoadState(state)
response = simple.FindSource("ToolContactResponse1")
assert response.Tool.Shape == "Cone" and response.Tool.HalfAngledegrees == 20
force = vtk_to_numpy(servermanager.Fetch(response).GetPointData().GetArray("ResponseForce"))
cone = 2 / np.pi * np.tan(np.radians(20)) * 0.1 / (1 - 0.45**2) * 3**2
np.testing.assert_allclose(force[:, -1], cone, rtol=1e-6)    # float
