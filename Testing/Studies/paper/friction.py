# SPDX-License-Identifier: BSD-3-Clause
"""Hysteresis and section 4.4: the friction that would be needed to explain them. Numbers only.

The curves of this study have no loop, because the bodies are elastic and the contacts frictionless. Friction laws:
Jäger 1998, Ciavarella 1998 for the sliding sphere; for the loss in a normal press an upper bound is computed.
"""
import math

import numpy as np

import results
from setting import FRICTION_FORCE, LARGE, RUBBER, SLIDING_FORCE, SMALL, contact_tool, half_space_depth

POISSON = (0.5, 0.49, 0.45)
MU = FRICTION_FORCE / SLIDING_FORCE      # 0.5


def softness(poisson_ratio):
    """Returns the ratio of tangential to normal compliance of a contact (Mindlin 1949)."""
    return (2 - poisson_ratio) / (2 * (1 - poisson_ratio))


def slip_loss(poisson_ratio, specification, depth):
    """Returns an upper bound of the share of the work that a press and release loses by slip under the tool: the surface
    slides freely by its radial displacement, and friction mu p acts along the whole displacement."""
    kernel = contact_tool(specification)
    a = kernel.GetContactRadius(depth)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    s, depths = 0.5 * (nodes + 1), np.linspace(0.0, depth, 201)[1:]
    # Pressure and radial displacement of a material point at r while the tool moves down.
    work = 0.0
    for x, w in zip(s, 0.5 * weights):
        r = x * a
        pressure, radial, u = [], [], [0.0, 0.0]
        for d in depths:
            kernel.GetSurfaceDisplacement(r, d, poisson_ratio, u)
            radial.append(u[0])
            pressure.append(kernel.GetPressure(r, d, RUBBER))
        mean = 0.5 * (np.array(pressure[1:]) + pressure[:-1])
        work += w * a * 2 * math.pi * r * np.sum(MU * mean * np.abs(np.diff(radial)))
    stored = np.sum(0.5 * weights * [kernel.GetForce(depth * x, RUBBER) for x in s]) * depth
    return 2 * work / stored


def make(folder, quick):
    columns = {name: [] for name in ("nu", "depth_at_14N_mm", "depth_at_14N_table1_mm", "presliding_mm",
                                     "presliding_table1_mm", "sticking_angle_deg", "slip_loss_bound")}
    exact, table1 = (half_space_depth(contact_tool(s), SLIDING_FORCE)
                     for s in (SMALL.specification, SMALL.table1))
    for nu in POISSON:
        pull = MU * softness(nu)
        # By Table 1 the bound does not depend on depth or radius.
        loss = slip_loss(nu, LARGE.table1, 1.0)
        for name, value in zip(columns, (nu, exact, table1, pull * exact, pull * table1,
                                         math.degrees(math.atan(pull)), loss)):
            columns[name].append(value)
        print("  nu = {}: slides after {:.5f} mm sideways at 14 N (Table 1: {:.5f}); a slanted press sticks up to "
              "{:.1f} deg; slip under a normal press loses at most {:.2f} %".format(
                  nu, pull * exact, pull * table1, columns["sticking_angle_deg"][-1], 100 * loss))
    results.write_table(folder / "section4.4_friction.csv", columns)
