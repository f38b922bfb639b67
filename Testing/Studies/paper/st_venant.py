# SPDX-License-Identifier: BSD-3-Clause
"""Figure 1: the displacements of three tools of equal force, at a distance from the contact.

St. Venant's principle on a half-space: the displacement u_z(r) of the surface under each tool, divided by that
of a point force, F/(πE*r), tends to 1, and the displacements of the tools at one place become equal.
"""
import numpy as np

import results
from setting import RUBBER, TOOLS, contact_tool, half_space_depth, root

FORCE = 5.0            # N; the paper's figure states no force
POISSON = 0.5          # u_z does not depend on it at a given E*
AGREEMENT = (0.01, 0.001)


def make(folder, quick):
    distance = np.geomspace(1.001, 30.0, 30 if quick else 120)          # r/a
    table = {"r_over_a": distance}
    radii, under, agree = {}, {}, {"tool": [], "contact_radius_mm": []}
    agree.update({"within_%g" % share: [] for share in AGREEMENT})
    for tool in TOOLS:
        kernel = contact_tool(tool.specification)
        depth = half_space_depth(kernel, FORCE)
        a = radii[tool] = kernel.GetContactRadius(depth)

        def over_point_force(r, kernel=kernel, depth=depth):
            u = [0.0, 0.0]
            kernel.GetSurfaceDisplacement(r, depth, POISSON, u)
            return u[1] * np.pi * RUBBER * r / FORCE
        under[tool] = over_point_force
        table[tool.key] = [over_point_force(x * a) for x in distance]
        agree["tool"].append(tool.key)
        agree["contact_radius_mm"].append(a)
        for share in AGREEMENT:
            agree["within_%g" % share].append(root(lambda x: 1 + share - over_point_force(x * a), 1.001, 100))
    widest = max(radii.values())
    between = {"r_mm": distance * widest, "r_over_widest_a": distance}
    for tool in TOOLS:
        between["uz_%s_mm" % tool.key] = [under[tool](r) * FORCE / (np.pi * RUBBER * r)
                                          for r in distance * widest]
    results.write_table(folder / "figure1_st_venant.csv", table)
    results.write_table(folder / "figure1_between_tools.csv", between)

    def apart(r):
        forces = [under[tool](r) for tool in TOOLS]
        return max(forces) / min(forces) - 1
    agree["tool"].append("any to any")
    agree["contact_radius_mm"].append(widest)
    for share in AGREEMENT:
        agree["within_%g" % share].append(root(lambda x: share - apart(x * widest), 1.001, 100))
    between["apart"] = [apart(r) for r in distance * widest]
    results.write_table(folder / "figure1_agreement.csv", agree)
    for i, tool in enumerate(TOOLS):
        print("  {}: a = {:.4f} mm, within 1 % of a point force from r/a = {:.3f}, 0.1 % from {:.3f}".format(
            tool.key, radii[tool], agree["within_0.01"][i], agree["within_0.001"][i]))
    print("  any of the three to any other within 1 % from {:.3f} contact radii of the widest, {:.2f} mm".format(
        agree["within_0.01"][-1], agree["within_0.01"][-1] * widest))
    draw(folder, table, between, agree)


def draw(folder, table, between, agree):
    figure, panels = results.picture(2)
    if figure is None:
        return
    for i, tool in enumerate(TOOLS):
        panels[0].semilogx(table["r_over_a"], table[tool.key], tool.dash, color=tool.colour, label=tool.name)
        panels[0].plot(agree["within_0.01"][i], 1.01, "o", color=tool.colour, fillstyle="none")
        panels[1].loglog(table["r_over_a"], 100 * (np.array(table[tool.key]) - 1), tool.dash,
                         color=tool.colour, label=tool.name + ", over a point force")
    panels[0].axhline(1, color="black", linewidth=0.8)
    panels[0].plot([], [], "o", color="0.3", fillstyle="none", label="within 1 % from here on")
    panels[0].set(xlabel="distance over contact radius, r/a", ylabel="displacement over that of a point force",
                  title="Tools of equal force ({:g} N) beside a point force".format(FORCE))
    panels[1].loglog(between["r_over_widest_a"], 100 * np.array(between["apart"]), ":", color="black",
                     label="largest over smallest of the three")
    panels[1].axhline(1, color="black", linewidth=0.8)
    panels[1].set(xlabel="distance over contact radius, r/a (black: a of the widest)", ylabel="difference, %",
                  title="The same difference, logarithmic")
    ticks = [1, 2, 3, 4, 6, 10, 20, 30]
    for panel in panels:
        panel.set_xticks(ticks, [str(t) for t in ticks])
        panel.set_xticks([], minor=True)
        panel.set_xlim(1, 30)
        panel.legend()
    results.save(figure, folder / "figure1_st_venant.png")
