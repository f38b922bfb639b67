#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""From ten thousand to eight million vertices: growth of time, memory and errors with the size of a body.

    ./run study scale [--vertices N,N,...] [--quick] [--no-frames] [--output DIR]

Runs palpateScale (measure.cxx) once per size, each time in a separate process, and writes scale.csv (a row per size:
seconds, bytes per vertex, ns, relative errors), scale.md (a row per quantity: the slope of log(quantity) over
log(vertices) from 10^5 vertices on, the largest factor between a size and the fitted line, and the reason if the line is
bent or its slope not the expected one) and, with matplotlib, scale.png. Times depend on the machine; bytes and forces are
the same everywhere.
"""
import argparse
import collections
import csv
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
SIZES = (1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 8e6)
LARGE = 9e4     # smallest size that is used for the fit
STRAIGHT = 1.5  # a line is bent if a size deviates from it by a larger factor

# slope: the expected slope; reason: the reason for, or the range of, a different measured slope.
Line = collections.namedtuple("Line", "column panel label slope reason")
LINES = (
    Line("response_s", "time", "response, constants", 1, "below some 10^5 vertices starting threads and touching "
         "new pages take a fixed time; above, memory is filled at its own pace"),
    Line("layer_s", "time", "response, layer per vertex", 1, "the table of layers takes the same time at any size"),
    Line("choice_s", "time", "chooser on it", 1, "the laws come from up to 16 thousand vertices, and "
         "are then tried on all"),
    Line("kernel_s", "time", "the kernel's copy", 1, "a sort along a curve, links of neighbours, a search tree: "
         "n log n, and caches that do not hold it above 10^5"),
    Line("vtp_load_s", "time", "load .vtp", 1, "inflating and decoding, per byte"),
    Line("flat_load_s", "time", "load .palpate", 1, "mapped, and read once for the checksum; below 10^5 it lies in "
         "the caches"),
    Line("frame_s", "time", "a frame with the dent", 1, "a picture of 1024 x 768 costs what it costs (some 40 ms by "
         "software); vertices count beyond some 10^5"),
    Line("hot_ns", "tick", "tick, hot: median", 0, "triangles smaller than a step: from 10^6 vertices on nearly "
         "every tick enters a new one, whose lines come from farther memory"),
    Line("hot_p99_ns", "tick", "tick, hot: 99 %", 0, "more ticks wait for memory as triangles shrink"),
    Line("cold_ns", "tick", "tick, cold: median", 0, "six reads from memory and cold code, at any size"),
    Line("cold_p99_ns", "tick", "tick, cold: 99 %", 0, "what the machine does besides"),
    Line("array_bytes_per_vertex", "bytes", "response arrays", 0, ""),
    Line("record_bytes_per_vertex", "bytes", "record of a tick", 0, ""),
    Line("kernel_bytes_per_vertex", "bytes", "kernel's copy, resident", 0, "pages of 2 MiB: a small body fills its "
         "last one poorly"),
    Line("vtp_bytes_per_vertex", "bytes", ".vtp", 0, "compressed: finer meshes repeat themselves more"),
    Line("flat_bytes_per_vertex", "bytes", ".palpate", 0, ""),
    Line("peak_bytes_per_vertex", "bytes", "peak of the process", 0, "the program, its libraries and the picture weigh "
         "some 200 MB without a body"),
    Line("force_error", "error", "force 1 mm deep, off that of the smooth body", -1, "facets lie h²/8R inside: errors "
         "fall with the area of a triangle; below 3e-6 the kernel's float coordinates show"),
)


def measure(program, vertices, frames, quick=False, within=None):
    """Returns {name: number} for a body of about `vertices` vertices. Its files are temporarily in the folder `within`."""
    with tempfile.TemporaryDirectory(dir=within) as folder:
        command = [str(program), "--vertices", f"{vertices:.0f}", "--folder", folder]
        command += ["--frames"] if frames else []
        command += ["--quick"] if quick else []
        result = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return {name: float(value) for name, value in (line.split() for line in result.stdout.splitlines())}


def fit(rows, column):
    """Returns the slope of the line through log-log points, and the largest factor by which a point deviates from the line.

    The line is fitted to the sizes from LARGE on, if there are at least three. A fixed cost therefore appears as a
    deviation at the small end.
    """
    n, y = (np.log([row[name] for row in rows]) for name in ("vertices", column))
    large = n >= np.log(LARGE)
    large |= large.sum() < 3
    slope, offset = np.polyfit(n[large], y[large], 1)
    return slope, float(np.exp(abs(y - slope * n - offset).max()))


def table(rows):
    first, last = rows[0], rows[-1]
    lines = ["| line | {:.3g} vertices | {:.3g} vertices | slope | expected | farthest off | |".format(
        first["vertices"], last["vertices"]), "|---|---|---|---|---|---|---|"]
    for line in LINES:
        if line.column not in first or min(row[line.column] for row in rows) <= 0:
            continue
        slope, off = fit(rows, line.column)
        slope = round(slope, 2) + 0.0  # avoids -0.00
        bent = off > STRAIGHT or abs(slope - line.slope) > 0.15
        lines.append("| {} | {:.3g} | {:.3g} | {:.2f} | {} | ×{:.2f} | {} |".format(
            line.label + " (`" + line.column + "`)", first[line.column], last[line.column], slope, line.slope, off,
            line.reason if bent else "straight"))
    return "\n".join(lines) + "\n"


UNITS = {"time": ("time, s", 1.0), "tick": ("time per tick, µs", 1e-3), "bytes": ("bytes per vertex", 1.0),
         "error": ("relative error of the force", 1.0)}


def draw(rows, file):
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError:
        print("no matplotlib: no picture", file=sys.stderr)
        return
    colours = ("#000000", "#e69f00", "#56b4e9", "#009e73", "#d55e00", "#0072b2", "#cc79a7")
    figure, panels = pyplot.subplots(2, 2, figsize=(11, 8.6))
    n = [row["vertices"] for row in rows]
    for panel, (kind, (unit, factor)) in zip(panels.flat, UNITS.items()):
        mine = [line for line in LINES if line.panel == kind and line.column in rows[0]]
        for line, colour, marker in zip(mine, colours, "os^vD<>"):
            values = [factor * row[line.column] for row in rows]
            slope = round(fit(rows, line.column)[0], 2) + 0.0 if min(values) > 0 else float("nan")
            panel.plot(n, values, color=colour, marker=marker, markersize=4.5, linewidth=1.2,
                       label=f"{line.label} ({slope:.2f})")
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.set_xlabel("vertices")
        panel.set_ylabel(unit)
        panel.grid(True, which="major", color="#dddddd", linewidth=0.6)
        low, high = panel.get_ylim()
        panel.set_ylim(low, high * (high / low) ** (0.05 + 0.075 * len(mine)))
        panel.legend(frameon=False, fontsize=8.5, title="line (its slope)", title_fontsize=8.5,
                     loc="upper right" if kind == "error" else "upper left")
    figure.tight_layout()
    figure.savefig(file, dpi=110)


def write_csv(rows, file):
    with open(file, "w", encoding="utf-8", newline="") as out:
        writer = csv.DictWriter(out, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows({name: f"{value:.6g}" for name, value in row.items()} for row in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build" / "studies" / "scale")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "bin" / "palpateScale")
    parser.add_argument("--vertices", type=lambda text: [float(n) for n in text.split(",")], default=SIZES)
    parser.add_argument("--quick", action="store_true", help="each once, few ticks: poor times")
    parser.add_argument("--no-frames", action="store_true", help="no pictures are drawn and timed")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    rows = []
    for vertices in options.vertices:
        start = time.monotonic()
        rows.append(measure(options.program, vertices, not options.no_frames, options.quick,
                            within=options.output))
        print(f"{rows[-1]['vertices']:10.0f} vertices: {time.monotonic() - start:.0f} s", flush=True)
        write_csv(rows, options.output / "scale.csv")  # saves the finished rows, in case a larger size fails
    (options.output / "scale.md").write_text(table(rows), encoding="utf-8")
    print("\n" + table(rows))
    draw(rows, options.output / "scale.png")


if __name__ == "__main__":
    main()
