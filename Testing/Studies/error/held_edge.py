#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the reduction of an edge's softening by a base: Data/Reference/edges/held_edge.csv.

    ./run python Testing/Studies/error/held_edge.py FILE.csv

The radius of a flat end is half its distance d from the edge of a block. The block is bonded to a base at a depth h and
is four times as wide as deep. Its force by finite elements of true shape (vtkElasticContactResponse; 0.3 % near edges) is
divided by the force of the same tool on an endless layer of that depth.
"""
import csv
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "accuracy-speed"))

import palpate  # noqa: E402
import shape_bodies  # noqa: E402

from cover import force_on_layer  # noqa: E402

DEPTH = 30.0
CASES = {0.3: (2.0, 4.0, 8.0), 0.45: (1.0, 2.0, 4.0, 8.0, 16.0)}


def block(distance):
    half, cell = 2 * DEPTH, distance / 4
    mesh = shape_bodies.hexahedra(
        shape_bodies.outwards(cell, 2 * distance, 1.3, 2 * half),
        shape_bodies.both_ways(shape_bodies.outwards(cell, 1.3 * distance, 1.3, half)),
        -shape_bodies.outwards(cell, distance, 1.3, DEPTH)[::-1])
    shape_bodies.mark(mesh, "Fixed", np.where(shape_bodies.points_of(mesh)[:, 2] < 1e-3 - DEPTH, 7, 0))
    shape_bodies.press_at(mesh, (distance, 0, 0), 0.6 * cell)
    return mesh


def last(body, point):
    force = body.GetPointData().GetArray("ResponseForce")
    return force.GetComponent(point, force.GetNumberOfComponents() - 1)


def factor(poisson, distance):
    deflection = 0.02 * distance
    tool = "flat:%g" % (distance / 2)
    elements = palpate.vtkElasticContactResponse()
    elements.SetInputData(block(distance))
    elements.SetTool(shape_bodies.tool(tool))
    elements.SetYoungsModulus(1.0)
    elements.SetPoissonRatio(poisson)
    elements.SetMaximumDeflection(deflection)
    elements.AddObserver("WarningEvent", lambda *_: None)   # most points are not pressed
    elements.Update()
    beside = last(elements.GetOutput(), elements.GetOutput().FindPoint(distance, 0, 0))
    return beside / force_on_layer(tool, DEPTH, deflection, 1.0, poisson)


def main():
    with open(sys.argv[1], "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(("nu", "u=d/a0", "d/h", "Phi=F/F_layer"))
        for poisson, distances in CASES.items():
            for distance in distances:
                rows.writerow((poisson, 2, "%.5f" % (distance / DEPTH), "%.4f" % factor(poisson, distance)))


if __name__ == "__main__":
    main()
