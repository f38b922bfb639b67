# SPDX-License-Identifier: BSD-3-Clause
"""The bodies of the study of shape (an edge, a horn and a nodule), with the forces of other codes on them.

Lengths are in mm, forces in N, moduli in MPa. At the place of the press, z points out of the body.
"""
import csv
import math
import pathlib

import numpy as np
from palpate import vtkContactTool, vtkGradedBody, vtkNoduleMaterial
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

REFERENCE = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Reference" / "shape"
YOUNG, POISSON = 1.0, 0.45          # of all three bodies, as in the tables
EDGE_DISTANCE = 3.0
BALL = 10.0
NODULE = 3.0
TOPS = (1.0, 2.0, 3.0, 5.0)
RATIOS = (10.0, 0.2)


class Body:
    """A body with two meshes, pressed at one place, and the forces of the table."""

    def __init__(self, name, fine, coarse, place, cases):
        self.name = name
        self.meshes = {"fine": fine, "coarse": coarse}
        self.place = np.array(place)                        # a mesh is pressed at its nearest point
        self.cases = cases                                  # (tool, case, depth, force)

    def tools(self):
        return list(dict.fromkeys(each[0] for each in self.cases))

    def at(self, tool):
        return [each for each in self.cases if each[0] == tool]


def table(name):
    with open(REFERENCE / name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def specification(name):
    """Converts the name of a tool in the table to a specification: flat1.5 to flat:1.5."""
    return name.replace("flat", "flat:").replace("sphere", "sphere:")


def tool(text):
    made = vtkContactTool()
    made.SetSpecification(text)
    return made


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def mark(mesh, name, values):
    array = numpy_to_vtk(np.asarray(values, np.uint8), deep=True)
    array.SetName(name)
    mesh.GetPointData().RemoveArray(name)
    mesh.GetPointData().AddArray(array)


def press_at(mesh, place, reach):
    """Marks the points that get a response: those within `reach` of the place, which the tips can touch."""
    mark(mesh, "Pressed", np.linalg.norm(points_of(mesh) - np.array(place), axis=1) < reach)


def outwards(cell, fine, ratio, end):
    """Coordinates from 0 to `end`: cells of one size up to `fine`, then growing. The last cell fills the rest."""
    found = [0.0]
    step = cell
    while found[-1] < end - 1e-9:
        step *= ratio if found[-1] >= fine - 1e-9 else 1.0
        after = found[-1] + step
        found.append(end if after > end - 0.5 * step else after)
    return np.array(found)


def both_ways(half):
    return np.concatenate([-half[:0:-1], half])


def hexahedra(x, y, z):
    box = vtkRectilinearGrid()
    box.SetDimensions(len(x), len(y), len(z))
    for set_line, line in ((box.SetXCoordinates, x), (box.SetYCoordinates, y), (box.SetZCoordinates, z)):
        set_line(numpy_to_vtk(np.ascontiguousarray(line), deep=True))
    cells = vtkAppendFilter()
    cells.AddInputData(box)
    cells.Update()
    return cells.GetOutput()


def edge_block(cell):
    """A block of 60 × 60 × 30 mm, held at the bottom; the edge is x = 0, the top z = 0."""
    mesh = hexahedra(outwards(cell, 2 * EDGE_DISTANCE, 1.25, 60.0), both_ways(outwards(cell, 3.75, 1.25, 30.0)),
                     -outwards(cell, EDGE_DISTANCE, 1.25, 30.0)[::-1])
    mark(mesh, "Fixed", np.where(points_of(mesh)[:, 2] < -30.0 + 1e-3, 7, 0))
    press_at(mesh, (EDGE_DISTANCE, 0.0, 0.0), EDGE_DISTANCE + 0.1)
    return mesh


def edge(fine=0.75, coarse=1.5):
    cases = [(specification(row["tool"]), "a/e=" + row["a/e"], float(row["delta"]), float(row["full 2-D: F"]))
             for row in table("edge_axisymmetric_vs_full.csv")]
    return Body("edge", fine and edge_block(fine), edge_block(coarse), (EDGE_DISTANCE, 0.0, 0.0), cases)


def half_ball_surface(rings=60):
    """The surface of half a ball on its flat side, with triangles of 1.5 degrees."""
    outline = [(BALL * math.sin(angle), BALL * math.cos(angle)) for angle in np.arange(rings) * 0.5 * math.pi / rings]
    outline += [(0.1 * BALL * i, 0.0) for i in range(10, -1, -1)]
    sides = 3 * rings
    points, cells, circles = vtkPoints(), vtkCellArray(), []
    points.SetDataType(VTK_DOUBLE)
    for r, z in outline:
        circles.append([points.InsertNextPoint(r * math.cos(angle), r * math.sin(angle), z)
                        for angle in np.arange(sides if r > 0 else 1) * 2 * math.pi / sides])
    for above, below in zip(circles, circles[1:]):
        for i in range(sides):
            one, other = i % len(above), (i + 1) % len(above)
            left, right = i % len(below), (i + 1) % len(below)
            if len(below) > 1:
                cells.InsertNextCell(3, (below[left], below[right], above[one]))
            if len(above) > 1:
                cells.InsertNextCell(3, (above[other], above[one], below[right]))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def half_ball(spacing):
    """Half a ball on a base without friction: the base holds all its points along z, and two points along x and y."""
    filled = vtkGradedBody()
    filled.SetInputData(half_ball_surface())
    filled.SetSurfaceSpacing(spacing)
    filled.SetFixedFaces("")
    filled.Update()
    mesh = filled.GetOutput()
    fixed = np.where(points_of(mesh)[:, 2] < 1e-9, 4, 0)
    fixed[mesh.FindPoint(0, 0, 0)] = 7
    fixed[mesh.FindPoint(BALL, 0, 0)] = 6
    mark(mesh, "Fixed", fixed)
    press_at(mesh, (0.0, 0.0, BALL), 4.0)
    return mesh


def horn(fine=2.0, coarse=4.0):
    cases = [(specification(row["tool"]), "a/R=" + row["a/R"], float(row["delta"]), float(row["F exact H (E=1)"]))
             for row in table("hemisphere.csv") if float(row["nu"]) == POISSON and float(row["a/R"]) <= 0.3]
    return Body("horn", half_ball(fine), half_ball(coarse), (0.0, 0.0, BALL), cases)


def on_true_surface(body, text):
    """Returns the tool for the true surface of a body. In the table, the gap under the tool is that of a sphere plus
    r²/2R of the ball. The half-space law adds r²/2R itself. The true surface of the ball is a circle, so that the
    difference is added to the profile of the tool."""
    if body != "horn":
        return text
    radius = float(text.split(":")[1])

    def drop(r, of):
        return of - math.sqrt(of * of - r * r)
    return "profile:" + ";".join("{:.12g},{:.12g}".format(r, drop(r, radius) - drop(r, BALL) + 0.5 * r * r / BALL)
                                 for r in np.linspace(0.0, 0.95 * radius, 401))


def nodule_block(cell, top, ratio):
    """A block of 106 × 106 × 40 mm, as large as the table's cylinder of radius 60 and height 40. It is held at the bottom
    and at its sides; the sides change the force by less than 0.1 %."""
    half = outwards(cell, 4.0, 1.6, 53.0)
    mesh = hexahedra(both_ways(half), both_ways(half), -outwards(cell, top + 2 * NODULE, 1.6, 40.0)[::-1])
    points = points_of(mesh)
    held = (np.abs(points[:, :2]).max(1) > 53.0 - 1e-3) | (points[:, 2] < -40.0 + 1e-3)
    mark(mesh, "Fixed", np.where(held, 7, 0))
    press_at(mesh, (0.0, 0.0, 0.0), 1.5 * cell)
    material = vtkNoduleMaterial()
    material.SetInputData(mesh)
    material.SetYoungsModulus(YOUNG)
    material.SetPoissonRatio(POISSON)
    material.AddNodule(0, 0, -top - NODULE, NODULE, ratio * YOUNG)
    material.Update()
    return material.GetOutput()


def nodule(top, ratio, fine=1.0, coarse=2.0):
    case = "d={:g}, E x{:g}".format(top, ratio)
    cases = [(specification(row["tool"]), case, float(row["delta"]), float(row["F_nodule"]))
             for row in table("nodule_forces.csv")
             if (float(row["R_nodule"]), float(row["top_depth"]), float(row["E_ratio"])) == (NODULE, top, ratio)]
    return Body("nodule", nodule_block(fine, top, ratio), nodule_block(coarse, top, ratio), (0.0, 0.0, 0.0), cases)


def bodies(quick):
    """Yields the bodies one by one, because each takes much memory; a text with the reason in place of a missing body."""
    yield edge()
    yield horn() if vtkGradedBody.IsAvailable() else "no horn: vtkGradedBody was built without CGAL"
    for ratio in RATIOS[:1] if quick else RATIOS:
        for top in TOPS[1:2] if quick else TOPS:
            yield nodule(top, ratio)
