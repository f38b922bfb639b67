# SPDX-License-Identifier: BSD-3-Clause
"""Figure 7: two spheres on a slab of 10 mm, modelled as an elastic layer bonded to a rigid base.

The paper gives no modulus, so only force over E* (mm²) and ratios are shown, for three Poisson's ratios.
"""
import numpy as np

import results
from body import curve, press, respond, square
from setting import LARGE, LIVER, SMALL, SPEED, contact_tool

DEPTH = 5.0                        # mm: half the slab
POISSON = (0.5, 0.49, 0.45)
SAMPLES = 64                       # for the tables; the session uses eight
TABLE1_HALF_SPACE = np.sqrt(6.35 / 1.6)


def make(folder, quick):
    depths = np.array([0.5, 1, 2, 3, 4, 5]) if quick else np.linspace(0.1, DEPTH, 50)
    columns = {name: [] for name in ("nu", "delta_mm")}
    names = [(tool, table1) for tool in (LARGE, SMALL) for table1 in (False, True)]
    for tool, table1 in names:
        columns[column(tool, table1)] = []
        columns[column(tool, table1, "over_half_space")] = []
    columns["ratio"], columns["ratio_table1"] = [], []
    for nu in POISSON:
        columns["nu"] += [nu] * len(depths)
        columns["delta_mm"] += list(depths)
        for tool, table1 in names:
            specification = tool.table1 if table1 else tool.specification
            layer = respond(square(), specification, DEPTH, 1.0, nu, LIVER, samples=SAMPLES)
            forces = curve(layer, 4, depths)
            kernel = contact_tool(specification)
            columns[column(tool, table1)] += list(forces)
            columns[column(tool, table1, "over_half_space")] += [
                f / kernel.GetForce(d, 1.0) for f, d in zip(forces, depths)]
    for name, table1 in (("ratio", False), ("ratio_table1", True)):
        columns[name] = list(np.array(columns[column(LARGE, table1)]) / columns[column(SMALL, table1)])
    half_space = [contact_tool(LARGE.specification).GetForce(d, 1.0) /
                  contact_tool(SMALL.specification).GetForce(d, 1.0) for d in depths]
    results.write_table(folder / "figure7_liver_slab.csv", columns)
    for i, nu in enumerate(POISSON):
        last = (i + 1) * len(depths) - 1
        print("  nu = {}: ratio of the spheres' forces at {:g} mm {:.3f} by Table 1, {:.3f} exact".format(
            nu, depths[-1], columns["ratio_table1"][last], columns["ratio"][last]))
    print("  on a half-space {:.3f} by Table 1, {:.3f} exact".format(
        TABLE1_HALF_SPACE, half_space[-1]))
    moves = {tool: press(respond(square(), tool.specification, DEPTH, 1.0, POISSON[0], LIVER), DEPTH, 0.5)
             for tool in (LARGE, SMALL)}
    write_moves(folder, moves)
    draw(folder, columns, depths, half_space, moves)


def column(tool, table1, what="force_over_modulus_mm2"):
    return "{}{}_{}".format(tool.key, "_table1" if table1 else "", what)


def write_moves(folder, moves):
    """Writes every 50th tick, 20 per second. Both tools have the same trajectory."""
    time, displacement, _ = moves[LARGE]
    table = {"time_s": time[::50], "displacement_mm": displacement[::50]}
    for tool, (_, _, force) in moves.items():
        table[column(tool, False)] = force[::50]
    results.write_table(folder / "figure7_trajectory.csv", table)


def draw(folder, columns, depths, half_space, moves):
    figure, panels = results.picture(3, 13.0)
    if figure is None:
        return
    time, displacement, _ = moves[LARGE]
    panels[0].plot(time, displacement, color="black")
    panels[0].axhline(0, color="black", linewidth=0.8)
    panels[0].set(xlabel="time, s", ylabel="displacement into the body, mm",
                  title="Trajectory at {:g} mm/s, both spheres".format(SPEED))
    first = slice(0, len(depths))
    for tool in (LARGE, SMALL):
        kernel = contact_tool(tool.specification)
        panels[1].plot(depths, columns[column(tool, False)][first], color=tool.colour,
                       label=tool.name + ", layer")
        panels[1].plot(depths, [kernel.GetForce(d, 1.0) for d in depths], ":", color=tool.colour,
                       label=tool.name + ", half-space")
    panels[1].set(xlabel="deflection $\\delta$, mm", ylabel="force over modulus F/E*, mm²", xlim=(0, 5),
                  ylim=(0, None), title="10 mm layer, bonded, $\\nu$ = 0.5 (computed)")
    for i, (nu, dash, colour) in enumerate(zip(POISSON, ("-", "--", "-."), ("#0072B2", "#D55E00", "#009E73"))):
        part = slice(i * len(depths), (i + 1) * len(depths))
        panels[2].plot(depths, columns["ratio"][part], dash, color=colour, label="layer, $\\nu$ = {}".format(nu))
    panels[2].plot(depths, half_space, color="black", label="half-space")
    panels[2].plot(depths, columns["ratio_table1"][first], ":", color="#0072B2",
                   label="layer, $\\nu$ = 0.5, both by Table 1")
    panels[2].plot(depths, np.full(len(depths), TABLE1_HALF_SPACE), ":", color="black",
                   label="half-space, both by Table 1")
    panels[2].axvline(1.6, ymax=0.4, color="0.5", linewidth=0.8)
    panels[2].text(1.65, 1.83, "deeper than the small radius", fontsize=8, color="0.3")
    panels[2].set(xlabel="deflection $\\delta$, mm", ylabel="force, 12.7 mm sphere over 3.2 mm sphere",
                  xlim=(0, 5), ylim=(1.75, 5.4), title="Ratio of the two spheres' forces")
    for panel in panels[1:]:
        panel.legend(loc="upper left")
    results.save(figure, folder / "figure7_liver_slab.png")
