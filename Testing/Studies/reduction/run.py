#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cost and error of responses with the fewest numbers within a tolerance, in several scenes.

    ./run study reduction [--quick] [--output DIR]

For each scene (see scenes.py), tool and tolerance: the fewest numbers per vertex that vtkReducedContactResponse
finds, bytes of the tick's record per vertex, the largest error over all vertices and depths as reported by the
filter, the largest error of the force on a tip along a path, and the time per tip along that path over the time
with the full response (the fastest of alternating passes). Writes reduction.csv, reduction.md and, with
matplotlib, reduction.png to DIR (default build/studies/reduction). Times depend on the machine; all other results
are the same everywhere.
"""
import argparse
import csv
import pathlib
import sys
import time

import numpy as np
from palpate import vtkReducedContactResponse, vtkToolContactProbe
from vtkmodules.util.numpy_support import vtk_to_numpy

import scenes

TOOLS = ("sphere:6.35", "flat:1.6", "cone:60")
TOLERANCES = (1e-4, 1e-3, 1e-2, 3e-2, 1e-1)
FORMS = ("one law", "scale", "basis", "samples", "unchanged")
RECORD = 16                     # bytes per vertex for range and normal
FIRST_SAMPLE = scenes.DEPTH / 64  # mm; at smaller depths errors are relative to the force at this depth
COLUMNS = ("scene", "vertices", "tool", "tolerance", "form", "numbers", "numbers_before", "bytes", "bytes_before",
           "largest_error", "slope_error", "felt_error", "tick_ratio", "reduce_s")


class Prober:
    """Computes the contacts of a tip along a path, and measures the time."""

    def __init__(self, body, tips):
        self.probe = vtkToolContactProbe()
        self.probe.SetInputData(0, body)
        self.probe.SetInputData(1, tips)
        self.seconds = np.inf
        self.felt()                                             # builds the kernel's copy of the body

    def felt(self):
        self.probe.Modified()
        start = time.perf_counter()
        self.probe.Update()
        self.seconds = min(self.seconds, time.perf_counter() - start)
        data = self.probe.GetOutput().GetPointData()
        return tuple(vtk_to_numpy(data.GetArray(name)).copy() for name in ("NormalForce", "Deflection"))


def reduce(body, tolerance):
    filter_ = vtkReducedContactResponse()
    filter_.SetInputData(body)
    filter_.SetTolerance(tolerance)
    start = time.perf_counter()
    filter_.Update()
    return filter_, time.perf_counter() - start


def felt_error(whole, reduced):
    (right, depth), (found, _) = whole, reduced
    least = right[depth >= FIRST_SAMPLE].min()
    return float((abs(found - right) / np.maximum(right, least)).max())


def rows_of(name, make, level, tools, tolerances, tips, passes):
    body, arrays = make(level)
    for tool in tools:
        whole = scenes.respond(body, arrays, tool)
        path = scenes.path(whole, "Response", tips)
        before = Prober(whole, path)
        for tolerance in tolerances:
            filter_, seconds = reduce(whole, tolerance)
            after = Prober(filter_.GetOutput(), path)
            before.seconds = np.inf
            for _ in range(passes):
                right, found = before.felt(), after.felt()
            yield {
                "scene": name, "vertices": whole.GetNumberOfPoints(), "tool": tool, "tolerance": tolerance,
                "form": FORMS[filter_.GetForm()], "numbers": filter_.GetNumbersPerPoint(),
                "numbers_before": filter_.GetNumbersPerPointBefore(),
                "bytes": RECORD + 4 * filter_.GetNumbersPerPoint(),
                "bytes_before": RECORD + 4 * filter_.GetNumbersPerPointBefore(),
                "largest_error": filter_.GetLargestError(), "slope_error": filter_.GetLargestStiffnessError(),
                "felt_error": felt_error(right, found), "tick_ratio": after.seconds / before.seconds,
                "reduce_s": seconds}


def study(is_quick):
    level, tips, passes = (4, 4000, 1) if is_quick else (6, 40000, 7)
    tools, tolerances = (TOOLS[:1], (1e-2,)) if is_quick else (TOOLS, TOLERANCES)
    for name, make in scenes.SCENES.items():
        if name == "head" and not scenes.SCAN.exists():
            print("no head: " + str(scenes.SCAN) + " is missing (Debian's mricron-data)", file=sys.stderr)
            continue
        yield from rows_of(name, make, level, tools, tolerances, tips, passes)


def table(rows):
    lines = ["| scene | vertices | tool | tolerance | what is left | numbers per vertex | bytes | largest error | felt "
             "| tick |", "|---|---|---|---|---|---|---|---|---|---|"]
    for row in rows:
        lines.append("| {scene} | {vertices} | `{tool}` | {tolerance:g} | {form} | {numbers} of {numbers_before} "
                     "| {bytes} of {bytes_before} | {largest_error:.1e} | {felt_error:.1e} | {tick_ratio:.2f} |"
                     .format(**row))
    return "\n".join(lines) + "\n"


def draw(rows, file):
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        print("no matplotlib: no picture", file=sys.stderr)
        return
    colours = dict(zip(scenes.SCENES, ("#000000", "#e69f00", "#56b4e9", "#009e73", "#d55e00")))
    markers = dict(zip(TOOLS, "osv"))
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.4))
    for shift, (name, colour) in enumerate(colours.items()):
        for tool, marker in markers.items():
            mine = [row for row in rows if row["scene"] == name and row["tool"] == tool]
            if not mine:
                continue
            label = name if tool == TOOLS[0] else None
            left.plot([row["tolerance"] for row in mine], [row["numbers"] + 0.12 * shift for row in mine], color=colour,
                      marker=marker, markersize=5, linewidth=1, alpha=0.8, label=label)
            right.plot([row["bytes"] for row in mine], [row["tick_ratio"] for row in mine], color=colour,
                       marker=marker, markersize=5, linestyle="", alpha=0.8)
    left.axhline(16, color="#999999", linestyle="--", linewidth=1)
    left.annotate("16: forces and slopes of 8 samples", (0.02, 16), xycoords=("axes fraction", "data"), xytext=(0, -13),
                  textcoords="offset points", color="#666666")
    left.set_xscale("log")
    left.set_xlabel("tolerance: largest relative error of the force at any vertex and depth")
    left.set_ylabel("numbers per vertex (lines set apart)")
    left.set_ylim(-0.5, 17.5)
    left.legend(title="body", frameon=False)
    right.axhline(1, color="#999999", linestyle="--", linewidth=1)
    right.axvline(80, color="#999999", linestyle="--", linewidth=1)
    right.set_xlim(10, 84)
    right.set_ylim(0, 1.3)
    right.set_xlabel("bytes per vertex that a tick reads (80 before)")
    right.set_ylabel("time per tip, over that of the whole response")
    for tool, marker in markers.items():
        right.plot([], [], color="#666666", marker=marker, linestyle="", label=tool + (" mm" if tool[0] != "c" else "°"))
    right.legend(title="tool", frameon=False, loc="lower right")
    figure.tight_layout()
    figure.savefig(file, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/studies/reduction"))
    parser.add_argument("--quick", action="store_true", help="coarse bodies, one tool, one tolerance")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    rows = []
    for row in study(options.quick):
        rows.append(row)
        print("{scene:14} {tool:12} {tolerance:7g}  {form:10} {numbers:3} of {numbers_before}  error {largest_error:.1e}"
              "  felt {felt_error:.1e}  tick {tick_ratio:.2f}".format(**row), flush=True)
    with open(options.output / "reduction.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    (options.output / "reduction.md").write_text(table(rows), encoding="utf-8")
    draw(rows, options.output / "reduction.png")


if __name__ == "__main__":
    main()
