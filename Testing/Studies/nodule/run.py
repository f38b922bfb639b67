#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Change of the force by a nodule under the skin, and the largest depth at which the nodule is detectable.

    ./run study nodule [--quick] [--output DIR]

The nodules are balls of 1.5, 3 and 5 mm radius, ten times and a fifth as hard as the material around them, with tops 1
to 5 mm under the skin of a block. vtkNoduleMaterial and vtkNoduleDetectability compute the largest change of the force of
three tools pressed over the middle. The change is compared with another code (axisymmetric finite elements that follow the
ball, Data/Reference/shape). Writes nodule.csv (a row per ball and tool), felt.csv (the largest depth at which a ball is
detectable), nodule.md and, with matplotlib, nodule.png to DIR (default build/studies/nodule).
"""
import argparse
import csv
import pathlib
import sys

import numpy as np
from palpate import vtkContactTool, vtkNoduleDetectability, vtkNoduleMaterial
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

REFERENCE = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Reference" / "shape"
TOOLS = ("flat:1.6", "sphere:1.6", "sphere:6.35")
PRESSED = {"flat:1.6": 0.3, "sphere:1.6": 0.8, "sphere:6.35": 1.2}  # mm: the largest depths of the table
RADII = (1.5, 3.0, 5.0)             # mm
RATIOS = (10.0, 0.2)                # E of the ball over that of the surrounding material
TOPS = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0)  # mm
THRESHOLD = 0.1
HALF_WIDTH, HEIGHT = 53.0, 40.0     # mm: comparable to the table's cylinder of 60 mm radius
COLUMNS = ("radius", "ratio", "top", "tool", "change", "change_table", "stiffness_change", "depth", "felt")
FELT_COLUMNS = ("radius", "ratio", "tool", "felt_to", "felt_to_table")


def line(fine, cell, end, ratio=1.6):
    """Returns coordinates from 0 to `end`: cells of one size up to `fine`, then growing."""
    found = list(np.arange(0.0, fine + 0.5 * cell, cell))
    step = cell
    while found[-1] < end - 1e-9:
        step *= ratio
        after = found[-1] + step
        found.append(end if after > end - 0.5 * ratio * step else after)
    return np.array(found)


def body(radius, top):
    """Returns a block that is held at the bottom and at its sides, fine around the ball, and pressed in the middle of its
    top, z = 0."""
    cell = min(0.75, radius / 3)
    half = line(radius + cell, cell, HALF_WIDTH)
    across = np.concatenate([-half[:0:-1], half])
    down = line(min(top + 2 * radius, 9.0), cell, HEIGHT)
    box = vtkRectilinearGrid()
    box.SetDimensions(len(across), len(across), len(down))
    box.SetXCoordinates(numpy_to_vtk(across, deep=True))
    box.SetYCoordinates(numpy_to_vtk(across, deep=True))
    box.SetZCoordinates(numpy_to_vtk(-down[::-1], deep=True))
    cells = vtkAppendFilter()
    cells.AddInputData(box)
    cells.Update()
    grid = cells.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    held = (np.abs(points[:, :2]).max(1) >= HALF_WIDTH - 1e-3) | (points[:, 2] <= -HEIGHT + 1e-3)
    pressed = np.linalg.norm(points, axis=1) < 1e-3
    for name, marked, value in (("Fixed", held, 7), ("Pressed", pressed, 1)):
        array = numpy_to_vtk(np.where(marked, value, 0).astype(np.uint8), deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    return grid


def felt(radius, ratio, top):
    """Yields for each tool: change of force, change of stiffness, depth of the press, whether the change is detectable."""
    material = vtkNoduleMaterial()
    material.SetInputData(body(radius, top))
    material.SetYoungsModulus(1.0)
    material.SetPoissonRatio(0.45)
    material.AddNodule(0, 0, -top - radius, radius, ratio)
    detect = vtkNoduleDetectability()
    detect.SetInputConnection(material.GetOutputPort())
    tool = vtkContactTool()
    tool.SetSpecification(TOOLS[0])
    detect.SetTool(tool)
    for more in TOOLS[1:]:
        detect.AddMoreTool(more)
    detect.SetThreshold(THRESHOLD)
    detect.SetMaximumDeflection(max(PRESSED.values()))
    detect.SetSourceSpacingWithout(HALF_WIDTH / 4)
    detect.AddObserver("WarningEvent", lambda *_: None)     # only the middle has a response
    for number, name in enumerate(TOOLS):
        detect.SetPressDepth(PRESSED[name])                 # one solution for all points
        detect.Update()
        data = detect.GetOutput().GetPointData()
        middle = detect.GetOutput().FindPoint(0, 0, 0)
        yield tuple(data.GetArray(array).GetComponent(middle, number)
                    for array in ("ForceChange", "StiffnessChange", "ChangeDepth", "Felt"))


def in_table(name):
    with open(REFERENCE / name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def table_changes():
    """Returns {(radius, ratio, top, tool): largest change over the table's depths}."""
    largest = {}
    for row in in_table("nodule_forces.csv"):
        key = (float(row["R_nodule"]), float(row["E_ratio"]), float(row["top_depth"]),
               row["tool"].replace("flat", "flat:").replace("sphere", "sphere:"))
        change = round(float(row["dF_%"]) / 100, 5)
        if abs(change) > abs(largest.get(key, 0.0)):
            largest[key] = change
    return largest


def study(radii=RADII, ratios=RATIOS, tops=TOPS):
    table = table_changes()
    for radius in radii:
        for ratio in ratios:
            for top in tops:
                for tool, (change, stiffness, depth, is_felt) in zip(TOOLS, felt(radius, ratio, top)):
                    yield dict(radius=radius, ratio=ratio, top=top, tool=tool, change=round(change, 5),
                               change_table=table.get((radius, ratio, top, tool), ""),
                               stiffness_change=round(stiffness, 5), depth=round(depth, 3), felt=int(is_felt))


def felt_to(rows):
    """Returns the depth of the top at which the change equals the threshold, as text; "<1" or ">5" outside the range."""
    tops = [row["top"] for row in rows]
    changes = [abs(row["change"]) for row in rows]
    if changes[0] < THRESHOLD:
        return f"<{tops[0]:g}"
    for i in range(1, len(tops)):
        if changes[i] < THRESHOLD:
            # Changes decay about exponentially with depth.
            share = np.log(changes[i - 1] / THRESHOLD) / np.log(changes[i - 1] / changes[i])
            return f"{tops[i - 1] + share * (tops[i] - tops[i - 1]):.1f}"
    return f">{tops[-1]:g}"


def felt_rows(rows):
    table = {(float(row["R_nodule"]), float(row["E_ratio"]),
              row["tool"].replace("flat", "flat:").replace("sphere", "sphere:")): row["depth at |dF|=10%"]
             for row in in_table("nodule_detectability.csv")}
    for key in dict.fromkeys((row["radius"], row["ratio"], row["tool"]) for row in rows):
        mine = [row for row in rows if (row["radius"], row["ratio"], row["tool"]) == key]
        yield dict(radius=key[0], ratio=key[1], tool=key[2], felt_to=felt_to(mine), felt_to_table=table[key])


def words(rows, found):
    def percent(row):
        table = row["change_table"]
        return f"{100 * row['change']:+.1f}" + (f" ({100 * table:+.1f})" if table != "" else "")
    lines = ["By how much the force changes, in per cent, in brackets the table's.", ""]
    for radius in dict.fromkeys(row["radius"] for row in rows):
        tops = [top for top in dict.fromkeys(row["top"] for row in rows)]
        lines += [f"| R = {radius:g} mm | " + " | ".join(f"{top:g} mm" for top in tops) + " | felt down to, mm |",
                  "|---|" + "---|" * (len(tops) + 1)]
        for mark in found:
            if mark["radius"] == radius:
                mine = [row for row in rows if all(row[key] == mark[key] for key in ("radius", "ratio", "tool"))]
                lines.append(f"| ×{mark['ratio']:g}, `{mark['tool']}` | " + " | ".join(map(percent, mine)) +
                             f" | {mark['felt_to']} ({mark['felt_to_table']}) |")
        lines.append("")
    return "\n".join(lines)


def draw(rows, file):
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        print("no matplotlib: no picture", file=sys.stderr)
        return
    radii = list(dict.fromkeys(row["radius"] for row in rows))
    ratios = list(dict.fromkeys(row["ratio"] for row in rows))
    figure, panels = pyplot.subplots(len(ratios), len(radii), figsize=(11, 3.3 * len(ratios) + 0.6), squeeze=False,
                                     sharex=True, sharey="row")
    for down, ratio in enumerate(ratios):
        for across, radius in enumerate(radii):
            panel = panels[down][across]
            for tool, colour in zip(TOOLS, ("#000000", "#d55e00", "#0072b2")):
                mine = [row for row in rows if (row["radius"], row["ratio"], row["tool"]) == (radius, ratio, tool)]
                panel.plot([row["top"] for row in mine], [100 * row["change"] for row in mine], color=colour,
                           linewidth=1.4, label=tool.replace(":", " ") + " mm")
                there = [row for row in mine if row["change_table"] != ""]
                panel.plot([row["top"] for row in there], [100 * row["change_table"] for row in there], color=colour,
                           marker="o", markersize=5, linestyle="", markerfacecolor="none")
            panel.axhspan(-100 * THRESHOLD, 100 * THRESHOLD, color="#e8e8e8", zorder=0)
            panel.set_xlim(0.8, 5.2)
            if down == 0:
                panel.set_title(f"ball of {radius:g} mm", fontsize=10)
            if down == len(ratios) - 1:
                panel.set_xlabel("depth of its top, mm")
            if across == 0:
                panel.set_ylabel(f"change of force, %, {ratio:g} times as hard", fontsize=9)
    panels[0][-1].plot([], [], color="#666666", marker="o", markerfacecolor="none", linestyle="", label="another code")
    panels[0][-1].plot([], [], color="#e8e8e8", linewidth=8, label="not felt")
    panels[0][0].set_ylim(bottom=0)
    panels[-1][0].set_ylim(top=0) if ratios[-1] < 1 else None
    panels[0][-1].legend(frameon=False, fontsize=9)
    figure.tight_layout()
    figure.savefig(file, dpi=110)


def write(rows, columns, file):
    with open(file, "w", encoding="utf-8", newline="") as out:
        writer = csv.DictWriter(out, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/studies/nodule"))
    parser.add_argument("--quick", action="store_true", help="one radius")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    rows = []
    for row in study(radii=(3.0,) if options.quick else RADII):
        rows.append(row)
        print("R {radius:3g}  x{ratio:3g}  {top:3g} mm deep  {tool:12} {change:+.3f}  table {change_table}".format(**row),
              flush=True)
    found = list(felt_rows(rows))
    write(rows, COLUMNS, options.output / "nodule.csv")
    write(found, FELT_COLUMNS, options.output / "felt.csv")
    (options.output / "nodule.md").write_text(words(rows, found), encoding="utf-8")
    draw(rows, options.output / "nodule.png")


if __name__ == "__main__":
    main()
