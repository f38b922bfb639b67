# SPDX-License-Identifier: BSD-3-Clause
"""Figures 5 to 7 on a material that relaxes: the size of the loops between loading and unloading.

The paper gives no time except the speed, 1 mm/s. **The branches are assumed**: rubber p = 0.05, 0.05 with τ = 0.1, 3 s;
liver p = 0.5, 0.5 with τ = 0.5, 10 s, an order of magnitude (Data/Reference/rate/presets.csv). The tool is pressed and
lifted without a rest, tick by tick at 1 kHz, with 32 elements. Loss: the area of the loop over the work of loading.
"""
import numpy as np

import results
from body import add_array, curve, press_and_lift, respond, square
from setting import (LARGE, LARGEST_FORCE, LIVER, RUBBER, SMALL, SPEED, TOOLS, contact_tool,
                     half_space_depth)

RUBBER_FLOWS = ((0.05, 0.1), (0.05, 3.0))
LIVER_FLOWS = ((0.5, 0.5), (0.5, 10.0))
POISSON = 0.5
PLATES = {"plate": 7.08 / RUBBER, "strip": 46.7 / RUBBER}    # C_g, mm/N; values of rubber_on_edges.py
EDGE_DEPTH = 3.0      # mm, as in rubber_on_edges.py
SLAB_DEPTH = 5.0      # mm, as in liver_slab.py
WEAK = 0.005          # strength for the curve over τ, so small that loss over p does not depend on p
COLUMNS = ("figure", "body", "tool", "law", "material", "speed_mm_s", "depth_mm", "loading_s", "peak_over_slow", "loss", "width",
           "lift_off")


def loop(body, depth, slow_force, speed=SPEED):
    """Returns (numbers, (depth, force)) of a press without a hold.

    Numbers: loading time (s), peak force over slow force, loss over the work of loading, width at half of the depth over
    peak force, depth at which the contact ends over largest depth."""
    _, depths, forces = press_and_lift(body, depth, 0.02 * depth, speed)
    top = int(np.argmax(depths))
    into, out = slice(0, top + 1), slice(top, None)
    loading = np.trapz(forces[into], depths[into])
    loss = (loading + np.trapz(forces[out], depths[out])) / loading
    half = 0.5 * depth
    width = np.interp(half, depths[into], forces[into]) - np.interp(half, depths[out][::-1], forces[out][::-1])
    left = depths[out][forces[out] > 0].min()
    numbers = (depth / speed, forces.max() / slow_force, loss, width / forces.max(), left / depth)
    return numbers, (depths, forces)


def specification(tool, table1):
    return tool.table1 if table1 else tool.specification


def rubber(tool, relaxations, table1=False):
    """Returns a half-space with a response up to a slow force of 12 N, and the depth of this force."""
    depth = half_space_depth(contact_tool(specification(tool, table1)), LARGEST_FORCE)
    return respond(square(), specification(tool, table1), depth, RUBBER, POISSON, relaxations=relaxations), depth


def on_edges(tool, compliance):
    body = square()
    add_array(body, "GlobalCompliance", np.full(body.GetNumberOfPoints(), compliance))
    return respond(body, tool.specification, EDGE_DEPTH, RUBBER, 0.45, compliance="GlobalCompliance", samples=32,
                   relaxations=RUBBER_FLOWS)


def slab(tool, table1):
    return respond(square(), specification(tool, table1), SLAB_DEPTH, 1.0, POISSON, LIVER, samples=32,
                   relaxations=LIVER_FLOWS)


def slow_force(body, depth):
    return float(curve(body, 4, np.array([depth]))[0])


def all_loops(speeds):
    """Returns rows of COLUMNS, and the curves of each figure: {(figure, body, tool): (depths, forces)}."""
    rows, curves = [], {}

    def add(figure, name, tool, table1, material, speed, body, depth):
        numbers, felt = loop(body, depth, slow_force(body, depth), speed)
        rows.append((figure, name, tool.key, "table1" if table1 else "exact", material, speed, depth) + numbers)
        if speed == SPEED and not table1:
            curves[figure, name, tool] = felt

    for name, compliance in PLATES.items():
        for tool in TOOLS:
            add("5", name, tool, False, "rubber", SPEED, on_edges(tool, compliance), EDGE_DEPTH)
    for tool in TOOLS:
        for table1 in (False, True):
            for speed in speeds[:2]:      # for rubber a press at 100 mm/s takes ten ticks
                body, depth = rubber(tool, RUBBER_FLOWS, table1)
                add("6", "half-space", tool, table1, "rubber", speed, body, depth)
    for tool in (LARGE, SMALL):
        for table1 in (False, True):
            for speed in speeds:
                add("7", "slab", tool, table1, "liver", speed, slab(tool, table1), SLAB_DEPTH)
    return rows, curves


def loss_over_strength(totals):
    """Returns a table of the loss in figure 6 over P: with two equal branches, τ = 0.1 and 3 s, and with one branch at the τ
    of the largest loss (t_m/τ = 2)."""
    table = {"P": totals}
    for tool in TOOLS:
        two, one = [], []
        for total in totals:
            body, depth = rubber(tool, [(0.5 * total, tau) for _, tau in RUBBER_FLOWS])
            two.append(loop(body, depth, LARGEST_FORCE)[0][2])
            body, depth = rubber(tool, [(total, 0.5 * depth / SPEED)])
            one.append(loop(body, depth, LARGEST_FORCE)[0][2])
        table["loss_%s_two_branches" % tool.key] = two
        table["loss_%s_one_branch" % tool.key] = one
    return table


def loss_over_time(ratios):
    """Returns a table of loss/p over t_m/τ in figure 6, with one weak branch."""
    table = {"loading_over_tau": ratios}
    for tool in TOOLS:
        found = []
        for ratio in ratios:
            depth = half_space_depth(contact_tool(tool.specification), LARGEST_FORCE)
            body, depth = rubber(tool, [(WEAK, depth / SPEED / ratio)])
            found.append(loop(body, depth, LARGEST_FORCE)[0][2] / WEAK)
        table["loss_over_p_%s" % tool.key] = found
    return table


def peak(ratios, losses):
    """Returns the maximum (t_m/τ, loss/p): that of the parabola through the largest value and its neighbours, over the
    logarithm of t_m/τ."""
    i = min(max(int(np.argmax(losses)), 1), len(losses) - 2)
    x = np.log(np.asarray(ratios[i - 1:i + 2]))
    a, b, c = np.polyfit(x, losses[i - 1:i + 2], 2)
    return float(np.exp(-b / (2 * a))), float(c - b * b / (4 * a))


def strength_of(totals, losses, loss):
    return float(np.interp(loss, losses, totals))


def make(folder, quick):
    rows, curves = all_loops((SPEED,) if quick else (SPEED, 10.0, 100.0))
    results.write_table(folder / "flowing_loops.csv", dict(zip(COLUMNS, map(list, zip(*rows)))))
    write_curves(folder, curves)
    totals = [0.01, 0.05, 0.1, 0.2] if quick else [0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5, 1.0]
    strengths = loss_over_strength(totals)
    results.write_table(folder / "flowing_strength.csv", strengths)
    ratios = np.array([1.2, 1.7, 2.4, 3.4]) if quick else np.geomspace(0.03, 100, 29)
    times = loss_over_time(ratios)
    results.write_table(folder / "flowing_time.csv", times)
    for row in rows:
        if row[5] == SPEED and row[3] == "exact":
            print("  figure {}, {}, {}: peak {:.3f} of the slow force, loss {:.2f} %, width {:.2f} %, lift-off at {:.3f}".format(
                *row[:3], row[8], 100 * row[9], 100 * row[10], row[11]))
    for tool in TOOLS:
        print("  {}: at most {:.3f} p, at t_m/τ = {:.2f}; a loss of 3 % needs P = {:.3f} in two branches".format(
            tool.key, *peak(ratios, times["loss_over_p_%s" % tool.key])[::-1],
            strength_of(totals, strengths["loss_%s_two_branches" % tool.key], 0.03)))
    draw(folder, curves, strengths, times)


def write_curves(folder, curves):
    """Writes every 100th tick of the curves."""
    columns = {"figure": [], "body": [], "tool": [], "displacement_mm": [], "force": []}
    for (figure, body, tool), (depths, forces) in curves.items():
        columns["figure"] += [figure] * len(depths[::100])
        columns["body"] += [body] * len(depths[::100])
        columns["tool"] += [tool.key] * len(depths[::100])
        columns["displacement_mm"] += list(depths[::100])
        columns["force"] += list(forces[::100])
    results.write_table(folder / "flowing_curves.csv", columns)


def draw(folder, curves, strengths, times):
    figure, panels = results.picture(3, 13.5, 2)
    if figure is None:
        return
    for panel, wanted, title, label in (
            (panels[0], ("5", "plate"), "Figure 5: plate on edges, rubber that flows", "force, N"),
            (panels[1], ("6", "half-space"), "Figure 6: half-space, rubber that flows", "force, N"),
            (panels[2], ("7", "slab"), "Figure 7: slab of 10 mm, liver that flows", "force over slow modulus F/E*, mm²")):
        for (number, body, tool), (depths, forces) in curves.items():
            if (number, body) == wanted:
                panel.plot(depths, forces, tool.dash, color=tool.colour, linewidth=1.2, label=tool.name)
        panel.set(xlabel="displacement, mm", ylabel=label, title=title, xlim=(0, None), ylim=(0, None))
        panel.legend(loc="upper left")
    for (number, body, tool), (depths, forces) in curves.items():
        if (number, body) == ("6", "half-space"):
            top = int(np.argmax(depths))
            grid = np.linspace(0.02, 0.98, 97) * depths.max()
            up = np.interp(grid, depths[:top + 1], forces[:top + 1])
            down = np.interp(grid, depths[top:][::-1], forces[top:][::-1])
            panels[3].plot(grid / depths.max(), 100 * (up - down) / forces.max(), tool.dash, color=tool.colour, label=tool.name)
    panels[3].set(xlabel="displacement over the largest", ylabel="loading less unloading, % of the peak",
                  title="Figure 6: width of the loops, p = 0.05, 0.05", xlim=(0, 1), ylim=(0, None))
    panels[3].legend(loc="lower center")
    for tool in TOOLS:
        panels[4].loglog(strengths["P"], 100 * np.array(strengths["loss_%s_two_branches" % tool.key]), tool.dash,
                         color=tool.colour, label=tool.name)
        panels[4].loglog(strengths["P"], 100 * np.array(strengths["loss_%s_one_branch" % tool.key]), ":", color=tool.colour)
        panels[5].semilogx(times["loading_over_tau"], times["loss_over_p_%s" % tool.key], tool.dash, color=tool.colour,
                           label=tool.name)
    panels[4].plot([], [], ":", color="0.4", label="one branch, $t_m/\\tau$ = 2")
    panels[4].axhspan(2, 5, color="0.9", zorder=0)
    panels[4].text(0.25, 2.15, "a few per cent", fontsize=8, color="0.3")
    panels[4].set(xlabel="P = $\\Sigma p_i$ ($\\tau$ = 0.1 and 3 s, like strengths)", ylabel="loss over the work of loading, %",
                  title="Which P makes which loop, at 1 mm/s")
    panels[4].legend(loc="upper left")
    panels[5].set(xlabel="time of loading over $\\tau$", ylabel="loss over p", ylim=(0, None),
                  title="One weak branch, p = {:g}".format(WEAK))
    panels[5].legend(loc="upper left")
    results.save(figure, folder / "flowing_loops.png")
