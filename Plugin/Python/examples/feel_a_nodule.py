# SPDX-License-Identifier: BSD-3-Clause
"""A hard ball under the skin of a block: by how much three tools feel it, above it and beside it.

    ./run python Plugin/Python/examples/feel_a_nodule.py
"""
import numpy
import palpate
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendFilter

YOUNG, RATIO, POISSON = 1.0, 10.0, 0.45                     # MPa, of the ball over that, -
SIZE, HEIGHT, CELL = 20, 18, 1.0                            # mm, bonded below
RADIUS, TOP = 3.0, 2.0                                      # mm: the ball, and how deep it begins


def share_of_ball(corners):
    """How much of each cell the ball fills, from 6 x 6 x 6 points in it."""
    inside = numpy.zeros(len(corners))
    steps = (numpy.arange(6) + 0.5) * CELL / 6
    for step in numpy.stack(numpy.meshgrid(steps, steps, steps), -1).reshape(-1, 3):
        inside += numpy.linalg.norm(corners + step - (0, 0, HEIGHT - TOP - RADIUS), axis=1) < RADIUS
    return inside / len(steps) ** 3


def block():
    """Voxels with their moduli: of a cell that the harder ball fills in part the harmonic mean."""
    n, m = int(SIZE / CELL), int(HEIGHT / CELL)
    image = vtkImageData()
    image.SetDimensions(n + 1, n + 1, m + 1)
    image.SetSpacing(CELL, CELL, CELL)
    image.SetOrigin(-SIZE / 2, -SIZE / 2, 0)
    cells = vtkAppendFilter()
    cells.AddInputData(image)
    cells.Update()
    k, j, i = numpy.indices((m, n, n)).reshape(3, -1)       # the order of an image's cells
    filled = share_of_ball(numpy.stack([i, j, k], 1) * CELL - (SIZE / 2, SIZE / 2, 0))
    mixed = numpy_to_vtk(YOUNG / (1 - filled + filled / RATIO), deep=True)
    mixed.SetName("E")
    cells.GetOutput().GetCellData().AddArray(mixed)
    held = numpy.zeros((m + 1, n + 1, n + 1), numpy.uint8)
    held[0] = 7
    fixed = numpy_to_vtk(held.ravel(), deep=True)
    fixed.SetName("Fixed")
    cells.GetOutput().GetPointData().AddArray(fixed)
    return cells.GetOutput()


def response(body, moduli, tools):
    felt = palpate.vtkElasticContactResponse()              # solves once for all tools
    felt.SetInputData(body)
    felt.SetInputArrayToProcess(0, 0, 0, 1, moduli)         # "" is the constant
    felt.SetYoungsModulus(YOUNG)
    felt.SetPoissonRatio(POISSON)
    felt.SetMaximumDeflection(0.4)
    felt.SetLargestContactRadius(2.5)
    felt.AddObserver("WarningEvent", lambda *_: None)       # what is held has no response
    for name in tools:
        tool = palpate.vtkContactTool()
        tool.SetSpecification(name)
        felt.SetTool(tool)
        felt.Update()
        yield felt.GetOutput()


TOOLS = ("flat:1.6", "sphere:1.6", "sphere:6.35")
body = block()
forces = {}
for moduli in ("", "E"):
    for name, surface in zip(TOOLS, response(body, moduli, TOOLS)):
        for x in (0, 3, 6):
            point = surface.FindPoint((x, 0, HEIGHT))
            forces[moduli, name, x] = surface.GetPointData().GetArray("ResponseForce").GetTuple(point)[-1]
for name in TOOLS:
    print(name, *("%+.0f %% at %d mm" % (100 * (forces["E", name, x] / forces["", name, x] - 1), x) for x in (0, 3, 6)))
