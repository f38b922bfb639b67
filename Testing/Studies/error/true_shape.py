# SPDX-License-Identifier: BSD-3-Clause
"""Stated error of contacts of true shape: the share of the surface on which it is small, and its correctness. The body is a
closed surface filled with tetrahedra."""
import numpy as np
import palpate
from vtkmodules.util.numpy_support import vtk_to_numpy

from cover import areas, shares

TOOLS = ("sphere:6.35", "flat:1.6", "sphere:1.6")  # the widest first: the others reuse its solutions
HELD = 4  # the value of Status of points that are held
CELLS = 20000  # the value of palpate --solid, like SOURCES
SOURCES = 10000
SMALL = "Small"  # prefix of responses at small strain
COARSER = 2  # cell size of the second mesh over that of the first


def contact_tool(text):
    tool = palpate.vtkContactTool()
    tool.SetSpecification(text)
    return tool


def sides(body, cells=CELLS, depth=1.0):
    """Returns the mean length (mm) of the cells at the surface for a total number of cells, and the length that is used: not
    finer than the tools need."""
    radius = max(contact_tool(text).GetContactRadius(depth) for text in TOOLS)
    spacing = np.sqrt(8.7 * areas(body).sum() / cells)
    return spacing, max(spacing, 0.5 * radius) if cells == CELLS else spacing


def solid(body, fixed, side):
    """Returns the updated filter that fills the body. Raises ValueError if the body cannot be filled."""
    filled = palpate.vtkGradedBody()
    filled.SetInputData(body)
    filled.SetSurfaceSpacing(side)
    filled.SetFixedFaces(fixed)
    filled.Update()
    if filled.GetOutput().GetNumberOfCells() == 0:
        raise ValueError("cannot be filled with cells of {:.3g} mm".format(side))
    return filled


def press(body, fixed, cells=CELLS, depth=1.0, tolerance=0.05, poisson=0.45, coarser=COARSER,
          small=False):
    """Returns the surface with a response of each tool with Neo-Hooke; the tool is the name of the response. The body is held
    at `fixed`. `coarser` 0: without the second mesh, which is used only for the error. `small`: with another response at
    small strain, whose name is SMALL and the tool. Raises ValueError if the body cannot be filled or pressed; VTK then
    reports the reason."""
    area = areas(body).sum()
    tools = {text: contact_tool(text) for text in TOOLS}
    radius = max(tool.GetContactRadius(depth) for tool in tools.values())
    spacing, side = sides(body, cells, depth)
    pressed = palpate.vtkElasticContactResponse()
    for longer, connect in ((1, pressed.SetInputConnection), (coarser, pressed.SetCoarserConnection)):
        if longer:
            filled = solid(body, fixed, longer * side)  # keeps the filter; its port does not
            connect(filled.GetOutputPort())
    pressed.SetYoungsModulus(0.05)
    pressed.SetPoissonRatio(poisson)
    pressed.SetMaximumDeflection(depth)
    pressed.SetErrorTolerance(tolerance)
    pressed.SetStoreMotion(False)
    pressed.SetLargestContactRadius(1.42 * radius)
    pressed.SetSourceSpacing(max(0.5 * spacing, np.sqrt(area / SOURCES)))
    made = body
    for text, tool in tools.items():
        pressed.SetTool(tool)
        for name in (text, SMALL + text) if small else (text,):
            pressed.SetStrainModel(pressed.NeoHooke if name == text else pressed.SmallStrain)
            pressed.SetResponseName(name)
            pressed.SetSurfaceData(made)
            pressed.Update()
            if not pressed.GetOutput().GetPointData().HasArray(name + "Force"):
                raise ValueError("cannot be pressed by {}".format(text))
            felt = type(body)()
            felt.ShallowCopy(pressed.GetOutput())
            made = felt
    return made


def array(made, tool, name):
    return vtk_to_numpy(made.GetPointData().GetArray(tool + name))


def cover(made, tool, depth=1.0, tolerance=0.05):
    """Returns the share of the area in which the stated error at the depth is within the tolerance, and the shares of the rest
    by the largest part of the error at the depth where the error first exceeds the tolerance. The held area is excluded."""
    free = np.where(array(made, tool, "Status") != HELD, areas(made), 0.0)
    reached = array(made, tool, "Range") > 0.999 * depth  # excludes curves that end at a smaller depth
    share, rest = shares(made, tool, np.where(reached, free, 0.0), tolerance)
    part = free[reached].sum() / free.sum()
    return share * part, dict({name: value * part for name, value in rest.items()}, **{"ends before": float(1.0 - part)})


def surface_error(made, tool):
    """Returns the median of the relative error due to the shape between the surface's points. The stated error does not
    include it."""
    return float(np.nanmedian(array(made, tool, "SurfaceError")))


def beyond(made, finer, tool, depth=1.0):
    """Returns the share of points whose force differs from the force on finer cells by more than the stated error, the number
    of compared points, and the median difference.

    Errors that do not depend on the cells are not tested: the shape between a scan's points, and finite strain."""
    both = np.ones(made.GetNumberOfPoints(), bool)
    for one in (made, finer):
        both &= (array(one, tool, "Range") > 0.999 * depth) & (array(one, tool, "Status") == 0)
    force, better = array(made, tool, "Force")[both, -1], array(finer, tool, "Force")[both, -1]
    error = np.abs(force / better - 1.0)
    return float((error > array(made, tool, "Error")[both, -1]).mean()), int(both.sum()), float(np.median(error))
