# SPDX-License-Identifier: BSD-3-Clause
"""Curves of the finite-strain solver (Data/Studies/finite-strain), interpolated between its depths."""
import csv
import pathlib

import numpy as np

CURVES = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Studies" / "finite-strain" / "curves.csv"
NEO, LINEAR = ("neohooke", 0.0), ("linear", 0.0)


def read():
    """Returns {(tool, thickness, nu, model, parameter, fillet): rows of depth mm, F/E* mm², contact radius mm}."""
    found = {}
    with open(CURVES, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            key = (row["tool"], float(row["thickness_mm"]), float(row["nu"]), row["model"], float(row["parameter"]),
                   float(row["fillet_mm"]))
            found.setdefault(key, []).append([float(row[name]) for name in (
                "depth_mm", "force_over_modulus_mm2", "contact_radius_mm")])
    return {key: np.array(rows) for key, rows in found.items()}


class Factor:
    """c = F_finite/F_small of one tool and body over depth; NaN beyond the largest solved depth."""

    def __init__(self, rows, small, scale=1.0):
        """`small`: function from a depth of the solved tool to its force over modulus at small strain. `scale`: size of the
        requested tool over that of the solved tool, on a half-space, which has no length scale."""
        self.scale = scale
        self.depths, self.forces, self.radii = rows.T
        values = self.forces / np.array([small(d) for d in self.depths])
        self.roots, self.values = np.insert(np.sqrt(self.depths), 0, 0.0), np.insert(values, 0, 1.0)
        self.deepest = scale * self.depths[-1]

    def __call__(self, depths):
        """Returns c at depths, by cubic polynomials over √δ through four of the solved values and c = 1 at depth 0."""
        depths = np.asarray(depths, dtype=float)
        roots = np.sqrt(np.maximum(depths, 0) / self.scale)
        first = np.clip(np.searchsorted(self.roots, roots) - 2, 0, len(self.roots) - 4)
        c = np.zeros(depths.shape)
        for i in range(4):
            weight = np.ones(depths.shape)
            for j in range(4):
                if j != i:
                    weight *= (roots - self.roots[first + j]) / (self.roots[first + i] - self.roots[first + j])
            c += weight * self.values[first + i]
        return np.where(depths <= self.deepest * (1 + 1e-9), c, np.nan)

    def contact_radius(self, depth):
        """Returns the contact radius in the deformed body, mm; its resolution is the length of an element."""
        return self.scale * np.interp(depth / self.scale, self.depths, self.radii)
