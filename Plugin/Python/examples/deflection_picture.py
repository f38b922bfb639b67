# SPDX-License-Identifier: BSD-3-Clause
"""Draws a ball that is dented by a cone, off screen; prints the deflection. Needs a display, which ./run provides.

    ./run python Plugin/Python/examples/deflection_picture.py [OUTPUT.png]    (default: dent.png)
"""
import sys
import palpate
import vtkmodules.all as vtk

ball = vtk.vtkSphereSource()
ball.SetRadius(50)                                          # mm
ball.SetThetaResolution(300)
ball.SetPhiResolution(300)
body = palpate.response(ball, tool="cone:60", compliance=None)

tip = vtk.vtkPointSource()
tip.SetNumberOfPoints(1)
tip.SetRadius(0)
tip.SetCenter(33.2, 0, 33.2)                                # 3 mm deep
probe = palpate.vtkToolContactProbe()
probe.SetInputData(0, body)
probe.SetTipConnection(tip.GetOutputPort())

dent = palpate.vtkContactDeflection()                       # displacement of every point of the body
dent.SetInputData(0, body)
dent.SetTipConnection(probe.GetOutputPort())
warp = vtk.vtkWarpVector()
warp.SetInputConnection(dent.GetOutputPort())
warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "ContactDisplacement")
normals = vtk.vtkPolyDataNormals()
normals.SetInputConnection(warp.GetOutputPort())

mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(normals.GetOutputPort())
mapper.ScalarVisibilityOff()
actor = vtk.vtkActor()
actor.SetMapper(mapper)
renderer = vtk.vtkRenderer()
renderer.AddActor(actor)
window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(600, 600)
window.AddRenderer(renderer)
window.Render()

image = vtk.vtkWindowToImageFilter()
image.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "dent.png")
writer.Write()
print("%.3f mm deep" % probe.GetOutput().GetPointData().GetArray("Deflection").GetValue(0))
