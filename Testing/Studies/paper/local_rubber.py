# SPDX-License-Identifier: BSD-3-Clause
"""Figure 6: three tools on rubber that is held by a large surface, E* = 3.45 MPa, up to 12 N.

Shows the law with which the paper compares its measurements, for the exact sphere and for the
paraboloid of Table 1, and the force tick by tick at 1 mm/s from a response stored in eight samples.
All curves are computed, not measured.
"""
import numpy as np

import results
from body import press, respond, square, validity
from setting import FLAT, LARGE, LARGEST_FORCE, RUBBER, SPEED, TOOLS, contact_tool, half_space_depth, root

POISSON = 0.5       # of rubber; the force depends only on E*
APPROACH = 0.5      # mm


def make(folder, quick):
    depths = np.linspace(0.0, 1.8, 19 if quick else 73)
    table, validities, moves, errors = {"delta_mm": depths}, {}, {}, {}
    for tool in TOOLS:
        exact, paraboloid = contact_tool(tool.specification), contact_tool(tool.table1)
        deepest = half_space_depth(exact, LARGEST_FORCE)
        responding = respond(square(), tool.specification, deepest, RUBBER, POISSON)
        validities[tool] = validity(responding, 4)
        table["F_%s_N" % tool.key] = [exact.GetForce(d, RUBBER) for d in depths]
        if tool is not FLAT:
            table["F_%s_table1_N" % tool.key] = [paraboloid.GetForce(d, RUBBER) for d in depths]
        moves[tool] = press(responding, deepest, APPROACH)
        errors[tool] = np.max([abs(f - exact.GetForce(d, RUBBER)) for _, d, f in zip(*moves[tool])])
    results.write_table(folder / "figure6_curves.csv", table)
    write_moves(folder, moves)
    numbers = at_largest_force(folder, validities)
    for tool in TOOLS:
        print("  {}: 12 N at {:.6f} mm; felt at 1 kHz within {:.2g} N of the law; valid to {:.3f} mm".format(
            tool.key, numbers[tool], errors[tool], validities[tool]))
    crossing = crossing_point()
    print("  sphere12.7 by Table 1 and flat3.2 cross at {:.10f} mm, {:.10f} N; exact sphere at {:.6f} mm, {:.6f} "
          "N".format(*crossing))
    draw(folder, table, validities, moves, numbers)


def write_moves(folder, moves):
    """Writes every 20th tick of each tool, 50 per second."""
    columns = {"tool": [], "time_s": [], "displacement_mm": [], "force_N": []}
    for tool, move in moves.items():
        time, displacement, force = (column[::20] for column in move)
        columns["tool"] += [tool.key] * len(time)
        columns["time_s"] += list(time)
        columns["displacement_mm"] += list(displacement)
        columns["force_N"] += list(force)
    results.write_table(folder / "figure6_trajectory.csv", columns)


def at_largest_force(folder, validities):
    """Writes depth and contact radius at 12 N; returns the depths."""
    columns = {name: [] for name in ("tool", "delta_mm", "a_mm", "a_over_R", "delta_table1_mm",
                                     "a_over_R_table1", "valid_to_mm")}
    for tool in TOOLS:
        exact, paraboloid = contact_tool(tool.specification), contact_tool(tool.table1)
        depth, other = (half_space_depth(kernel, LARGEST_FORCE) for kernel in (exact, paraboloid))
        radius = exact.GetRadius()
        for name, value in zip(columns, (tool.key, depth, exact.GetContactRadius(depth),
                                         exact.GetContactRadius(depth) / radius, other,
                                         paraboloid.GetContactRadius(other) / radius, validities[tool])):
            columns[name].append(value)
    results.write_table(folder / "figure6_at_12N.csv", columns)
    return dict(zip(TOOLS, columns["delta_mm"]))


def crossing_point():
    """Returns depth and force at which the curve of the large sphere crosses that of the flat, by Table 1 and exactly."""
    flat = contact_tool(FLAT.specification)
    found = []
    for specification in (LARGE.table1, LARGE.specification):
        sphere = contact_tool(specification)
        depth = root(lambda d: sphere.GetForce(d, RUBBER) - flat.GetForce(d, RUBBER), 0.2, 2.0)
        found += [depth, flat.GetForce(depth, RUBBER)]
    return found


def draw(folder, table, validities, moves, numbers):
    figure, panels = results.picture(2)
    if figure is None:
        return
    for tool in TOOLS:
        time, displacement, _ = moves[tool]
        panels[0].plot(time, displacement, tool.dash, color=tool.colour, label=tool.name)
        depths, forces = table["delta_mm"], np.array(table["F_%s_N" % tool.key])
        panels[1].plot(depths[forces < 13], forces[forces < 13], color=tool.colour, label=tool.name)
        if validities[tool] < numbers[tool] * (1 - 1e-6):
            panels[1].plot(validities[tool], np.interp(validities[tool], depths, forces), "o",
                           color=tool.colour, fillstyle="none")
        if tool is not FLAT:
            other = np.array(table["F_%s_table1_N" % tool.key])
            panels[1].plot(depths[other < 13], other[other < 13], ":", color=tool.colour,
                           label="the same by Table 1")
    panels[0].axhline(0, color="black", linewidth=0.8)
    panels[0].set(xlabel="time, s", ylabel="displacement into the body, mm",
                  title="Trajectory at {:g} mm/s, to 12 N each".format(SPEED))
    panels[0].legend(loc="upper right")
    panels[1].plot([], [], "o", color="0.3", fillstyle="none", label="small strain ends ($a/R$ or $\\delta/a$ = 0.4)")
    panels[1].axhline(LARGEST_FORCE, color="black", linewidth=0.8)
    panels[1].set(xlabel="deflection $\\delta$, mm", ylabel="force F, N", xlim=(0, 1.9), ylim=(0, 13),
                  title="Half-space, E* = {:g} MPa (computed)".format(RUBBER))
    panels[1].legend(loc="lower right")
    results.save(figure, folder / "figure6_local_rubber.png")
