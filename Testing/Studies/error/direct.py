# SPDX-License-Identifier: BSD-3-Clause
"""Compares stored responses with direct contact on a fine mesh, at random places. The responses are those of true shape, or
those of a law in series with the compliance of the whole body.

Each place gets a separate mesh, fine under the tool, on which palpateDirectContact presses the tool: without a Green
function and without a law of contact. Response and direct contact use the same smooth surface, in which four triangles
replace one of the body (Dyn, Levin and Gregory 1990), as many times as requested. The direct contact is with facets;
therefore its surface is refined once more. The error of the shape between the points of a scan is not included. With
--smooth 0 neither surface is refined, and facets count as errors. Both forces are at small strain. The stated error is
that of the response with Neo-Hooke, so that it has no part for small strain.
"""
import csv
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import palpate
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkButterflySubdivisionFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

import true_shape
from cover import LIMITS, areas, force_on_layer, poly

PROGRAM = pathlib.Path(__file__).resolve().parents[3] / "build" / "release" / "bin" / "palpateDirectContact"
CELLS = 30000      # number of cells away from the tool
FACETS = 0.3       # facet size under the tool over the contact radius: at the pole of a ball the error is within 1 %
RIM = 0.12         # facet size at the rim of a flat end over the contact radius: the error is within 2 %
AROUND = 1.4       # the small facets extend to this multiple of the contact radius
RANGES = ((0.0, 0.05), (0.05, 0.1), (0.1, 0.3))  # intervals of the stated error
COLUMNS = ("body", "tool", "point", "x", "y", "z", "stated", "limit", "force_N", "direct_N", "open", "error")


def smooth(body, times):
    """Returns the body with each triangle replaced by four, `times` times. The points of the body remain the first points.
    Raises ValueError if VTK cannot refine the body."""
    if times == 0:
        return body
    finer = vtkButterflySubdivisionFilter()
    finer.SetInputData(body)
    finer.SetNumberOfSubdivisions(times)
    finer.Update()
    if finer.GetOutput().GetNumberOfCells() != 4**times * body.GetNumberOfCells():
        raise ValueError("cannot be refined smoothly, as only a closed surface without flaps can: try --smooth 0")
    return finer.GetOutput()


def filled(body, fixed, spacing, tool, place, inward):
    """Returns the body filled with tetrahedra, which are fine around the place."""
    radius = true_shape.contact_tool(tool).GetContactRadius(1.0)
    made = palpate.vtkGradedBody()
    made.SetInputData(body)
    made.SetSurfaceSpacing(spacing)
    made.SetFixedFaces(fixed)
    made.AddFineBall(*place, AROUND * radius, FACETS * radius)
    if tool.startswith("flat"):
        across = np.linalg.svd(inward[None])[2][1:]
        for angle in np.arange(32) * np.pi / 16:
            rim = place + radius * (np.cos(angle) * across[0] + np.sin(angle) * across[1])
            made.AddFineBall(*rim, RIM * radius, RIM * radius)
    made.Update()
    return made.GetOutput()


def direct_forces(grid, tool, place, inward, young=0.05, poisson=0.45, depth=1.0):
    """Returns two forces (N) of the direct contact at small strain: with all pressures along the mean normal, and with each
    pressure along its own normal. NaN if the direct contact fails."""
    with tempfile.NamedTemporaryFile(suffix=".vtu") as file:
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(file.name)
        writer.SetInputData(grid)
        writer.SetDataModeToBinary()
        writer.SetCompressorTypeToNone()
        writer.Write()
        words = [file.name, young, poisson, tool, depth, *place, *inward]
        done = subprocess.run([str(PROGRAM), *(str(word) for word in words)], stdout=subprocess.PIPE, text=True, check=False)
        return np.array([float(line) for line in done.stdout.splitlines()] if done.returncode == 0 else [np.nan] * 2)


def block(half=25.0, height=10.0):
    """Returns a block as a closed surface with its top at z = 0."""
    corners = np.array([(x, y, z) for z in (-height, 0.0) for y in (-half, half) for x in (-half, half)])
    sides = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6))
    triangles = [(a, b, c) for a, b, c, _ in sides] + [(a, c, d) for a, _, c, d in sides]
    return poly(corners, np.array(triangles))


def own_error(tool):
    """Returns the force of the direct contact on a bonded layer, divided by the exact force: the effect of the facets."""
    place, inward = np.zeros(3), np.array((0.0, 0.0, -1.0))
    direct = direct_forces(filled(block(), "z-", 2.5, tool, place, inward), tool, place, inward)[0]
    return direct / force_on_layer(tool, 10.0, 1.0, 0.05, 0.45)


def drawn(made, tool, area, count, random):
    """Yields random points with a complete curve, weighted by area: `count` from each range of the stated error."""
    error = true_shape.array(made, tool, "Error")[:len(area), -1]
    usable = (true_shape.array(made, tool, "Status")[:len(area)] == 0) & (true_shape.array(made, tool, "Range")[:len(area)] > 0.999)
    for low, high in RANGES:
        found = np.flatnonzero(usable & (area > 0) & (error > low) & (error <= high))
        if len(found):
            weights = area[found] / area[found].sum()
            yield from random.choice(found, min(count, len(found)), replace=False, p=weights)


def judge(name, body, press, count, times, own, seed=5):
    """Yields rows of COLUMNS. `press` returns the surface with responses, and the names of the faces that hold it; `own` is
    own_error() of each tool."""
    surface = smooth(body, times)
    made, fixed = press(surface)
    facets = smooth(body, times + 1 if times else 0)  # on the bunny, facets of 1.5 mm reduce a force by 2 %
    places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    spacing = np.sqrt(8.7 * areas(surface).sum() / CELLS)
    random = np.random.default_rng(seed)
    cases = [(tool, int(point)) for tool in true_shape.TOOLS for point in drawn(made, tool, areas(body), count, random)]

    def one(case):
        tool, point = case
        inward = -true_shape.array(made, tool, "Normal")[point].astype(float)
        inward /= np.linalg.norm(inward)
        forces = direct_forces(filled(facets, fixed, spacing, tool, places[point], inward), tool, places[point], inward)
        return forces / own[tool]

    with ThreadPoolExecutor(2) as threads:
        for (tool, point), both in zip(cases, threads.map(one, cases)):
            direct = both.mean()
            force = float(true_shape.array(made, true_shape.SMALL + tool, "Force")[point, -1])
            stated = float(true_shape.array(made, tool, "Error")[point, -1])
            limit = LIMITS[int(true_shape.array(made, tool, "Limit")[point])]
            yield (name, tool, point, *("{:.2f}".format(x) for x in places[point]), "{:.4f}".format(stated), limit,
                   "{:.5g}".format(force), "{:.5g}".format(direct), "{:.4f}".format(np.ptp(both) / 2 / direct), "{:.4f}".format(force / direct - 1))


def summary(rows, holds):
    """Yields for each body, tool and range of the stated error: number of rows, number of rows for which the stated error
    holds, median error."""
    for body, tool in sorted({(row["body"], row["tool"]) for row in rows}):
        for low, high in RANGES:
            found = [row for row in rows if (row["body"], row["tool"]) == (body, tool) and low < float(row["stated"]) <= high]
            if found:
                errors = sorted(abs(float(row["error"])) for row in found)
                yield body, tool, low, high, len(found), sum(map(holds, found)), errors[len(errors) // 2]


def write(bodies, press, count, times, output):
    """Writes direct.csv and returns its rows."""
    rows = []
    own = {tool: own_error(tool) for tool in true_shape.TOOLS}
    with open(output / "direct.csv", "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        for name, body in bodies:
            try:
                for row in judge(name, body, press, count, times, own):
                    table.writerow(row)
                    file.flush()
                    rows.append(dict(zip(COLUMNS, row)))
                    print(*row, flush=True)
            except ValueError as fault:
                print("{} {}.".format(name, fault), file=sys.stderr, flush=True)
    return rows
