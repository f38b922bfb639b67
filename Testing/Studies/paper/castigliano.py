# SPDX-License-Identifier: BSD-3-Clause
"""Equation (1): δ = ∂U/∂F is valid for linear responses; in general δ = ∂U*/∂F.

U is the stored energy, the integral of F over δ. U* is the complementary energy, the integral of δ over F.
Both come from quadrature of the curve of a paraboloid on a half-space in series with a compliance, and
are then differentiated numerically.
"""
import numpy as np

import results
from body import add_array, curve, respond, square
from setting import LARGE, RUBBER, contact_tool, half_space_depth, root

COMPLIANCE, FORCE = 0.1, 5.0           # mm/N, N: an example of this study, not from the paper


class SeriesCurve:
    """δ(F) of a tool on a half-space in series with a compliance, and its two energies."""

    def __init__(self, specification, compliance):
        self.tool, self.compliance = contact_tool(specification), compliance
        nodes, weights = np.polynomial.legendre.leggauss(24)
        self.nodes, self.weights = 0.5 * (nodes + 1), 0.5 * weights

    def depth(self, force):
        return half_space_depth(self.tool, force) + self.compliance * force

    def force(self, depth):
        local = root(lambda d: d + self.compliance * self.tool.GetForce(d, RUBBER) - depth, 0.0, depth)
        return self.tool.GetForce(local, RUBBER)

    # With F = F_end s³ and δ = δ_end s² the integrands are smooth at 0, where δ ~ F^(2/3).
    def complementary_energy(self, force):
        s = self.nodes
        return force * np.sum(self.weights * 3 * s ** 2 * [self.depth(force * x ** 3) for x in s])

    def energy(self, force):
        s, depth = self.nodes, self.depth(force)
        return depth * np.sum(self.weights * 2 * s * [self.force(depth * x ** 2) for x in s])


def derivative(function, x):
    """Returns the derivative by central differences at three steps, extrapolated to step 0 (error ~ step⁶)."""
    steps = [0.08 * x, 0.04 * x, 0.02 * x]
    first = [(function(x + h) - function(x - h)) / (2 * h) for h in steps]
    second = [(4 * b - a) / 3 for a, b in zip(first, first[1:])]
    return (16 * second[1] - second[0]) / 15


def make(folder, quick):
    forces = np.array([1.0, 3.0, FORCE] if quick else np.arange(0.5, 10.1, 0.5))
    tables = {}
    for key, specification in (("paraboloid", LARGE.table1), ("flat", "flat:1.6")):
        law = SeriesCurve(specification, COMPLIANCE)
        tables[key] = {"force_N": forces, "delta_mm": [law.depth(f) for f in forces],
                       "dUstar_dF_mm": [derivative(law.complementary_energy, f) for f in forces],
                       "dU_dF_mm": [derivative(law.energy, f) for f in forces]}
    results.write_table(folder / "equation1_castigliano.csv", {
        "tool": [key for key in tables for _ in forces],
        **{name: np.concatenate([tables[key][name] for key in tables]) for name in tables["flat"]}})

    found = example()
    print("  paraboloid, R = 6.35 mm, C = {} mm/N, F = {} N: delta = {:.10f}, dU*/dF = {:.10f}, dU/dF = {:.10f} "
          "mm".format(COMPLIANCE, FORCE, found["delta"], found["complementary"], found["energy"]))
    print("  the response stored in 8 samples gives {:.6f} N there".format(found["felt"]))
    draw(folder, tables)


def example():
    """Returns the two derivatives at FORCE, and the force of a stored response at that deflection."""
    law = SeriesCurve(LARGE.table1, COMPLIANCE)
    exact = law.depth(FORCE)
    body = square()
    add_array(body, "Compliance", np.full(body.GetNumberOfPoints(), COMPLIANCE))
    felt = curve(respond(body, LARGE.table1, 2.0, RUBBER, 0.5, compliance="Compliance"), 4, exact)
    return {"delta": exact, "complementary": derivative(law.complementary_energy, FORCE),
            "energy": derivative(law.energy, FORCE), "felt": float(felt)}


def draw(folder, tables):
    figure, panels = results.picture(2)
    if figure is None:
        return
    for panel, key, title in ((panels[0], "paraboloid", "Sphere (Table 1) of 12.7 mm: not linear"),
                              (panels[1], "flat", "Flat of 3.2 mm: linear")):
        table = tables[key]
        panel.plot(table["force_N"], table["delta_mm"], color="black", label="deflection $\\delta$")
        panel.plot(table["force_N"], table["dUstar_dF_mm"], "o", color="#0072B2", fillstyle="none",
                   label="$\\partial U^*/\\partial F$, complementary energy")
        panel.plot(table["force_N"], table["dU_dF_mm"], "x", color="#D55E00",
                   label="$\\partial U/\\partial F$, equation (1)")
        panel.set(xlabel="force F, N", ylabel="deflection, mm", title=title, xlim=(0, None), ylim=(0, None))
        panel.legend()
    results.save(figure, folder / "equation1_castigliano.png")
