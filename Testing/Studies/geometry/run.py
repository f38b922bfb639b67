#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Difficult geometry: the force on a tip in a thin slab, in a groove, at an edge, a cone's tip, a saddle and a border.

    run.py --output DIR        (./run study geometry)

A 5 mm sphere on E* = 0.1 MPa moves along a path in the plane of each picture, 0.02 mm per tick, by
vtkToolContactProbe, with the default force form and surface. Writes to DIR for each case CASE.csv
(a row per tick) and CASE.png, all pictures in geometry.png, and the numbers of the tests in summary.csv.
"""
import argparse
import csv
import pathlib
import sys

import numpy as np
from palpate import vtkContactTool, vtkToolContactProbe, vtkToolContactResponse
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import bodies

MODULUS, RADIUS = 0.1, 5.0  # MPa, mm
POISSON = 0.5
NONE, SLIDE, BEYOND_RANGE, LOST = 0, 2, 3, 4


def poly(points, cells, lines=False):
    data, places, array = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    data.SetPoints(places)
    for cell in cells:
        array.InsertNextCell(len(cell))
        for i in cell:
            array.InsertCellPoint(int(i))
    data.SetLines(array) if lines else data.SetPolys(array)
    return data


def sphere():
    tool = vtkContactTool()
    tool.SetShapeToSphere()
    tool.SetRadius(RADIUS)
    return tool


def law(depth):
    return sphere().GetForce(depth, MODULUS)


class Felt:
    """The probe's arrays along the path of a case, in the plane of the picture."""

    def __init__(self, case):
        response = vtkToolContactResponse()
        response.SetInputData(poly(case.points, case.triangles))
        response.SetTool(sphere())
        response.SetYoungsModulus(MODULUS * (1 - POISSON**2))
        response.SetPoissonRatio(POISSON)
        response.SetMaximumDeflection(4.0)
        response.CurvatureCorrectionOff()  # the reference is the law of a flat surface
        response.SetErrorTolerance(0)
        tips = case.place(*case.path.T)
        probe = vtkToolContactProbe()
        probe.SetInputConnection(0, response.GetOutputPort())
        probe.SetInputData(1, poly(tips, [range(len(tips))], lines=True))
        probe.Update()
        arrays = probe.GetOutput().GetPointData()
        self.case, self.tips = case, tips
        for name in ("Force", "NormalForce", "Deflection", "ContactPoint", "ContactState", "Normal"):
            setattr(self, name, vtk_to_numpy(arrays.GetArray(name)).copy())
        self.inside = self.Deflection > 0
        self.way = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(tips, axis=0), axis=1))])

    def rows(self):
        for i in range(len(self.tips)):
            yield [f"{v:.6g}" for v in (*self.tips[i], *self.ContactPoint[i], self.Deflection[i], *self.Force[i])] + [
                int(self.ContactState[i])]


def slab_numbers(felt):
    inside = felt.inside
    yield "force_up_share_of_ticks", np.mean(felt.Force[inside, 1] > 0), 1.0
    deepest = felt.Deflection.max()
    yield "deepest_mm", deepest, 2.4
    yield "force_at_deepest_N", felt.NormalForce.max(), law(deepest)


def groove_numbers(felt):
    bottom = felt.inside & (np.hypot(felt.ContactPoint[:, 0], felt.ContactPoint[:, 1]) < 1e-6)
    yield "bottom_direction_y", felt.Normal[bottom, 1].min(), 1.0
    for side in (-1, 1):
        # At a distance of more than one facet from the bottom line the normal is that of the wall.
        wall = felt.inside & (side * felt.ContactPoint[:, 0] > 1.0)
        yield f"wall_{'left' if side < 0 else 'right'}_direction_x", felt.Normal[wall, 0].mean(), -side * 0.5**0.5
    yield "greatest_force_step_N", np.abs(np.diff(felt.NormalForce)).max(), None


def edge_numbers(felt):
    onside = felt.inside & (felt.ContactPoint[:, 0] < 1e-9) & (felt.ContactPoint[:, 1] < -1e-6)
    yield "changes_sides_at_x_mm", felt.tips[np.argmax(onside), 0], None
    yield "force_before_N", felt.NormalForce[np.argmax(onside) - 1], law(1.5)
    yield "force_after_N", felt.NormalForce[np.argmax(onside)], law(felt.tips[np.argmax(onside), 0])


def cone_numbers(felt):
    deep = felt.inside & (felt.tips[:, 1] < -2.399) & (felt.tips[:, 0] < -0.02)
    depth = (np.abs(felt.tips[deep, 1]) * np.tan(np.pi / 6) - np.abs(felt.tips[deep, 0])) * np.cos(np.pi / 6)
    yield "depth_error_mm", np.abs(felt.Deflection[deep] - depth).max(), 0.0
    crossing = np.argmax(felt.tips[:, 0] > 1e-9)
    yield "sideways_before_axis_N", felt.Force[crossing - 2, 0], None
    yield "sideways_after_axis_N", felt.Force[crossing + 2, 0], None


def saddle_numbers(felt):
    yield "depth_least_mm", felt.Deflection.min(), 1.0
    yield "depth_greatest_mm", felt.Deflection.max(), 1.0
    radial = -felt.tips[:, :2] / np.linalg.norm(felt.tips[:, :2], axis=1)[:, None]
    yield "direction_error_rad", np.arccos(np.clip((radial * felt.Normal[:, :2]).sum(1), -1, 1)).max(), 0.0


def border_numbers(felt):
    beyond = felt.tips[:, 0] > 4 - 1e-9
    yield "force_at_border_N", felt.NormalForce[~beyond][-1], law(1.0)
    yield "lost_share_of_ticks_beyond", np.mean(felt.ContactState[beyond] == LOST), 1.0
    yield "greatest_force_step_N", np.abs(np.diff(felt.NormalForce)).max(), None
    left = felt.NormalForce > 0
    yield "felt_to_x_mm", felt.tips[left, 0].max(), None
    yield "greatest_pull_back_N", np.abs(felt.Force[:, 0]).max(), 0.0


NUMBERS = {"slab": slab_numbers, "groove": groove_numbers, "edge": edge_numbers, "cone": cone_numbers,
           "saddle": saddle_numbers, "border": border_numbers}


def draw(axes, felt, scale):
    """Draws the section of the body, the path, and at some of the ticks a line to the contact point and the force."""
    case = felt.case
    line = np.vstack([case.outline, case.outline[:1]]) if case.name not in ("border", "cone") else case.outline
    if case.name != "border":
        axes.fill(*line.T, color="0.90", zorder=0)
    axes.plot(*line.T, color="0.35", lw=1.2, zorder=1)
    axes.plot(*felt.tips[:, :2].T, color="#0072B2", lw=1.0, zorder=2)
    some = np.arange(0, len(felt.tips), max(1, len(felt.tips) // 36))
    held = some[felt.inside[some]]
    for i in held:
        axes.plot([felt.tips[i, 0], felt.ContactPoint[i, 0]], [felt.tips[i, 1], felt.ContactPoint[i, 1]],
                  color="0.6", lw=0.6, zorder=1)
    axes.plot(*felt.ContactPoint[held, :2].T, ".", color="#009E73", ms=4, zorder=3)
    lost = some[felt.ContactState[some] == LOST]
    axes.plot(*felt.tips[lost, :2].T, "x", color="0.4", ms=4, zorder=3)
    if len(lost) > 0:
        x, y = felt.tips[lost[len(lost) // 2], :2]
        axes.text(x, y - 0.4, "contact lost", fontsize=7, color="0.4", ha="center")
    arrows = axes.quiver(*felt.tips[some, :2].T, *felt.Force[some, :2].T, color="#D55E00", angles="xy",
                         scale_units="xy", scale=scale, width=0.004, zorder=4)
    axes.quiverkey(arrows, 0.32, 1.05, key_force(felt), f"{key_force(felt):g} N", labelpos="E",
                   fontproperties={"size": 8})
    axes.set_aspect("equal")
    shown = np.vstack([felt.tips[:, :2], felt.ContactPoint[felt.inside, :2],
                       felt.tips[:, :2] + felt.Force[:, :2] / scale])
    low, high = shown.min(0) - 0.6, shown.max(0) + 0.6
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_title(case.title, fontsize=9, loc="left", pad=16)
    axes.set_xlabel("mm", fontsize=8)
    axes.tick_params(labelsize=7)


def key_force(felt):
    return float(f"{felt.NormalForce.max():.0e}")


def draw_force(axes, felt):
    axes.plot(felt.way, felt.Force[:, 0], color="#0072B2", label="sideways")
    axes.plot(felt.way, felt.Force[:, 1], color="#D55E00", ls="--", label="up")
    axes.plot(felt.way, felt.NormalForce, color="0.5", lw=0.8, ls=":", label="size")
    axes.set_xlabel("way of the tip, mm")
    axes.set_ylabel("force, N")
    axes.legend(fontsize=8, frameon=False)
    axes.spines[["top", "right"]].set_visible(False)


def pictures(felts, output):
    try:
        import matplotlib
    except ImportError:
        print("no matplotlib: no pictures", file=sys.stderr)
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    scales = {felt.case.name: felt.NormalForce.max() / 1.6 for felt in felts}  # the longest arrow is 1.6 mm
    for felt in felts:
        figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
        draw(left, felt, scales[felt.case.name])
        draw_force(right, felt)
        figure.suptitle(felt.case.says, fontsize=9)
        figure.savefig(output / f"{felt.case.name}.png", dpi=110)
        pyplot.close(figure)
    figure, grid = pyplot.subplots(2, 3, figsize=(9, 5.6), layout="constrained")
    for axes, felt in zip(grid.flat, felts):
        draw(axes, felt, scales[felt.case.name])
    figure.suptitle("tip (blue), contact point (green), force on the tip (orange), contact lost (×)", fontsize=9)
    figure.savefig(output / "geometry.png", dpi=100)
    pyplot.close(figure)


def write(path, header, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header.split(","))
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    output = parser.parse_args().output
    output.mkdir(parents=True, exist_ok=True)
    felts = [Felt(make()) for make in bodies.CASES]
    summary = []
    for felt in felts:
        write(output / f"{felt.case.name}.csv", "tip_x_mm,tip_y_mm,tip_z_mm,contact_x_mm,contact_y_mm,contact_z_mm,"
              "deflection_mm,force_x_N,force_y_N,force_z_N,state", felt.rows())
        for what, found, expected in NUMBERS[felt.case.name](felt):
            summary.append([felt.case.name, what, f"{found:.6g}", "" if expected is None else f"{expected:.6g}"])
    write(output / "summary.csv", "case,what,found,expected", summary)
    for row in summary:
        print("{:8} {:32} {:>12} {:>12}".format(*row))
    pictures(felts, output)
    print(f"pictures and tables in {output}")


if __name__ == "__main__":
    main()
