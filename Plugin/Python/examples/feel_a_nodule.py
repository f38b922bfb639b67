# SPDX-License-Identifier: BSD-3-Clause
"""A hard ball under the skin of a block: prints the change of the force of three tools above the ball and next to it.

    ./run python Plugin/Python/examples/feel_a_nodule.py
"""
import numpy
import palpate
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendFilter

YOUNG, RATIO, POISSON = 1.0, 10.0, 0.45                     # MPa, block; ratio ball to block; Poisson's ratio
SIZE, HEIGHT, CELL = 20, 18, 1.0                            # mm, bonded at the bottom
RADIUS, TOP = 3.0, 2.0                                      # radius of the ball, depth of its top, mm
TOOLS = ("flat:1.6", "sphere:1.6", "sphere:6.35")


def block():
    """Returns voxels whose lowest points are held."""
    n, m = int(SIZE / CELL), int(HEIGHT / CELL)
    image = vtkImageData()
    image.SetDimensions(n + 1, n + 1, m + 1)
    image.SetSpacing(CELL, CELL, CELL)
    image.SetOrigin(-SIZE / 2, -SIZE / 2, 0)
    cells = vtkAppendFilter()
    cells.AddInputData(image)
    cells.Update()
    held = numpy.zeros((m + 1, n + 1, n + 1), numpy.uint8)
    held[0] = 7
    fixed = numpy_to_vtk(held.ravel(), deep=True)
    fixed.SetName("Fixed")
    cells.GetOutput().GetPointData().AddArray(fixed)
    return cells.GetOutput()


material = palpate.vtkNoduleMaterial()                      # E and Poisson's ratio per cell
material.SetInputData(block())
material.SetYoungsModulus(YOUNG)
material.SetPoissonRatio(POISSON)
material.AddNodule(0, 0, HEIGHT - TOP - RADIUS, RADIUS, RATIO * YOUNG)
felt = palpate.vtkNoduleDetectability()                     # with and without the ball, solved once for all tools
felt.SetInputConnection(material.GetOutputPort())
first = palpate.vtkContactTool()
first.SetSpecification(TOOLS[0])
felt.SetTool(first)
for tool in TOOLS[1:]:
    felt.AddMoreTool(tool)
felt.SetMaximumDeflection(0.4)
felt.AddObserver("WarningEvent", lambda *_: None)           # points that are held have no response
felt.Update()
surface = felt.GetOutput()
change = surface.GetPointData().GetArray("ForceChange")     # largest relative change of each tool's force
for number, tool in enumerate(TOOLS):
    print(tool, *("%+.0f %% at %d mm" % (100 * change.GetComponent(surface.FindPoint((x, 0, HEIGHT)), number), x)
                  for x in (0, 3, 6)))
strongest = surface.GetPointData().GetArray("StrongestTool").GetValue(surface.FindPoint((0, 0, HEIGHT)))
print("feels most of it:", TOOLS[strongest])
