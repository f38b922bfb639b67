# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the stability study: stability.png (parts a and b, and the table of verdicts), details.png (the other
parts), and relaxing.png (bodies that relax)."""
import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

import theory    # noqa: E402
import verdicts  # noqa: E402

BLUE, ORANGE, GREEN, RED, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "0.45"
SHADES = {verdicts.SURVIVES: "#cdebd9", verdicts.BOUNDED: "#fdf0c4", verdicts.FAILS: "#f6cfc4"}
FORMS = {"Paper": ORANGE, "NormalizedDirection": BLUE, "EnergyConsistent": GREEN}


def select(rows, **wanted):
    return [row for row in rows if all(row[name] == value for name, value in wanted.items())]


def column(rows, name):
    return [row[name] for row in rows]


def rates_axis(axes, rates):
    axes.set_xscale("log")
    axes.set_xticks(rates)
    axes.set_xticklabels([f"{rate / 1000:g}" for rate in rates])
    axes.minorticks_off()
    axes.set_xlabel("rate, kHz")


def limits(axes, rows):
    rates = sorted({row["rate_Hz"] for row in rows})
    cases = (({"delay_ticks": 0.0, "hand_Ns_per_m": 5.0}, GREEN, "s", "no delay, in a hand (300 N/m, 5 N s/m)"),
             ({"delay_ticks": 0.0, "hand_N_per_m": 0.0}, BLUE, "o", "no delay"),
             ({"delay_ticks": 1.0, "hand_N_per_m": 0.0}, ORANGE, "v", "1 tick late"),
             ({"delay_ticks": 2.0, "hand_N_per_m": 0.0}, RED, "^", "2 ticks late"))
    for wanted, colour, mark, label in cases:
        mine = select(rows, damping_Ns_per_m=1.0, **wanted)
        axes.plot(column(mine, "rate_Hz"), [row["exact_N_per_m"] / 1000 for row in mine], color=colour, lw=1)
        axes.plot(column(mine, "rate_Hz"), [row["limit_N_per_m"] / 1000 for row in mine], mark, color=colour, ms=6,
                  fillstyle="none", label=label)
    axes.plot([], [], color=GREY, lw=1, label="exact theory")
    axes.set_yscale("log")
    rates_axis(axes, rates)
    axes.set_ylabel("largest stable stiffness, N/mm")
    axes.set_title("a  Stiffness: 0.1 kg, 1 N s/m", loc="left")
    axes.legend(fontsize=7.5, frameon=False)


def force_limits(axes, rows):
    modulus = max(row["modulus_MPa"] for row in rows)
    models = list(dict.fromkeys(row["model"] for row in rows))
    least = 2e-3
    for rate, colour, shift in ((1000.0, BLUE, -0.2), (4000.0, ORANGE, 0.2)):
        held = select(rows, modulus_MPa=modulus, rate_Hz=rate, evaluated="stored", start="held")
        places = [models.index(row["model"]) + shift for row in held]
        axes.barh(places, [max(row["limit_N"], least) for row in held], 0.38, color=colour, alpha=0.75,
                  label=f"no control, {rate / 1000:g} kHz")
        known = [(place, row["exact_force_N"]) for place, row in zip(places, held) if row["exact_force_N"] != ""]
        axes.plot([max(force, least) for _, force in known], [place for place, _ in known], "|", color="k", ms=9,
                  label="2E*a = exact limit" if rate == 1000.0 else None)
        for control, size in (("passivity", 4), ("chain", 9)):
            mine = select(rows, modulus_MPa=modulus, rate_Hz=rate, control=control)
            axes.plot([max(row["limit_N"], least) for row in mine],
                      [models.index(row["model"]) + shift for row in mine], "o", color=GREEN, ms=size, fillstyle="none",
                      label=f"{control}" if rate == 1000.0 else None)
    axes.set_xscale("log")
    axes.set_xlim(least, 20)
    axes.set_yticks(range(len(models)))
    axes.set_yticklabels(models)
    axes.invert_yaxis()
    axes.set_xlabel("largest push without buzz, N (up to 10; 0 at the left end)")
    axes.set_title(f"b  Force: E* = {modulus:g} MPa", loc="left")
    axes.legend(fontsize=7.5, frameon=False, ncol=3, loc="upper center", bbox_to_anchor=(0.4, -0.14))


def table(axes, cells, group):
    methods, failures, found = verdicts.grid(cells, group)
    axes.set_axis_off()
    text = [["–" if found.get((m, f)) is None else verdicts.words(found[m, f]) for f in failures] for m in methods]
    shades = [["white" if found.get((m, f)) is None else SHADES[found[m, f]["verdict"]] for f in failures]
              for m in methods]
    wrapped = [failure.replace(": ", ":\n").replace(", ", ",\n") for failure in failures]
    made = axes.table(cellText=text, cellColours=shades, rowLabels=methods, colLabels=wrapped, loc="center",
                      cellLoc="center", bbox=[0.17, 0.0, 0.83, 1.0])
    made.auto_set_font_size(False)
    made.set_fontsize(8)
    for (row, _), box in made.get_celld().items():
        box.set_edgecolor("0.8")
        if row == 0:
            box.set_height(box.get_height() * 1.7)


def main_picture(tables, cells, path):
    counts = [len(verdicts.grid(cells, group)[0]) for group in ("rendering", "friction", "geometry")]
    figure = pyplot.figure(figsize=(11, 12), layout="constrained")
    grid = figure.add_gridspec(4, 2, height_ratios=[9] + [count + 2 for count in counts])
    limits(figure.add_subplot(grid[0, 0]), tables["limits"])
    force_limits(figure.add_subplot(grid[0, 1]), tables["press"])
    for row, group in enumerate(("rendering", "friction", "geometry"), 1):
        axes = figure.add_subplot(grid[row, :])
        table(axes, cells, group)
        if row == 1:
            axes.set_title("f  Who survives what, at 1 kHz:  green survives, yellow bounded, red fails", loc="left")
    figure.savefig(path, dpi=100, metadata={"Software": None}, pil_kwargs={"optimize": True})
    pyplot.close(figure)


def encoders(axes, rows):
    rows = [row for row in rows if row["coulomb_N"] > 0]
    for rate, colour in ((1000.0, BLUE), (4000.0, ORANGE)):
        mine = select(rows, rate_Hz=rate)
        ended = [row for row in mine if row["restful_N_per_m"] < 0.9 * row["friction_N_per_m"]]
        found = [row for row in mine if row not in ended]
        axes.loglog(column(found, "friction_N_per_m"), column(found, "restful_N_per_m"), "o", color=colour,
                    fillstyle="none", label=f"{rate / 1000:g} kHz")
        axes.loglog(column(ended, "friction_N_per_m"), column(ended, "restful_N_per_m"), "^", color=colour,
                    label="and more (search ends)")
        axes.axhline(theory.passive_limit(1.0, 1 / rate), color=colour, lw=1, ls="--")
    ends = [5e2, 2e5]
    axes.loglog(ends, ends, color=GREY, lw=1, label="$2f_c/\\Delta$")
    axes.set_xlabel("$2f_c/\\Delta$, N/m   (dashed: 2b/T)")
    axes.set_ylabel("stiffness up to which it comes to rest, N/m")
    axes.set_title("a  Encoder step, Coulomb friction", loc="left")
    axes.legend(fontsize=8, frameon=False)


def cylinder(axes, rows):
    rates = sorted({row["rate_Hz"] for row in rows})
    colours = dict(zip(dict.fromkeys(row["tool"] for row in rows), (BLUE, ORANGE, GREEN, RED)))
    for tool, colour in colours.items():
        for damping, mark in ((0.0, "o"), (5.0, "s")):
            mine = select(rows, tool=tool, hand_Ns_per_m=damping)
            axes.loglog(column(mine, "rate_Hz"), column(mine, "exact_modulus_MPa"), color=colour, lw=1,
                        ls="-" if damping == 0 else "--")
            axes.loglog(column(mine, "rate_Hz"), column(mine, "modulus_MPa"), mark, color=colour, fillstyle="none",
                        label=tool if damping == 0 else None)
    axes.axhline(3.45, color=GREY, lw=1, ls=":", label="the paper's rubber")
    rates_axis(axes, rates)
    axes.set_ylabel("stiffest body free of oscillation, E*, MPa")
    axes.set_title("b  Cylinder, 5 N (dashed: hand damps 5 N s/m)", loc="left")
    axes.legend(fontsize=8, frameon=False)


def leak(axes, rows):
    bare = select(rows, control="none")
    for delay, colour, mark in ((0.0, BLUE, "o"), (1.0, ORANGE, "v")):
        mine = select(bare, delay_ticks=delay)
        axes.loglog(column(mine, "expected_mJ"), column(mine, "leaked_mJ"), mark, color=colour, fillstyle="none", ms=5,
                    label=f"{delay:g} ticks late")
    ends = [min(column(bare, "expected_mJ")), max(column(bare, "expected_mJ"))]
    axes.loglog(ends, ends, color=GREY, lw=1, label="$F v (T + 2 t_d)$")
    axes.set_xlabel("$F_{max}\\,v\\,(T + 2t_d)$, mJ")
    axes.set_ylabel("energy got out per press, mJ")
    axes.set_title("c  Leak of the hold", loc="left")
    axes.legend(fontsize=8, frameon=False)


def friction(axes, rows):
    models = list(dict.fromkeys(row["model"] for row in rows))
    rates = sorted({row["rate_Hz"] for row in rows})
    for model, colour, mark in zip(models, (BLUE, ORANGE, GREEN, RED, "#CC79A7", "k"), "osv^Dx"):
        mine = select(rows, model=model, what="drift_mm")
        axes.loglog(column(mine, "rate_Hz"), [max(abs(row["value"]), 1e-7) for row in mine], mark + "-", color=colour,
                    lw=1, ms=5, fillstyle="none", label=model)
    rates_axis(axes, rates)
    axes.set_ylabel("drift in 8 s, mm (below 1e-7: there)")
    axes.set_title("d  Friction under 0.5 ± 0.2 N of 1 N", loc="left")
    axes.legend(fontsize=7.5, frameon=False, ncol=2)


def edges(axes, rows):
    angles = sorted({float(row["body"].split()[1].rstrip("°")) for row in rows if row["body"].startswith("edge")})
    for form, colour in FORMS.items():
        for surface, style in (("Facets", "o-"), ("Smooth", "s--")):
            mine = [select(rows, body=f"edge {angle:g}°", form=form, surface=surface, edges="dropped")[0]
                    for angle in angles]
            axes.plot(angles, column(mine, "force_jump"), style, color=colour, lw=1, ms=4, fillstyle="none",
                      label=f"{surface}, {form}")
    felt = [max(column(select(rows, body=f"edge {angle:g}°", edges="felt"), "force_jump")) for angle in angles]
    axes.plot(angles, felt, "k^-", lw=1.5, ms=5, label="edges felt: the largest of all six")
    mine = [select(rows, body=f"edge {angle:g}°")[0] for angle in angles]
    axes.plot(angles, column(mine, "nearest_force_jump"), color=GREY, lw=1, ls=":", label="nearest point, 2 cos(ω/2)")
    axes.set_xticks(angles)
    axes.set_xlabel("interior angle of the edge, degrees")
    axes.set_ylabel("force jump |ΔF|/F")
    axes.set_title("e  Convex edges, 1 mm deep", loc="left")
    axes.legend(fontsize=7, frameon=False)


def meshes(axes, rows):
    for form, colour in FORMS.items():
        for surface, style in (("Facets", "o-"), ("Smooth", "s--")):
            mine = select(rows, body="sphere, varied", form=form, surface=surface, edges="dropped")
            axes.loglog(column(mine, "edge_mm"), [max(row["loop_gain"], 1e-8) for row in mine], style, color=colour, lw=1,
                        ms=4, fillstyle="none", label=f"{surface}, {form}")
    edges_mm = sorted({row["edge_mm"] for row in rows if row["body"] == "sphere"})
    axes.set_xticks(edges_mm)
    axes.set_xticklabels([f"{edge:.1f}" for edge in edges_mm])
    axes.minorticks_off()
    axes.set_xlabel("longest edge, mm (sphere of 20 mm)")
    axes.set_ylabel("largest loop energy over force times way")
    axes.set_title("e  Responses that differ, coarse meshes", loc="left")
    axes.legend(fontsize=7, frameon=False, loc="lower left", bbox_to_anchor=(0.0, 0.08))


def details(tables, path):
    figure, axes = pyplot.subplots(2, 3, figsize=(13, 8), layout="constrained")
    for place, (make, part) in zip(axes.flat, ((encoders, "encoder"), (cylinder, "cylinder"), (leak, "leak"),
                                               (friction, "friction"), (edges, "geometry"), (meshes, "geometry"))):
        make(place, tables[part])
    figure.savefig(path, dpi=90, metadata={"Software": None}, pil_kwargs={"optimize": True})
    pyplot.close(figure)


def relaxing_limits(axes, rows):
    materials = [row["material"] for row in select(rows, rate_Hz=1000.0, delay_ticks=0.0, elements=16.0)
                 if " " not in row["material"]]
    taus = [10 ** (-3 + 0.1 * i) for i in range(41)]
    for delay, colour, mark in ((0.0, BLUE, "o"), (1.0, ORANGE, "v")):
        label = "no delay" if delay == 0 else "1 tick late"
        exact = [theory.relaxing_limit(f"1:{tau:.6g}", theory.MASS, 1.0, 1e-3, delay) / 1000 for tau in taus]
        axes.loglog(taus, exact, color=colour, lw=1)
        axes.axhline(theory.exact_limit(theory.MASS, 1.0, 1e-3, delay) / 1000, color=colour, lw=1, ls=":")
        for elements, size in ((16.0, 9), (0.0, 4.5)):
            mine = [select(rows, rate_Hz=1000.0, delay_ticks=delay, elements=elements, material=each)[0] for each in materials]
            axes.plot([theory.branches_of(row["material"])[0][1] for row in mine],
                      [row["limit_N_per_m"] / 1000 for row in mine], mark, color=colour, ms=size, fillstyle="none",
                      label=f"{label}, {verdicts.ELEMENTS[elements]}")
    axes.loglog(taus, [theory.passive_relaxing(f"1:{tau:.6g}", 1.0, 1e-3) / 1000 for tau in taus], color=GREEN, lw=1.5,
                label="passive, whatever the hand")
    axes.plot([], [], color=GREY, lw=1, label="exact theory")
    axes.plot([], [], color=GREY, lw=1, ls=":", label="elastic")
    axes.set_xlabel("τ, s (p = 1)")
    axes.set_ylabel("largest stable slow stiffness, N/mm")
    axes.set_title("A spring that relaxes: 0.1 kg, 1 N s/m, 1 kHz", loc="left")
    axes.legend(fontsize=8, frameon=False)


def relaxing_paths(axes, rows):
    paths = list(dict.fromkeys(row["path"] for row in rows))
    for shift, (form, elements, colour, fill) in zip((-0.3, -0.1, 0.1, 0.3), (
            ("EnergyConsistent", 16.0, GREEN, 0.8), ("EnergyConsistent", 0.0, GREEN, 0.35),
            ("NormalizedDirection", 16.0, BLUE, 0.8), ("NormalizedDirection", 0.0, BLUE, 0.35))):
        mine = [select(rows, path=path, form=form, elements=elements)[0] for path in paths]
        axes.barh([i + shift for i in range(len(paths))], [100 * row["loop_gain"] for row in mine], 0.19, color=colour,
                  alpha=fill, label=f"{form}, {verdicts.ELEMENTS[elements]}")
    axes.axvline(0, color="k", lw=0.8)
    axes.set_yticks(range(len(paths)))
    axes.set_yticklabels(paths)
    axes.invert_yaxis()
    axes.set_xlabel("energy got out over force times way, % (left: taken)")
    axes.set_title("Closed paths over a body that differs", loc="left")
    axes.legend(fontsize=8, frameon=False, loc="upper center", bbox_to_anchor=(0.4, -0.13), ncol=2)


def relaxing_picture(tables, path):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12, 5.2), layout="constrained")
    relaxing_limits(left, tables["relaxing"])
    relaxing_paths(right, tables["relaxing-paths"])
    figure.savefig(path, dpi=90, metadata={"Software": None}, pil_kwargs={"optimize": True})
    pyplot.close(figure)


def draw(tables, cells, output):
    pyplot.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.axisbelow": True})
    main_picture(tables, cells, output / "stability.png")
    details(tables, output / "details.png")
    relaxing_picture(tables, output / "relaxing.png")
