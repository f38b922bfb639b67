# SPDX-License-Identifier: BSD-3-Clause
"""Reads the output of `palpateAccuracySpeed --relaxation`: methods to render a body that relaxes, compared with theory."""
import pictures
import rows as study

TEXTS = ("part", "path", "source", "tool", "material", "method")
FORCE_COLUMNS = ("part", "path", "source", "tool", "material", "method", "largest_force_N", "error", "hot_ns", "onset_ns",
                 "cold_ns")
# Colour and mark of each method.
METHODS = {
    "time left out": ("#999999", "v"),
    "quasi-linear, clamped": ("#d55e00", "X"),
    "quasi-linear, one-sided": ("#e69f00", "P"),
    "4 elements": ("#56b4e9", "s"),
    "8 elements": ("#0072b2", "s"),
    "16 elements": ("#0072b2", "o"),
    "32 elements": ("#0072b2", "D"),
    "exact: 256 elements": ("#000000", "h"),
}
TOOLS = ("flat", "sphere", "cone")
FLOOR = 1e-5     # fraction of the largest force: rounding of float32 samples and of the digits of the tables


def read(text):
    return study.read(text, TEXTS)


def worst(rows, **wanted):
    """Returns the row of the largest error on any path."""
    return max(study.select(rows, part="force", **wanted), key=lambda row: row["error"])


def time_of(rows, method):
    """Returns the row of the times of a method, or None. Only the sphere is timed: a tick of another tool takes as long."""
    found = study.select(rows, part="time", method=method)
    return found[0] if found else None


def percent(value):
    return "{:.2g} %".format(100 * value) if value >= FLOOR else "< 0.001 %"


def tables(rows):
    """Returns the results as Markdown tables."""
    paths = study.distinct(study.select(rows, part="force"), "path")
    lines = ["**In time**: largest error of the force on any path, of the path's largest force; median tick along stop and "
             "go of a sphere, three branches", "",
             "| method | flat | sphere | cone | worst path | tick: hot / onset / cold |", "|---|---|---|---|---|---|"]
    for method in METHODS:
        each = [worst(rows, method=method, tool=tool) for tool in TOOLS]
        at = max(each, key=lambda row: row["error"])
        time = time_of(rows, method)
        lines.append("| {} | {} | {}, {} | {} |".format(
            method, " | ".join(percent(row["error"]) for row in each), at["path"], at["tool"],
            "" if time is None else "{:.0f} / {:.0f} / {:.0f} ns".format(time["hot_ns"], time["onset_ns"], time["cold_ns"])))
    lines += ["", "By path, the larger of sphere and cone:", "", "| method | " + " | ".join(paths) + " |",
              "|---" * (len(paths) + 1) + "|"]
    for method in METHODS:
        lines.append("| {} | {} |".format(method, " | ".join(
            percent(max(worst(rows, method=method, path=path, tool=tool)["error"] for tool in TOOLS[1:]))
            for path in paths)))
    return "\n".join(lines) + "\n"


def curves(rows):
    """Returns (columns, rows) of the forces over time, with a column for each method."""
    mine = study.select(rows, part="curve")
    methods = study.distinct(mine, "method")
    wide = {}
    for row in mine:
        at = wide.setdefault(row["time_s"], {"time_s": row["time_s"], "exact_N": row["true_force_N"]})
        at[row["method"] + "_N"] = row["force_N"]
    return ["time_s", "exact_N"] + [method + "_N" for method in methods], list(wide.values())


def draw_errors(panel, rows):
    for tool, line in zip(TOOLS[1:], ("-", "--")):
        points = {method: (time_of(rows, method)["hot_ns"], max(worst(rows, method=method, tool=tool)["error"], FLOOR))
                  for method in METHODS}
        chain = [points["{} elements".format(count)] for count in (4, 8, 16, 32)]
        panel.plot(*zip(*chain), color="#0072b2", linewidth=0.9, linestyle=line, zorder=1)
        for method, (colour, mark) in METHODS.items():
            panel.scatter(*points[method], color=colour if tool == "sphere" else "white", edgecolors=colour, marker=mark, s=46,
                          linewidths=1.2, zorder=2)
            if tool == "cone" and method.endswith("elements") and not method.startswith("exact"):
                panel.annotate(method.split()[0], points[method], xytext=(6, 4), textcoords="offset points", fontsize=8)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.axhline(0.1, color="0.4", linestyle="--", linewidth=1)
    panel.text(0.98, 0.11, "10 %: just noticeable", transform=panel.get_yaxis_transform(), ha="right", va="bottom", fontsize=8,
               color="0.3")
    panel.set_xticks([100, 200, 300, 500, 1000])
    panel.set_xticklabels(["100", "200", "300", "500", "1000"])
    panel.minorticks_off()
    panel.set_xlabel("median time per tick, three branches, ns")
    panel.set_ylabel("largest error on any path, of its largest force")
    panel.set_title("filled: sphere, hollow: cone")


def draw_curves(panel, rows):
    shown = {"quasi-linear, clamped": "-", "quasi-linear, one-sided": "-", "16 elements": "--"}
    mine = study.select(rows, part="curve")
    exact = study.select(mine, method="16 elements")
    panel.plot([row["time_s"] for row in exact], [row["true_force_N"] for row in exact], color="0.75", linewidth=5,
               label="exact")
    for method, line in shown.items():
        points = study.select(mine, method=method)
        panel.plot([row["time_s"] for row in points], [row["force_N"] for row in points], line, color=METHODS[method][0],
                   linewidth=1.4, label=method)
    slow = study.select(mine, method="time left out")
    panel.plot([row["time_s"] for row in slow], [row["force_N"] for row in slow], ":", color="0.4", linewidth=1.2,
               label="time left out")
    panel.set_xlabel("time, s")
    panel.set_ylabel("force, N")
    panel.set_title("two presses of a sphere, to 1 and 0.6 mm: p = 4, τ = 0.05 s")
    panel.legend(frameon=False)


def draw(rows, file):
    pyplot = pictures.pyplot_or_none()
    if pyplot is None or not study.select(rows, part="time"):
        return False
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12.5, 5.2))
    draw_errors(left, rows)
    draw_curves(right, rows)
    handles = [left.scatter([], [], color=colour, marker=mark, s=46, label=method)
               for method, (colour, mark) in METHODS.items()]
    figure.legend(handles=handles, loc="lower center", ncol=4, frameon=False)
    figure.tight_layout(rect=(0, 0.1, 1, 1))
    pictures.save(pyplot, figure, file)
    return True
