#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares force forms and contact surfaces: jumps, gained energy, error, time.

    ./run study continuity [--quick] [--output DIR] [--program FILE]

Runs palpateContinuity (measure.cxx) and writes continuity.csv, the results as tables with orders in
continuity.md, and with matplotlib continuity.png, to DIR (default build/studies/continuity). Times depend on
the machine; all other results are the same everywhere.
"""
import argparse
import csv
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
FORMS = ("Paper", "NormalizedDirection", "EnergyConsistent")
SURFACES = ("Facets", "Smooth")
# Column, title, floor. Values below the floor are rounding or quadrature error of the study; no order is computed.
MEASURES = (
    ("jump_equal", "force jump, equal responses", 1e-8),
    ("jump_differing", "force jump, differing responses", 1e-8),
    ("loop_equal", "loop energy, equal", 2e-6),
    ("loop_differing", "loop energy, differing", 2e-6),
    ("error_size", "error of the force", 3e-6),
    ("error_direction_rad", "error of its direction, rad", 1e-5),
)
# Expected effect of the facets with equal responses: h is the longest edge, R the smallest radius, d the depth. For the
# loop energy only the order is expected, because a loop crosses jumps of both signs.
EXPECTED = {
    "jump_equal": ("dh/R²", lambda h, r, d: d * h / r ** 2),
    "loop_equal": ("h²/(Rd)", lambda h, r, d: h * h / (r * d)),
    "error_size": ("1.5 h²/(6Rd)", lambda h, r, d: h * h / (4 * r * d)),
}
DEPTH = 1.0


def measure(program, is_quick):
    command = [str(program)] + (["--quick"] if is_quick else [])
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout


def read(text):
    rows = list(csv.DictReader(text.splitlines()))
    for row in rows:
        for name in row:
            if name not in ("body", "normals", "form", "surface"):
                row[name] = float(row[name])
    return rows


def select(rows, **wanted):
    """Returns the rows with these values, such as those of one body and form, from coarse to fine."""
    return [row for row in rows if all(row[name] == value for name, value in wanted.items())]


def order(rows, name, floor):
    """Returns the order over the whole range of sizes; None if a value is below the floor."""
    first, last = rows[0], rows[-1]
    if len(rows) < 2 or min(first[name], last[name]) < floor:
        return None
    return math.log(first[name] / last[name]) / math.log(first["edge_mm"] / last["edge_mm"])


def cell(rows, name, floor):
    values = ", ".join("%.1e" % row[name] if row[name] >= floor else "0" for row in rows)
    found = order(rows, name, floor)
    return values + ("" if found is None else " (%.1f)" % found)


def bodies(rows):
    seen = []
    for row in rows:
        if (row["body"], row["normals"]) not in seen:
            seen.append((row["body"], row["normals"]))
    return seen


def tables(rows):
    """Returns Markdown with a table per body. Each cell has the values from the coarse to the fine mesh, and the order."""
    lines = []
    for body, normals in bodies(rows):
        mine = select(rows, body=body, normals=normals)
        sizes = select(mine, form="Paper", surface="Facets")
        lines += ["", "**{}, {} normals**: mean edge {} mm, longest {} mm, smallest radius {:.1f} mm, {:.0f} mm deep".format(
            body, normals, ", ".join("%.2f" % row["edge_mm"] for row in sizes),
            ", ".join("%.2f" % row["longest_edge_mm"] for row in sizes), sizes[0]["smallest_radius_mm"], DEPTH), "",
            "| surface, form | " + " | ".join(title for _, title, _ in MEASURES) + " | tick, ns: equal / differing |",
            "|---" * (len(MEASURES) + 2) + "|"]
        for surface in SURFACES:
            for form in FORMS:
                case = select(mine, form=form, surface=surface)
                times = ", ".join("%.0f / %.0f" % (row["tick_equal_ns"], row["tick_differing_ns"]) for row in case)
                lines.append("| {}, {} | ".format(surface, form) + " | ".join(
                    cell(case, name, floor) for name, _, floor in MEASURES) + " | " + times + " |")
        expected = []
        for name, _, _ in MEASURES:
            if name in EXPECTED:
                formula, value = EXPECTED[name]
                expected.append(formula + ": " + ", ".join("%.1e" % value(
                    row["longest_edge_mm"], row["smallest_radius_mm"], DEPTH) for row in sizes))
            else:
                expected.append("")
        lines.append("| expected of facets | " + " | ".join(expected) + " | |")
    return "\n".join(lines[1:]) + "\n"


def draw(rows, path):
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        print("no matplotlib (python3-matplotlib): no picture", file=sys.stderr)
        return
    pyplot.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.axisbelow": True,
                            "legend.fontsize": 8, "axes.titlesize": 10, "lines.linewidth": 1.6})
    figure, panels = pyplot.subplots(2, 3, figsize=(12.5, 7.6))
    colours = dict(zip(FORMS, ("tab:orange", "tab:blue", "tab:green")))
    marks = {"Paper": "o", "NormalizedDirection": "x", "EnergyConsistent": "s"}
    mine = select(rows, body="sphere")
    shown = [MEASURES[i] for i in (0, 1, 4, 2, 3)]
    for panel, (name, title, floor) in zip(panels.ravel(), shown):
        for surface in SURFACES:
            for form in FORMS:
                case = select(mine, form=form, surface=surface)
                panel.loglog([row["longest_edge_mm"] for row in case], [max(row[name], 0.3 * floor) for row in case],
                             color=colours[form], marker=marks[form], fillstyle="none",
                             markersize=5 if surface == "Facets" else 8, linestyle="-" if surface == "Facets" else "--",
                             label="{}, {}".format(surface, form))
        if name in EXPECTED:
            formula, value = EXPECTED[name]
            sizes = [row["longest_edge_mm"] for row in case]
            panel.loglog(sizes, [value(h, case[0]["smallest_radius_mm"], DEPTH) for h in sizes], color="0.4",
                         linestyle=":", label="expected of facets, " + formula)
        panel.axhspan(panel.get_ylim()[0], floor, color="0.92", zorder=0)
        panel.set_title(title + (" (relative)" if "rad" not in title else ""))
        panel.set_xlabel("longest edge, mm")
        panel.set_xticks([row["longest_edge_mm"] for row in case])
        panel.set_xticklabels(["%.1f" % row["longest_edge_mm"] for row in case])
        panel.minorticks_off()
    panels[0, 0].legend(loc="center left", bbox_to_anchor=(0.0, 0.42))
    last = panels[1, 2]
    places = range(len(FORMS) * len(SURFACES))
    finest = [select(rows, body="bumpy", normals="exact", form=form, surface=surface)[-1]
              for surface in SURFACES for form in FORMS]
    last.barh([p - 0.2 for p in places], [row["tick_equal_ns"] for row in finest], 0.38, color="0.55", label="equal responses")
    last.barh([p + 0.2 for p in places], [row["tick_differing_ns"] for row in finest], 0.38, color="0.75", label="differing")
    last.set_yticks(list(places))
    last.set_yticklabels(["{}\n{}".format(row["surface"], row["form"]) for row in finest], fontsize=7)
    last.invert_yaxis()
    last.set_title("tick, ns, {:.0f} triangles".format(finest[0]["triangles"]))
    last.legend(loc="upper right")
    figure.suptitle("A sphere of 20 mm, tip {:.0f} mm deep: three meshes. Grey: rounding and quadrature".format(DEPTH), fontsize=10)
    figure.tight_layout()
    figure.savefig(path, dpi=80, metadata={"Software": None}, pil_kwargs={"optimize": True})
    pyplot.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build" / "studies" / "continuity")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "bin" / "palpateContinuity")
    parser.add_argument("--quick", action="store_true", help="one mesh of each body, short paths")
    arguments = parser.parse_args()
    if not arguments.program.exists():
        parser.error("there is no {}: was it left out of the build?".format(arguments.program))
    arguments.output.mkdir(parents=True, exist_ok=True)
    text = measure(arguments.program, arguments.quick)
    rows = read(text)
    (arguments.output / "continuity.csv").write_text(text, encoding="utf-8")
    (arguments.output / "continuity.md").write_text(tables(rows), encoding="utf-8")
    draw(rows, arguments.output / "continuity.png")
    print(tables(rows))
    print("results in {}".format(arguments.output))


if __name__ == "__main__":
    main()
