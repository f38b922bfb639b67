# SPDX-License-Identifier: BSD-3-Clause
"""Figures 6 to 8 with finite strain: its effect on the fit below 12 N, on the slab, and on the force of 14 N.

The laws of small strain are multiplied by c = F_finite/F_small from a solver (solved.py): Neo-Hooke near ν = ½, and
materials that stiffen (Ogden, Demiray). The results are compared with the response that Palpate stores with StrainModel.
"""
import numpy as np

import results
import sliding
import solved
from body import curve, respond, square
from friction import MU, softness
from setting import (FLAT, LARGE, LARGEST_FORCE, LIVER, RUBBER, SLIDING_FORCE, SMALL, TOOLS, contact_tool,
                     half_space_depth, root)

SPHERES = (LARGE, SMALL)
LAWS = {"neohooke": ("neohooke", 0.0), "demiray 0.5": ("demiray", 0.5), "demiray 2": ("demiray", 2.0),
        "ogden 9": ("ogden", 9.0), "ogden -5": ("ogden", -5.0)}
RUBBER_NU = 0.495
LIVER_NU = (0.45, 0.48, 0.49, 0.495)
LIVER_DEPTHS = np.array([0.5, 1.0, 1.6, 2.0, 3.0, 4.0, 5.0])
STYLES = {"neohooke": "-", "demiray 0.5": "--", "demiray 2": "-.", "ogden 9": ":", "ogden -5": (0, (1, 3))}


def half_space_factor(curves, tool, nu, law):
    """Returns c of a tool of the paper on a half-space, or None if there is no solution."""
    unit = contact_tool("flat:1" if tool is FLAT else "sphere:1")
    radius = contact_tool(tool.specification).GetRadius()
    if tool is FLAT:
        pressed, small = (curves.get(("flat:1", 0.0, nu, *each, 0.1)) for each in (LAWS[law], solved.LINEAR))
        if pressed is None or small is None:
            return None
        # Both forces are for a rim with a fillet, so that the ratio does not contain the effect of the fillet.
        return solved.Factor(pressed, lambda d: np.interp(d, small[:, 0], small[:, 1]), radius)
    rows = curves.get(("sphere:1", 0.0, nu, *LAWS[law], 0.1))
    return None if rows is None else solved.Factor(rows, lambda d: unit.GetForce(d, 1.0), radius)


def make(folder, quick):
    curves = solved.read()
    rubber(folder, curves)
    liver(folder, curves)
    slide(folder, curves)


def rubber(folder, curves):
    """Figure 6: half-space, E* = 3.45 MPa."""
    depths = np.linspace(0.05, 2.15, 43)
    table = {"delta_mm": depths}
    numbers = {name: [] for name in (
        "tool", "law", "nu", "delta_12N_mm", "a_12N_mm", "delta_table1_12N_mm", "F_there_N", "modulus_3N_MPa",
        "modulus_12N_MPa", "storage_error")}
    for tool in TOOLS:
        exact, table1 = contact_tool(tool.specification), contact_tool(tool.table1)
        at_12 = half_space_depth(table1, LARGEST_FORCE)
        for law, nu in [("small strain", 0.5)] + [(law, nu) for law in LAWS for nu in (RUBBER_NU, 0.4995)]:
            factor = (lambda d: np.ones_like(np.asarray(d, dtype=float))) if law == "small strain" else \
                half_space_factor(curves, tool, nu, law)
            if factor is None:
                continue

            def force(d):
                return float(factor(d)) * exact.GetForce(d, RUBBER)

            table["F_{}_{}_{:g}_N".format(tool.key, law.replace(" ", ""), nu)] = [force(d) for d in depths]
            deepest = getattr(factor, "deepest", 3.0)
            depth = root(lambda d: force(d) - LARGEST_FORCE, 0.0, deepest) if force(deepest) > LARGEST_FORCE else np.nan
            shallow = half_space_depth(table1, 3.0)
            numbers["tool"].append(tool.key)
            numbers["law"].append(law)
            numbers["nu"].append(nu)
            numbers["delta_12N_mm"].append(depth)
            numbers["a_12N_mm"].append(exact.GetContactRadius(depth) if law == "small strain" or np.isnan(depth)
                                       else factor.contact_radius(depth))
            numbers["delta_table1_12N_mm"].append(at_12)
            numbers["F_there_N"].append(force(at_12))
            # The modulus for which the force of this law equals the force of Table 1 with 3.45 MPa.
            numbers["modulus_3N_MPa"].append(RUBBER * 3.0 / force(shallow))
            numbers["modulus_12N_MPa"].append(RUBBER * LARGEST_FORCE / force(at_12))
            numbers["storage_error"].append(stored_error(tool, force) if (law, nu) == ("neohooke", RUBBER_NU) else np.nan)
    results.write_table(folder / "figure6_finite.csv", table)
    results.write_table(folder / "figure6_finite_at_12N.csv", numbers)
    for i, law in enumerate(numbers["law"]):
        print("  {} {} nu {}: 12 N at {:.3f} mm; {:.2f} N where Table 1 has 12; E* that gives Table 1's: {:.2f} (3 N), "
              "{:.2f} MPa (12 N)".format(numbers["tool"][i], law, numbers["nu"][i], numbers["delta_12N_mm"][i],
                                         numbers["F_there_N"][i], numbers["modulus_3N_MPa"][i],
                                         numbers["modulus_12N_MPa"][i]))
    draw_rubber(folder, table)
    return numbers


def stored_error(tool, force):
    """Returns the largest relative difference of Palpate's stored response (StrainModel NeoHooke) from the solver's force."""
    radius = contact_tool(tool.specification).GetRadius()
    deepest = min(half_space_depth(contact_tool(tool.specification), LARGEST_FORCE), radius * (0.7 if tool is FLAT else 1))
    stored = respond(square(), tool.specification, deepest, RUBBER, RUBBER_NU, strain="neohooke")
    depths = np.linspace(0.1, 1.0, 19) * deepest
    return np.max(np.abs(curve(stored, 4, depths) / [force(d) for d in depths] - 1))


def draw_rubber(folder, table):
    figure, panels = results.picture(2, 12.0)
    if figure is None:
        return
    depths = table["delta_mm"]
    for tool in TOOLS:
        table1 = contact_tool(tool.table1)
        first = np.array([table1.GetForce(d, RUBBER) for d in depths])
        panels[0].plot(depths, np.where(first < 13, first, np.nan), ":", color=tool.colour,
                       label=tool.name + ", " + ("2$R$E*$\\delta$" if tool is FLAT else "Table 1"))
        for law, nu, dash in (("neohooke", RUBBER_NU, "-"),):
            name = "F_{}_{}_{:g}_N".format(tool.key, law, nu)
            forces = np.array(table[name])
            panels[0].plot(depths, np.where(forces < 13, forces, np.nan), dash, color=tool.colour,
                           label="the same, Neo-Hooke, $\\nu$ = {}".format(nu))
            panels[1].plot(depths, np.where(first < 12.6, 100 * (forces / first - 1), np.nan), dash, color=tool.colour,
                           label=tool.name + ", Neo-Hooke")
    small = contact_tool(SMALL.table1)
    first = np.array([small.GetForce(d, RUBBER) for d in depths])
    for law, colour in (("demiray 0.5", "#CC79A7"), ("demiray 2", "#56B4E9"), ("ogden -5", "#999999")):
        name = "F_{}_{}_{:g}_N".format(SMALL.key, law.replace(" ", ""), RUBBER_NU)
        if name in table:
            panels[1].plot(depths, np.where(first < 12.6, 100 * (np.array(table[name]) / first - 1), np.nan), "--",
                           color=colour, label="3.2 mm sphere, " + {
                               "demiray 0.5": "Demiray, b = 0.5", "demiray 2": "Demiray, b = 2",
                               "ogden -5": "Ogden, $\\alpha$ = -5"}[law])
    name = "F_{}_smallstrain_0.5_N".format(SMALL.key)
    panels[1].plot(depths, np.where(first < 12.6, 100 * (np.array(table[name]) / first - 1), np.nan), "-.", color="black",
                   label="3.2 mm sphere, exact sphere at small strain")
    panels[0].axhline(LARGEST_FORCE, color="black", linewidth=0.8)
    panels[0].set(xlabel="deflection $\\delta$, mm", ylabel="force F, N", xlim=(0, 2.15), ylim=(0, 13),
                  title="Half-space, E* = {:g} MPa (computed)".format(RUBBER))
    panels[0].legend(loc="lower right")
    panels[1].axhline(0, color="black", linewidth=1.0)
    panels[1].text(0.03, 0.5, "Table 1", fontsize=8)
    panels[1].set(xlabel="deflection $\\delta$, mm (to 12 N by Table 1)", ylabel="force over that of Table 1, %",
                  xlim=(0, 1.7), ylim=(-33, 18), title="How far from Table 1 at the same modulus")
    panels[1].legend(loc="lower left", fontsize=7)
    results.save(figure, folder / "figure6_finite.png")


def liver(folder, curves):
    """Figure 7: the bonded slab, for several Poisson's ratios and materials."""
    table = {name: [] for name in ("tool", "law", "nu", "delta_mm", "force_over_modulus_mm2", "c")}
    small = {}
    for tool in SPHERES:
        for nu in LIVER_NU:
            layer = respond(square(), tool.specification, 5.0, 1.0, nu, LIVER, samples=64)
            small[tool, nu] = lambda d, layer=layer: float(curve(layer, 4, np.array([d]))[0])
            for law, (model, parameter) in LAWS.items():
                rows = curves.get((tool.specification, LIVER, nu, model, parameter, 0.1))
                if rows is None:
                    continue
                factor = solved.Factor(rows, small[tool, nu])
                for depth in LIVER_DEPTHS:
                    c = float(factor(depth))
                    if not np.isnan(c):
                        for name, value in zip(table, (tool.key, law, nu, depth, c * small[tool, nu](depth), c)):
                            table[name].append(value)
    results.write_table(folder / "figure7_finite.csv", table)
    ratios = {name: [] for name in ("law", "nu", "delta_mm", "ratio", "ratio_small_strain")}
    found = {key: force for *key, force in zip(table["tool"], table["law"], table["nu"], table["delta_mm"],
                                               table["force_over_modulus_mm2"]) for key in [tuple(key)]}
    for (tool, law, nu, depth), force in found.items():
        other = found.get((SMALL.key, law, nu, depth))
        if tool == LARGE.key and other is not None:
            for name, value in zip(ratios, (law, nu, depth, force / other,
                                            small[LARGE, nu](depth) / small[SMALL, nu](depth))):
                ratios[name].append(value)
            print("  slab, {}, nu {}, {} mm: ratio {:.3f} (small strain {:.3f})".format(
                law, nu, depth, ratios["ratio"][-1], ratios["ratio_small_strain"][-1]))
    results.write_table(folder / "figure7_finite_ratio.csv", ratios)
    draw_liver(folder, curves, small)


def draw_liver(folder, curves, small):
    figure, panels = results.picture(3, 14.0)
    if figure is None:
        return
    depths = np.linspace(0.25, 5.0, 39)
    for panel, tool in zip(panels, SPHERES):
        for nu, colour in zip(LIVER_NU, ("#009E73", "#E69F00", "#56B4E9", "#0072B2")):
            rows = curves.get((tool.specification, LIVER, nu, *solved.NEO, 0.1))
            if rows is not None:
                panel.plot(depths, 100 * (solved.Factor(rows, small[tool, nu])(depths) - 1), color=colour,
                           label="Neo-Hooke, $\\nu$ = {}".format(nu))
        panel.axhline(0, color="black", linewidth=0.8)
        panel.set(xlabel="deflection $\\delta$, mm", ylabel="force over that of small strain, %",
                  title="{}, 10 mm layer".format(tool.name), xlim=(0, 5))
        panel.legend(loc="best")
    nu = LIVER_NU[-1]
    for tool in SPHERES:
        for law, dash in STYLES.items():
            rows = curves.get((tool.specification, LIVER, nu, *LAWS[law], 0.1))
            if rows is not None:
                forces = solved.Factor(rows, small[tool, nu])(depths) * [small[tool, nu](d) for d in depths]
                panels[2].plot(depths, forces, color=tool.colour, linestyle=dash,
                               label="{}, {}".format(tool.name, law) if tool is LARGE else None)
        panels[2].plot(depths, [small[tool, nu](d) for d in depths], color="black", linewidth=0.8,
                       label="small strain" if tool is LARGE else None)
    panels[2].set_yscale("log")
    panels[2].text(3.1, 1.5, "3.2 mm sphere", fontsize=8, color=SMALL.colour)
    panels[2].set(xlabel="deflection $\\delta$, mm", ylabel="force over modulus F/E*, mm²", xlim=(0, 5),
                  title="Materials, $\\nu$ = {} (computed)".format(nu))
    panels[2].legend(loc="lower right", fontsize=7)
    results.save(figure, folder / "figure7_finite.png")


def slide(folder, curves):
    """Figure 8: the remaining difference between the pressed force and CalculiX's force, and the force of 14 N."""
    table = {name: [] for name in ("case", "nu", "depth_over_radius", "normal_calculix_N", "small_strain_over_calculix",
                                   "c", "finite_strain_over_calculix")}
    for case, nu in sliding.COMPUTED:
        radius, depth = sliding.CASES[case]
        rows = curves.get(("sphere:1", 0.0, nu, *solved.NEO, 0.1))
        exact, unit = contact_tool("sphere:{:g}".format(radius)), contact_tool("sphere:1")
        c = float(solved.Factor(rows, lambda d: unit.GetForce(d, 1.0), radius)(depth))
        pressed, small = sliding.computed(case, nu)["normal_N"][0], exact.GetForce(depth, RUBBER)
        for name, value in zip(table, (case, nu, depth / radius, pressed, small / pressed, c, c * small / pressed)):
            table[name].append(value)
        print("  {}, nu {}: CalculiX over small strain {:+.1%}, over finite strain {:+.1%}".format(
            case, nu, pressed / small - 1, pressed / (c * small) - 1))
    results.write_table(folder / "figure8_finite.csv", table)
    table = {name: [] for name in ("law", "nu", "depth_14N_mm", "depth_over_radius", "a_over_R", "slides_after_mm")}
    tool = contact_tool(SMALL.specification)
    for law, nu in (("small strain", 0.5), ("neohooke", 0.495), ("neohooke", 0.4995)):
        factor = None if law == "small strain" else half_space_factor(curves, SMALL, nu, law)
        c = factor or (lambda d: 1.0)
        depth = root(lambda d: float(c(d)) * tool.GetForce(d, RUBBER) - SLIDING_FORCE, 0.0, getattr(factor, "deepest", 3.0))
        a = factor.contact_radius(depth) if factor else tool.GetContactRadius(depth)
        for name, value in zip(table, (law, nu, depth, depth / 1.6, a / 1.6, MU * softness(nu) * depth)):
            table[name].append(value)
        print("  14 N, {}, nu {}: {:.3f} mm, a/R {:.3f}".format(law, nu, depth, a / 1.6))
    results.write_table(folder / "section4.4_finite.csv", table)
