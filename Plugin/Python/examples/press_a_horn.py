# SPDX-License-Identifier: BSD-3-Clause
"""A body of true shape with two horns: prints a sphere's force on its back and at the root and tip of a horn; draws it.

    ./run python Plugin/Python/examples/press_a_horn.py [OUTPUT.png]    (default: horn.png)
"""
import sys
import numpy
import palpate
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

YOUNG, POISSON, DEPTH, TOOL = 0.1, 0.45, 1.5, "sphere:3"    # MPa and - as in vtkElasticContactResponse; mm


def horned_surface():
    """Returns the surface of a ball of 25 mm radius with a flat bottom and two horns."""
    axis = numpy.arange(-30, 50, 1.25)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    inside = [25 - numpy.sqrt(x**2 + y**2 + z**2)]
    for t in numpy.linspace(0, 1, 30):                      # balls along a curve, smaller towards its end
        away = numpy.sqrt((abs(x) - 12 - 12 * t)**2 + (y - 4 + 10 * t)**2 + (z - 18 - 18 * t**0.7)**2)
        inside.append(7 - 3.5 * t - away)
    inside = numpy.minimum(numpy.log(numpy.exp(inside).sum(axis=0)), z + 15.3)
    image = vtk.vtkImageData()
    image.SetDimensions(3 * (len(axis),))
    image.SetSpacing(1.25, 1.25, 1.25)
    image.SetOrigin(3 * (axis[0],))
    image.GetPointData().SetScalars(numpy_to_vtk(inside.ravel(), deep=True))
    surface, smooth = vtk.vtkFlyingEdges3D(), vtk.vtkWindowedSincPolyDataFilter()
    surface.SetInputData(image)
    smooth.SetInputConnection(surface.GetOutputPort())
    smooth.SetPassBand(0.05)
    return smooth


scan = horned_surface()
solid = palpate.vtkGradedBody()                             # tetrahedra, fine where the surface is curved
solid.SetInputConnection(scan.GetOutputPort())
solid.SetSurfaceSpacing(3)
tool = palpate.vtkContactTool()
tool.SetSpecification(TOOL)
felt = palpate.vtkElasticContactResponse()                  # sources 3 mm apart, responses at the scan's points
felt.SetInputConnection(solid.GetOutputPort())
felt.SetSurfaceConnection(scan.GetOutputPort())
felt.SetTool(tool)
felt.SetMaximumDeflection(DEPTH)
felt.SetSourceSpacing(3)
felt.AddObserver("WarningEvent", lambda *_: None)           # points that are held have no response
felt.Update()
body, plain = felt.GetOutput(), palpate.response(scan, TOOL, YOUNG, POISSON, maximum_deflection=DEPTH)
points = [body.FindPoint(place) for place in ((0, 25, 0), (-18, 0, 34), (-28, -6, 36))]
normals = numpy.array([body.GetPointData().GetArray("ResponseNormal").GetTuple(point) for point in points])
tips = [body.GetPoint(point) for point in points] - 0.99 * DEPTH * normals
felt_there, plain_there = palpate.probe(body, tips).forces, palpate.probe(plain, tips).forces
for name, forces in zip(("back", "root", "tip"), zip(felt_there, plain_there)):
    print("%-4s  %.3f N; curved alike, but a half-space: %.3f N" % (name, *numpy.linalg.norm(forces, axis=1)))
probe, one = palpate.vtkToolContactProbe(), vtk.vtkPointSource()
one.SetRadius(0)
one.SetCenter(tips[2])
probe.SetInputData(0, body)
probe.SetTipConnection(one.GetOutputPort())
probe.Update()
scene, renderer, window = palpate.vtkContactScene(), vtk.vtkRenderer(), vtk.vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(1000, 760)
window.AddRenderer(renderer)
scene.SetRenderer(renderer)                                 # body with its dent, tool, force, legends
scene.SetBody(body)
scene.SetTool(tool)
scene.SetLargestDeflection(DEPTH)
scene.SetLargestForce(0.2)                                  # N
scene.ShowTip(probe.GetOutput(), 0)
renderer.GetActiveCamera().SetPosition(60, -150, 50)
renderer.GetActiveCamera().SetViewUp(0, 0, 1)
renderer.ResetCamera()
image, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
image.SetInput(window)
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "horn.png")
writer.Write()
