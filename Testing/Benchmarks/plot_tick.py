#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws tick.csv: time per call over the number of triangles, hot and cold.

    plot_tick.py TICK.CSV PICTURE.PNG

A line is the median. The bar above the line ends at p99, which may be outside the frame.
Exit code 77 without matplotlib.
"""
import csv
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    pyplot = None

# Colours by Okabe and Ito, which most readers can distinguish; the markers repeat the distinction.
STYLE = {
    "palpate-tick": ("Palpate, whole tick", "#d55e00", "o", "-"),
    "palpate-point": ("Palpate, contact point", "#e69f00", "s", "-"),
    "palpate-onset-point": ("Palpate, contact onset", "#cc79a7", "^", "-"),
    "palpate-onset-tick": ("Palpate, whole tick of an onset", "#aa4499", "h", "-"),
    "palpate-tick-servo": ("Palpate, tick of a servo loop", "#999999", "P", "--"),
    "palpate-tick-1-law": ("Palpate, whole tick, one law", "#332288", "*", "-"),
    "palpate-tick-4-laws": ("Palpate, whole tick, four laws", "#117733", "X", "-"),
    "palpate-tick-50-tips": ("Palpate, 50 tips in a tick", "#000000", "D", ":"),
    "palpate-tick-shuffled": ("Palpate, whole tick, shuffled input", "#882255", "x", ""),
    "embree-point": ("Embree point query, warm radius", "#56b4e9", "v", "--"),
    "cgal-point": ("CGAL AABB tree, last point as hint", "#0072b2", "<", "--"),
    "vtk-static-point": ("vtkStaticCellLocator", "#009e73", ">", "--"),
}


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def panel(axes, rows, cache):
    for method, (label, colour, marker, line) in STYLE.items():
        own = sorted((row for row in rows if row["method"] == method and row["cache"] == cache),
                     key=lambda row: int(row["triangles"]))
        if not own:
            continue
        triangles = [int(row["triangles"]) for row in own]
        median = [float(row["median_ns"]) for row in own]
        above = [max(0.0, float(row["p99_ns"]) - m) for row, m in zip(own, median)]
        axes.errorbar(triangles, median, yerr=([0.0] * len(own), above), linestyle=line, color=colour, marker=marker,
                      label=label, markersize=9 if marker == "x" else 5, elinewidth=0.8, capsize=2)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("triangles of the body")
    axes.set_title("hot: tick after tick" if cache == "hot" else "cold: caches flushed before each tick")
    axes.grid(True, which="major", color="0.85")
    axes.grid(True, which="minor", axis="y", color="0.94")
    axes.set_axisbelow(True)


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 2
    if pyplot is None:
        print("plot_tick: no picture, matplotlib is not installed (python3-matplotlib)", file=sys.stderr)
        return 77
    rows = read(arguments[0])
    figure, (hot, cold) = pyplot.subplots(1, 2, figsize=(11, 6.2), sharey=True)
    panel(hot, rows, "hot")
    panel(cold, rows, "cold")
    hot.set_ylim(top=5.0 * max(float(row["median_ns"]) for row in rows))
    hot.set_ylabel("time per tick, ns (line: median; bar: to p99)")
    figure.suptitle("Tip 1 mm deep, 0.1 mm per tick along a bumpy sphere of 100 mm; one core")
    handles, labels = hot.get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=3, frameon=False)
    figure.tight_layout(rect=(0, 0.13, 1, 1))
    figure.savefig(arguments[1], dpi=120)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
