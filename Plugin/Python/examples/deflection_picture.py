# SPDX-License-Identifier: BSD-3-Clause
"""Draws a ball that gives way under a cone, off screen; prints how deep. Needs a display: run finds one.
    ./run python Plugin/Python/examples/deflection_picture.py [OUTPUT.png]    (default: dent.png)
"""
import sys
from palpate import vtkContactDeflection, vtkContactTool, vtkToolContactProbe, vtkToolContactResponse
import vtkmodules.all as vtk

def make(vtk_class, *inputs, **properties):
    made = vtk_class()
    for port, algorithm in enumerate(inputs):
        made.SetInputConnection(port, algorithm.GetOutputPort())
    for name, value in properties.items():
        getattr(made, "Set" + name)(value)
    return made

ball = make(vtk.vtkSphereSource, Radius=50, ThetaResolution=300, PhiResolution=300)         # mm
response = make(vtkToolContactResponse, ball, Tool=make(vtkContactTool, Specification="cone:60"))
tip = make(vtk.vtkPointSource, Radius=0, NumberOfPoints=1, Center=(33.2, 0, 33.2))          # 3 mm deep
probe = make(vtkToolContactProbe, response, tip)
warp = make(vtk.vtkWarpVector, make(vtkContactDeflection, response, probe))
warp.SetInputArrayToProcess(0, 0, 0, 0, "ContactDisplacement")
mapper = make(vtk.vtkPolyDataMapper, make(vtk.vtkPolyDataNormals, warp), ScalarVisibility=0)
window, renderer = make(vtk.vtkRenderWindow, OffScreenRendering=1, Size=(600, 600)), vtk.vtkRenderer()
window.AddRenderer(renderer)
renderer.AddActor(make(vtk.vtkActor, Mapper=mapper))
window.Render()
image = make(vtk.vtkWindowToImageFilter, Input=window)
make(vtk.vtkPNGWriter, image, FileName=(sys.argv + ["dent.png"])[1]).Write()
print("%.3f mm deep" % probe.GetOutput().GetPointData().GetArray("Deflection").GetValue(0))
