#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the additional compliance of a point near an edge, as a function of the angle by which the surface turns.

    wedge.py [--output wedge_point_law.csv]      (a quarter of an hour; needs python3-scipy)

A unit force loads a wedge at a point of one face at distance d = 1 from its edge. The mesh has linear elastic hexahedra
(with the volume change averaged over each) in polar coordinates around the edge, graded around the load. One half is
modelled, because of symmetry, and it is held at distance R. The mesh under the load is the same for each angle, so that
the difference between the displacement there and that of a half-space is regular: C = psi/(2 pi E* d). Results at R = 30
and 60 are extrapolated to infinite R, since the effect of the held boundary is proportional to 1/R. For a right angle
Hetényi's quarter space has psi = 1.517, 1.845, 2.449 at nu = 0.15, 0.3, 0.45 (Data/Reference/edges).
"""
import argparse
import csv

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linear

STEP = 7.5  # degrees per element
FIRST, GROWTH = 0.07, 1.25  # size of the elements around the load
CORNERS = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1],
                    [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], float)
GAUSS = [(x, y, z) for x in (-3**-0.5, 3**-0.5) for y in (-3**-0.5, 3**-0.5) for z in (-3**-0.5, 3**-0.5)]


def graded(end):
    places, width = [0.0], FIRST
    while places[-1] < end:
        places.append(places[-1] + width)
        width *= GROWTH
    return np.array(places) * end / places[-1]


def wedge(turn, reach):
    """Returns nodes (n, 3), cells (m, 8), held components (n, 3) and the loaded node. The loaded face is z = 0, x < 0."""
    angles = np.deg2rad(np.linspace(0.0, 180.0 - turn, int(round((180.0 - turn) / STEP)) + 1))
    inner = 1.0 - graded(0.9)[::-1]
    radii = np.concatenate([inner[:-1], 1.0 + graded(reach - 1.0)])
    along = graded(reach)
    shape = (len(radii), len(angles), len(along))
    i, j, k = np.meshgrid(*map(np.arange, shape), indexing="ij")
    nodes = np.stack([-radii[i] * np.cos(angles[j]), along[k], -radii[i] * np.sin(angles[j])], -1).reshape(-1, 3)
    number = np.arange(nodes.shape[0]).reshape(shape)
    bottom = [number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]
    cells = np.stack([n[..., :-1].ravel() for n in bottom] + [n[..., 1:].ravel() for n in bottom], 1)
    held = np.zeros(nodes.shape, bool)
    held[((i == shape[0] - 1) | (k == shape[2] - 1)).ravel()] = True
    held[(k == 0).ravel(), 1] = True
    return nodes, cells, held, number[len(inner) - 1, 0, 0]


def stiffness(nodes, cells, poisson):
    """Returns the stiffness matrix for Young's modulus 1."""
    lame, shear = poisson / ((1 + poisson) * (1 - 2 * poisson)), 0.5 / (1 + poisson)
    law = np.diag([2 * shear] * 3 + [shear] * 3)
    law[:3, :3] += lame
    gradients, weights = [], []
    for point in GAUSS:
        factors = 1 + CORNERS * point
        local = np.stack([CORNERS[:, a] * factors[:, (a + 1) % 3] * factors[:, (a + 2) % 3] for a in range(3)], 1) / 8
        jacobian = np.einsum("qa,eqb->eab", local, nodes[cells])
        gradients.append(np.einsum("eab,qb->eqa", np.linalg.inv(jacobian), local))
        weights.append(np.abs(np.linalg.det(jacobian)))
    mean = sum(g * w[:, None, None] for g, w in zip(gradients, weights)) / sum(weights)[:, None, None]
    elements = 0.0
    for gradient, weight in zip(gradients, weights):
        strain = np.zeros((len(cells), 6, 8, 3))
        for a, b, row in ((0, 0, 0), (1, 1, 1), (2, 2, 2), (0, 1, 3), (1, 2, 4), (2, 0, 5)):
            strain[:, row, :, a] = gradient[:, :, b]
            strain[:, row, :, b] = gradient[:, :, a]
        strain[:, :3] += ((mean - gradient) / 3)[:, None]
        strain = strain.reshape(len(cells), 6, 24)
        elements = elements + np.einsum("eia,ij,ejb->eab", strain, law, strain) * weight[:, None, None]
    unknowns = (3 * cells[:, :, None] + np.arange(3)).reshape(-1, 24)
    return sparse.coo_matrix((elements.ravel(), (np.repeat(unknowns, 24, 1).ravel(), np.tile(unknowns, 24).ravel())),
                             shape=(nodes.size, nodes.size)).tocsc()


def displacement(turn, poisson, reach):
    nodes, cells, held, loaded = wedge(turn, reach)
    free = np.flatnonzero(~held.ravel())
    load = np.zeros(nodes.size)
    load[3 * loaded + 2] = -0.5  # the model is one half
    solver = linear.splu(stiffness(nodes, cells, poisson)[free][:, free], permc_spec="MMD_AT_PLUS_A",
                         diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    found = np.zeros(nodes.size)
    found[free] = solver.solve(load[free])
    return -found[3 * loaded + 2]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", default="wedge_point_law.csv")
    with open(parser.parse_args().output, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["nu", "turn_deg", "psi (C_edge=psi/(2 pi E* d))"])
        for poisson in (0.0, 0.15, 0.3, 0.45):
            flat = [displacement(0.0, poisson, reach) for reach in (30.0, 60.0)]
            for turn in (22.5, 45.0, 67.5, 90.0, 105.0, 120.0):
                near, far = (displacement(turn, poisson, reach) - of for reach, of in zip((30.0, 60.0), flat))
                rows.writerow([poisson, turn, "%.4f" % ((2 * far - near) * 2 * np.pi / (1 - poisson**2))])
                file.flush()


if __name__ == "__main__":
    main()
