# SPDX-License-Identifier: BSD-3-Clause
"""Two fingers on a bending strip and on a half-space: prints how each changes the other's force, and draws both.

    ./run python Plugin/Python/examples/grip.py [OUTPUT.png]    (default: grip.png)
"""
import sys
import numpy as np
import palpate
import vtkmodules.all as vtk

YOUNG, POISSON, DEPTH, FINGER = 1.0, 0.45, 0.5, 3.0         # MPa, -, mm, mm


def box(low, high):
    cube = vtk.vtkCubeSource()
    cube.SetBounds(-12, 12, -6, 6, low, high)               # mm
    return cube


def shown(source, colour, place=(0, 0, 0), opacity=1):
    actor, mapper = vtk.vtkActor(), vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.SetPosition(place)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


strip_box, triangles = box(-3, 3), vtk.vtkTriangleFilter()
triangles.SetInputConnection(strip_box.GetOutputPort())
solid, bending = palpate.vtkVoxelBody(), palpate.vtkElasticCompliance()
solid.SetInputConnection(triangles.GetOutputPort())
solid.SetSpacing(1.5)
solid.SetFixedFaces("x-")                                   # a strip held at one end
bending.SetInputConnection(solid.GetOutputPort())
bending.SetYoungsModulus(YOUNG)
bending.SetPoissonRatio(POISSON)
bending.SetNumberOfCouplingModes(8)                         # by bending, one finger moves the surface at the other
bending.Update()
finger = "sphere:%g" % FINGER                               # a single finger with this force bends the strip by 5 mm
strip = palpate.response(bending.GetOutput(), finger, YOUNG, POISSON, compliance="GlobalCompliance",
                         maximum_deflection=8, samples=32, coupling=True)
plane = np.array([[-12, -6, 0], [12, -6, 0], [12, 6, 0], [-12, 6, 0.0]]), np.array([[0, 1, 2], [0, 2, 3]])
half_space = palpate.response(plane, finger, YOUNG, POISSON, maximum_deflection=1, coupling=True)
cases = [("a pinch", strip, np.array([[0, 0, 3 - DEPTH], [0, 0, DEPTH - 3]]))] # above and below, half way along it
for apart in (20, 12, 8, 6):                                # mm
    cases.append(("%d mm apart" % apart, half_space, np.array([[x, 0, -DEPTH] for x in (-apart / 2, apart / 2)])))
window, ball, arrow = vtk.vtkRenderWindow(), vtk.vtkSphereSource(), vtk.vtkArrowSource()
window.SetOffScreenRendering(True)
window.SetSize(1000, 720)
ball.SetRadius(FINGER)
ball.SetPhiResolution(60)
ball.SetThetaResolution(60)
for name, body, tips in cases:
    ways = (("each by itself", palpate.probe(body, tips)), ("together", palpate.probe(body, tips, coupled=True)))
    alone, each = (felt.normal_force[0] for _, felt in ways)
    print("%s: each %.3f N, by itself %.3f N: %+.1f %%" % (name, each, alone, 100 * (each / alone - 1)))
    for column, (way, felt) in enumerate(ways if name in (cases[0][0], cases[-1][0]) else ()):
        renderer, row, title = vtk.vtkRenderer(), int(body is strip), vtk.vtkCornerAnnotation()
        window.AddRenderer(renderer)
        renderer.SetViewport(column / 2, row / 2, (column + 1) / 2, (row + 1) / 2)
        renderer.SetBackground(0.32, 0.34, 0.43)
        title.SetText(0, "%s, %s: %.2f N" % (name, way, felt.normal_force[0]))
        renderer.AddViewProp(title)
        renderer.AddActor(shown(strip_box if row else box(-12, 0), (1, 0.8, 0.7)))
        for tip, force, normal in zip(tips, felt.forces, felt.normal):
            renderer.AddActor(shown(ball, (0.7, 0.75, 0.85), tip + FINGER * normal, 0.6))
            renderer.AddActor(shown(arrow, (0.9, 0.3, 0.1), tip + 2 * FINGER * normal))
            renderer.GetActors().GetLastActor().SetScale(6 * np.linalg.norm(force)) # mm/N
            renderer.GetActors().GetLastActor().RotateY(-90 * normal[2]) # from x, its own direction, to the normal
        renderer.GetActiveCamera().SetPosition(25, -90, 45)
        renderer.GetActiveCamera().SetViewUp(0, 0, 1)
        renderer.GetActiveCamera().SetParallelProjection(True)
        renderer.GetActiveCamera().SetParallelScale(17)
image, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
image.SetInput(window)
writer.SetInputConnection(image.GetOutputPort())
writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else "grip.png")
writer.Write()
