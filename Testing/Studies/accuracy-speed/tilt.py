# SPDX-License-Identifier: BSD-3-Clause
"""Reads the output of `palpateAccuracySpeed --tilt`: methods to render a tilted tool, compared with boundary elements."""
import pictures
import rows as study

TEXTS = ("part", "tool", "method", "source")
COLUMNS = ("part", "tool", "method", "source", "tilt_deg", "depth_mm", "true_force_mm2", "force_mm2", "error", "hot_ns",
           "onset_ns", "cold_ns")
OTHER = "tilt_bem.csv"                  # table of the other code; all other forces are solved by this study
TIP, DEEPEST, TABLE, CIRCLES, ELEMENTS = ("upright, tip as deep", "upright, deepest point as deep", "table in the tick",
                                          "circles", "boundary elements, 64")
# Colour and mark of each method.
METHODS = {TIP: ("#999999", "v"), DEEPEST: ("#d55e00", "X"), CIRCLES: ("#e69f00", "P"), TABLE: ("#0072b2", "o"),
           ELEMENTS: ("#000000", "h")}
TICKS = ("tick without an axis", "tick, upright", "tick, leaning")
ONE_LAW = ", 1 law"
TOOLS = {"flat:1": "flat end, radius 1 mm", "truncated:1,45": "truncated cone, 1 mm, 45°", "cone:60": "cone, 60°",
         "sphere:1": "sphere, 1 mm"}
SHOWN_DEPTH = 0.2                       # mm, depth of the lines; the band shows all depths
FLOOR = 1e-5                            # error of the boundary elements for smooth tools


def read(text):
    return study.read(text, TEXTS)


def worst(rows, least=0.0, **wanted):
    """Returns the row of the largest error at depths of at least `least` mm."""
    found = [row for row in study.select(rows, part="force", **wanted) if row["depth_mm"] >= least]
    return max(found, key=lambda row: abs(row["error"]))


def time_of(rows, method):
    """Returns the row of the times of a method, or None. Both upright methods have the times of a tick without an axis."""
    tick = {TIP: TICKS[0], DEEPEST: TICKS[0], TABLE: TICKS[2]}
    found = study.select(rows, part="time", method=tick[method] + ONE_LAW if method in tick else method)
    return found[0] if found else None


def duration(nanoseconds):
    for unit, size in (("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= size:
            return "{:.2g} {}".format(nanoseconds / size, unit)
    return "{:.0f} ns".format(nanoseconds)


def percent(value):
    if abs(value) < FLOOR:
        return "< 0.001 %"
    return "{:+.0f} %".format(100 * value) if abs(value) >= 0.1 else "{:+.2g} %".format(100 * value)


def tables(rows):
    """Returns the results as Markdown tables."""
    tools = [tool for tool in TOOLS if study.select(rows, tool=tool, part="force")]
    lines = ["**Leaning**: largest error of the force, 2.5 to 25°, deepest point 0.05 to 1 mm deep; in brackets from 0.2 mm on; "
             "median tick of the flat end at 10°", "",
             "| method | " + " | ".join(tools) + " | tick: hot / onset / cold |", "|---" * (len(tools) + 2) + "|"]
    for method in METHODS:
        cells = ["{} ({})".format(percent(worst(rows, method=method, tool=tool)["error"]),
                                  percent(worst(rows, 0.2, method=method, tool=tool)["error"])) for tool in tools]
        time = time_of(rows, method)
        cells.append("" if time is None else " / ".join(duration(time[name]) for name in ("hot_ns", "onset_ns", "cold_ns")))
        lines.append("| {} | {} |".format(method, " | ".join(cells)))
    ticks = [row for row in study.select(rows, part="time") if row["method"].startswith(TICKS)]
    if ticks:
        lines += ["", "One law of all points, and several with weights of each, of a layer 4 to 12 mm thick:", "",
                  "| tick | hot | onset | cold |", "|---|---|---|---|"]
        lines += ["| {} | {} |".format(row["method"], " | ".join(
            duration(row[name]) for name in ("hot_ns", "onset_ns", "cold_ns"))) for row in ticks]
    return "\n".join(lines) + "\n"


def draw_tool(panel, rows, tool):
    mine = [row for row in study.select(rows, part="force", tool=tool) if row["source"] != OTHER]
    depths = study.distinct(mine, "depth_mm")
    shown = SHOWN_DEPTH if SHOWN_DEPTH in depths else depths[0]
    for method, (colour, mark) in METHODS.items():
        by_tilt = {}
        for row in study.select(mine, method=method):
            by_tilt.setdefault(row["tilt_deg"], {})[row["depth_mm"]] = max(abs(row["error"]), FLOOR)
        tilts = sorted(by_tilt)
        if len(depths) > 1 and method in (DEEPEST, CIRCLES, TABLE):
            panel.fill_between(tilts, [min(by_tilt[tilt].values()) for tilt in tilts],
                               [max(by_tilt[tilt].values()) for tilt in tilts], color=colour, alpha=0.15, linewidth=0)
        panel.plot(tilts, [by_tilt[tilt][shown] for tilt in tilts], color=colour, marker=mark, markersize=5, linewidth=1.2)
    panel.axhline(0.1, color="0.4", linestyle="--", linewidth=1)
    panel.set_yscale("log")
    panel.set_ylim(0.7 * FLOOR, 20)
    panel.set_xlim(0, 26)
    panel.set_title(TOOLS[tool] + ("; any depth" if tool == "cone:60" else ""), fontsize=10)


def draw(rows, file):
    pyplot = pictures.pyplot_or_none()
    if pyplot is None or not study.select(rows, part="time"):
        return False
    figure, panels = pyplot.subplots(2, 2, figsize=(11, 8.4), sharex=True, sharey=True)
    for panel, tool in zip(panels.flat, TOOLS):
        draw_tool(panel, rows, tool)
    for panel in panels[1]:
        panel.set_xlabel("tilt of the axis, degrees")
    for panel in panels[:, 0]:
        panel.set_ylabel("error of the force, relative")
    panels[0, 0].text(0.99, 0.11, "10 %: just noticeable", transform=panels[0, 0].get_yaxis_transform(), ha="right",
                      va="bottom", fontsize=8, color="0.3")
    handles = [panels[0, 0].plot([], [], color=colour, marker=mark, label="{}: {} a tick".format(
        method, duration(time_of(rows, method)["hot_ns"])))[0] for method, (colour, mark) in METHODS.items()]
    figure.legend(handles=handles, loc="lower center", ncol=3, frameon=False,
                  title="line: deepest point 0.2 mm deep; band: 0.05 to 1 mm. Times: flat end, 10°, hot")
    figure.tight_layout(rect=(0, 0.09, 1, 1))
    pictures.save(pyplot, figure, file)
    return True
