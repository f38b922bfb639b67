# SPDX-License-Identifier: BSD-3-Clause
"""Charts of the study of accuracy against speed."""
import math

import rows as study

# Name of a family of methods, colour, mark, prefixes of the names of its methods.
FAMILIES = (
    ("point springs", "#999999", "v", ("one spring", "point spring")),
    ("penetrating vertices", "#d55e00", "X", ("penetrating",)),
    ("fixed-traction patch", "#e69f00", "P", ("fixed-traction",)),
    ("law at run time", "#009e73", "D", ("Table 1", "exact law")),
    ("stored, linear", "#56b4e9", "s", ("linear",)),
    ("stored, Hermite", "#0072b2", "o", ("Hermite",)),
    ("reduced basis", "#cc79a7", "*", ("reduced",)),
    ("finite elements", "#000000", "h", ("",)),
)
FULL = "full finite elements (offline)"
LONGEST = 1e11  # ns, end of the time axis
CHAINS = (["linear 3", "linear 5", "linear 8", "linear 16"], ["Hermite 3", "Hermite 5", "Hermite 8", "Hermite 16"],
          ["penetrating vertices, fine", "penetrating vertices, medium", "penetrating vertices, coarse"])
FLOOR = study.ROUNDING


def family(method):
    return next(each for each in FAMILIES if method.startswith(each[3]))


def area(row):
    return 14 + 26 * math.log10(1 + row["model_bytes_per_vertex"])


def shown_error(row):
    return max(row["error"], FLOOR)


def draw_scene(panel, rows, scene):
    mine = [row for row in rows if row["method"] != study.REFERENCE and row["hot_ns"] and row["error"] is not None]
    by_name = {row["method"]: row for row in mine}
    for chain in CHAINS:
        linked = [by_name[name] for name in chain if name in by_name]
        if linked:
            panel.plot([r["hot_ns"] for r in linked], [shown_error(r) for r in linked], linewidth=0.7,
                       color=family(chain[0])[1], zorder=2)
    for row in mine:
        _, colour, mark, _ = family(row["method"])
        y = shown_error(row)
        panel.plot([row["hot_ns"], row["cold_ns"]], [y, y], color=colour, linewidth=0.5, alpha=0.35, zorder=1)
        panel.scatter([row["cold_ns"]], [y], s=9, facecolors="none", edgecolors=colour, linewidths=0.7, marker=mark,
                      alpha=0.7, zorder=2)
        panel.scatter([row["hot_ns"]], [y], s=area(row), color=colour, marker=mark, linewidths=0.5, edgecolors="white",
                      zorder=3)
        if row["method"] == FULL:
            panel.annotate("full solution per tip", (row["hot_ns"], y), xytext=(-10, 0), textcoords="offset points",
                           fontsize=7, ha="right", va="center", color="0.2")
    best = study.front(mine)
    panel.step([r["hot_ns"] for r in best] + [LONGEST], [shown_error(r) for r in best] + [shown_error(best[-1])],
               where="post", color="#cc0000", linewidth=1.3, zorder=2.5)
    panel.axvline(1e6, color="0.4", linestyle="--", linewidth=1)
    panel.axhline(0.1, color="0.4", linestyle="--", linewidth=1)
    panel.axhspan(FLOOR / 3, FLOOR * 1.6, color="0.92", zorder=0)
    truth = [row for row in rows if row["method"] == study.REFERENCE][0]["error_calculix"]
    if truth:
        panel.axhline(truth, color="#7a5195", linestyle=":", linewidth=1.2)
        panel.text(0.8 * LONGEST, truth * 1.12, "reference against CalculiX", ha="right", va="bottom", fontsize=7, color="#7a5195")
    names = "\n".join("{} {}".format(i + 1, row["method"]) for i, row in enumerate(best))
    for i, row in enumerate(best):
        panel.annotate(str(i + 1), (row["hot_ns"], shown_error(row)), xytext=(-9, -9), textcoords="offset points",
                       fontsize=8, color="#cc0000", fontweight="bold")
    panel.text(0.985, 0.13, "Pareto front\n" + names, transform=panel.transAxes, ha="right", va="bottom", fontsize=7,
               color="#cc0000", bbox={"facecolor": "white", "alpha": 0.85, "edgecolor": "none", "pad": 2}, zorder=5)
    panel.set_title(scene)
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.set_xlim(10, LONGEST)
    panel.set_ylim(FLOOR / 2, 10)


def pyplot_or_none():
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        return None
    pyplot.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.25, "axes.axisbelow": True,
                            "legend.fontsize": 7.5, "axes.titlesize": 10})
    return pyplot


def save(pyplot, figure, file):
    figure.savefig(file, dpi=85, metadata={"Software": None}, pil_kwargs={"optimize": True})
    pyplot.close(figure)


def draw_methods(rows, file):
    pyplot = pyplot_or_none()
    pooled = study.select(rows, tool=study.ALL)
    scenes = study.distinct(pooled, "scene")
    if pyplot is None or not any(row["hot_ns"] for row in pooled):
        return False
    figure, panels = pyplot.subplots(2, (len(scenes) + 1) // 2, figsize=(12.5, 9.2), sharex=True, sharey=True,
                                     squeeze=False)
    for panel in panels.ravel()[len(scenes):]:
        panel.axis("off")
    for panel, scene in zip(panels.ravel(), scenes):
        draw_scene(panel, study.select(pooled, scene=scene), scene)
    for panel in panels[-1]:
        panel.set_xlabel("median time per tick, ns")
    for panel in panels[:, 0]:
        panel.set_ylabel("relative RMS error of the force")
    first = panels[0, 0]
    first.text(1.3e6, 6.5, "1 ms", fontsize=8, color="0.3", va="top")
    first.text(0.8 * LONGEST, 0.105, "10 %: just noticeable", fontsize=8, color="0.3", ha="right", va="bottom")
    first.text(0.8 * LONGEST, FLOOR * 0.72, "rounding", fontsize=7, color="0.4", ha="right", va="center")
    handles = [first.scatter([], [], s=45, color=colour, marker=mark, label=name) for name, colour, mark, _ in FAMILIES]
    handles.append(first.scatter([], [], s=9, facecolors="none", edgecolors="0.3", label="caches flushed"))
    for size in (0, 4, 80, 10000, 1000000):
        handles.append(first.scatter([], [], s=area({"model_bytes_per_vertex": size}), color="0.6",
                                     label="{} B per vertex beside the mesh".format(size)))
    figure.legend(handles=handles, loc="lower center", ncol=5, frameon=False)
    figure.tight_layout(rect=(0, 0.075, 1, 1))
    save(pyplot, figure, file)
    return True


def draw_convergence(rows, file):
    pyplot = pyplot_or_none()
    if pyplot is None:
        return False
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(12.5, 4.9))
    mesh = study.select(rows, part="mesh")
    colours = {"ball": "#0072b2", "uneven layer": "#009e73", "head": "#cc79a7"}
    styles = {"Hermite, facets": ("o", "-", "facets"), "Hermite, smooth surface": ("s", "--", "smooth surface"),
              "penetrating vertices": ("X", ":", "penetrating vertices")}
    for body in study.distinct(mesh, "scene"):
        for method in study.distinct(study.select(mesh, scene=body), "method"):
            mine = study.select(mesh, scene=body, method=method)
            found = mine[0]["order"]
            mark, line, short = styles[method]
            left.loglog([p["size"] for p in mine], [p["error"] for p in mine], color=colours[body], marker=mark,
                        linestyle=line, markersize=5, linewidth=1.2, label="{}: {}{}".format(
                            body, short, "" if found is None else ", order {:.1f}".format(found)))
    left.loglog([1, 8], [2e-3, 2e-3 * 64], color="0.5", linewidth=0.8, label="order 2")
    left.set_xlabel("mean edge of the mesh, mm")
    left.set_ylabel("relative RMS error of the force")
    left.set_xticks([0.5, 1, 2, 4, 8])
    left.set_xticklabels(["0.5", "1", "2", "4", "8"])
    left.minorticks_off()
    left.set_title("sphere of 6.35 mm, 16 samples")
    left.set_ylim(bottom=5e-5)
    left.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    samples = study.select(rows, part="samples")
    tools = study.distinct(samples, "scene")
    kinds = {"linear": "-", "Hermite, float16": ":", "Hermite, float32": "--", "Hermite, float64": "-"}
    marks = {"linear": "s", "Hermite, float16": "v", "Hermite, float32": "o", "Hermite, float64": "."}
    palette = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")
    for tool, colour in zip(tools, palette):
        for method, line in kinds.items():
            mine = study.select(samples, scene=tool, method=method)
            right.loglog([p["size"] for p in mine], [max(p["error"], 1e-10) for p in mine], color=colour, linestyle=line,
                         marker=marks[method], markersize=4, linewidth=1)
        right.plot([], [], color=colour, label=tool.split(", ")[1] + (" mm" if "cone" not in tool else "°"))
    for method, line in kinds.items():
        right.plot([], [], color="0.4", linestyle=line, marker=marks[method], markersize=4, label=method)
    right.set_xlabel("samples of the curve")
    right.set_xticks([3, 4, 5, 6, 8, 12, 16, 24, 32])
    right.set_xticklabels(["3", "4", "5", "6", "8", "12", "16", "24", "32"])
    right.minorticks_off()
    right.set_title(tools[0].split(", ")[0])
    right.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    figure.tight_layout()
    save(pyplot, figure, file)
    return True
