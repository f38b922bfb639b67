# SPDX-License-Identifier: BSD-3-Clause
"""Computes the share of a body whose error is within 5 % if direct contact is used where contacts of true shape do not
suffice. vtkDirectContactResponse presses a tool at random points of that part, weighted by area."""
import csv
import sys
import time

import numpy as np
import palpate
from vtkmodules.util.numpy_support import numpy_to_vtk

import true_shape
from cover import areas
from direct import smooth

COLUMNS = ("body", "tool", "share_by_law", "pressed", "share_of_these", "failed", "share_by_both", "standard_error", "seconds_each")
CAN_BE = (0, 3, 5)  # values of Status of points that can be pressed: valid, folded, edge


def fine(body, times):
    """Returns the body, smoothly refined if VTK can refine it."""
    try:
        return smooth(body, times)
    except ValueError as fault:
        print("The body {}: it is pressed on its facets.".format(fault), file=sys.stderr, flush=True)
        return body


def drawn(made, tool, count, random, depth=1.0, tolerance=0.05):
    """Returns random points of the part that is not covered, weighted by area; the share of the area that is covered; and the
    share that is not covered but can be pressed."""
    status, error = true_shape.array(made, tool, "Status"), true_shape.array(made, tool, "Error")[:, -1]
    free = np.where(status != true_shape.HELD, areas(made), 0.0)
    covered = (status == 0) & (true_shape.array(made, tool, "Range") > 0.999 * depth) & (error <= tolerance)
    left = np.where(covered, 0.0, free)
    can_be = np.flatnonzero((left > 0) & np.isin(status, CAN_BE))
    found = random.choice(can_be, min(count, len(can_be)), replace=False, p=left[can_be] / left[can_be].sum())
    return found, free[covered].sum() / free.sum(), left[can_be].sum() / free.sum()


def judge(name, body, fixed, count, times, seed=7, depth=1.0, tolerance=0.05):
    """Yields rows of COLUMNS."""
    made = true_shape.press(body, fixed)
    side = true_shape.sides(body)[1]
    solids = [true_shape.solid(body, fixed, longer * side).GetOutput() for longer in (1, true_shape.COARSER)]
    shape = fine(body, times)
    random = np.random.default_rng(seed)
    for tool in true_shape.TOOLS:
        points, share, left = drawn(made, tool, count, random)
        mask = np.zeros(made.GetNumberOfPoints(), np.uint8)
        mask[points] = 1
        pressed = numpy_to_vtk(mask, deep=True)
        pressed.SetName("Pressed")
        made.GetPointData().AddArray(pressed)
        direct = palpate.vtkDirectContactResponse()
        direct.SetInputData(made)
        direct.SetBodyData(solids[0])
        direct.SetCoarserData(solids[1])
        direct.SetShapeData(shape)
        direct.SetTool(true_shape.contact_tool(tool))
        direct.SetYoungsModulus(0.05)
        direct.SetPoissonRatio(0.45)
        direct.SetMaximumDeflection(depth)
        direct.SetFixedFaces(fixed)
        direct.SetResponseName(tool)
        direct.SetStrainModel(direct.NeoHooke)
        start = time.monotonic()
        direct.Update()
        each = (time.monotonic() - start) / len(points)
        found = direct.GetOutput()
        became = true_shape.array(found, tool, "Direct")[points]
        within = float((true_shape.array(found, tool, "Error")[points, -1] <= tolerance).mean())
        spread = left * np.sqrt(within * (1.0 - within) / len(points))
        yield (name, tool, "{:.3f}".format(share), len(points), "{:.3f}".format(within), int((became == 3).sum()),
               "{:.3f}".format(share + left * within), "{:.3f}".format(spread), "{:.1f}".format(each))


def write(bodies, fixed, count, times, output):
    """Writes pressed.csv."""
    with open(output / "pressed.csv", "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        for name, body in bodies:
            try:
                for row in judge(name, body, fixed, count, times):
                    table.writerow(row)
                    file.flush()
                    print(*row, flush=True)
            except ValueError as fault:
                print("{} {}.".format(name, fault), file=sys.stderr, flush=True)
