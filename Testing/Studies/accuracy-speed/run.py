#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares methods to render a contact: their error, time and size.

    ./run study accuracy-speed [--quick] [--output DIR] [--program FILE] [--scene NAME ...] [--only-strain]
                               [--only-shape] [--only-relaxation] [--only-tilt]

Runs palpateAccuracySpeed on the scenes (README.md) and writes to DIR (default build/studies/accuracy-speed)
accuracy-speed.csv (per scene, tool and method, and over all tools: errors, times, bytes, Pareto front),
convergence.csv (over mesh size and samples, with fitted orders), accuracy-speed.md (the results as tables), and with
matplotlib accuracy-speed.png and convergence.png. Further comparisons, each with its files (--only-...: this part alone):
- --only-strain: responses with curves at finite strain: finite-strain.csv, finite-strain.md, finite-strain.png
- --only-shape: an edge, a horn and a nodule, with the VTK filters: shape.csv, shape.md, shape.png
- --only-relaxation: bodies that relax, with exact theory: relaxation.csv, relaxation-curves.csv, relaxation.md,
  relaxation.png
- --only-tilt: tilted tools, with boundary elements: tilt.csv, tilt.md, tilt.png
Times depend on the machine; all other results are the same everywhere.
"""
import argparse
import csv
import os
import pathlib
import subprocess
import sys

import head
import pictures
import relaxation
import rows as study
import shape
import strain
import tilt

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "build" / "release" / "bin" / "palpateAccuracySpeed"
CURVES = ROOT / "Data" / "Studies" / "calculix"
DATA = ROOT / "Data"
METHOD_COLUMNS = ("scene", "tool", "method", "vertices", "edge_mm", "bytes_per_vertex", "model_bytes_per_vertex", "tips",
                  "unanswered", "error", "error_sites", "error_path", "noticed", "error_calculix", "hot_ns", "onset_ns",
                  "cold_ns", "pareto")
CONVERGENCE_COLUMNS = ("part", "scene", "method", "size", "error", "order")


def measure(program, options, heads=()):
    """Runs the program and returns its rows as text."""
    command = [str(program), "--curves", str(CURVES)] + list(options)
    for file in heads:
        command += ["--head", str(file)]
    # One thread, as in a tick; several BLAS threads would wait for each other on a busy machine.
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
    return subprocess.run(command, env=environment, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout


def judge(text):
    """Returns the rows of the methods, with rows for all tools together and the fronts, and the rows of convergence, with
    orders."""
    rows = study.read(text)
    methods = study.select(rows, part="methods")
    methods += study.pool(methods)
    study.mark_fronts(methods)
    convergence = [row for row in rows if row["part"] != "methods"]
    study.mark_orders(convergence)
    return methods, convergence


def write(file, rows, columns):
    def text(value):
        return "" if value is None else "{:.5g}".format(value) if isinstance(value, float) else value
    with open(file, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([[text(row[name]) for name in columns] for row in rows])


def duration(nanoseconds):
    if nanoseconds is None:
        return ""
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= size:
            return "{:.3g} {}".format(nanoseconds / size, unit)
    return "{:.3g} ns".format(nanoseconds)


def percent(value):
    return "" if value is None else "{:.2g} %".format(100 * value)


def tables(methods, convergence):
    """Returns the results as Markdown tables."""
    pooled = study.select(methods, tool=study.ALL)
    lines = []
    for scene in study.distinct(pooled, "scene"):
        lines += ["", "**{}**, all tools".format(scene), "",
                  "| method | error | sites / path | noticed | against CalculiX | hot / onset / cold | bytes per vertex "
                  "| front |", "|---|---|---|---|---|---|---|---|"]
        for row in study.select(pooled, scene=scene):
            lines.append("| {} | {} | {} / {} | {:.0f} % | {} | {} / {} / {} | {:.4g} | {} |".format(
                row["method"], percent(row["error"]), percent(row["error_sites"]), percent(row["error_path"]),
                100 * (row["noticed"] or 0), percent(row["error_calculix"]), duration(row["hot_ns"]),
                duration(row["onset_ns"]), duration(row["cold_ns"]), row["model_bytes_per_vertex"],
                "yes" if row["pareto"] else ""))
    lines += ["", "**Convergence**: error from the coarsest to the finest mesh, or the fewest to the most samples", "",
              "| over | body | method | sizes | error | order |", "|---|---|---|---|---|---|"]
    seen = set()
    for row in convergence:
        key = (row["part"], row["scene"], row["method"])
        if key not in seen:
            seen.add(key)
            mine = study.select(convergence, part=key[0], scene=key[1], method=key[2])
            lines.append("| {} | {} | {} | {} | {} | {} |".format(
                *key, ", ".join("{:.3g}".format(p["size"]) for p in mine),
                ", ".join("{:.1e}".format(p["error"]) for p in mine),
                "" if row["order"] is None else "{:.1f}".format(row["order"])))
    return "\n".join(lines[1:]) + "\n"


def report(text, folder):
    methods, convergence = judge(text)
    write(folder / "accuracy-speed.csv", methods, METHOD_COLUMNS)
    write(folder / "convergence.csv", convergence, CONVERGENCE_COLUMNS)
    (folder / "accuracy-speed.md").write_text(tables(methods, convergence), encoding="utf-8")
    for draw, rows, name in ((pictures.draw_methods, methods, "accuracy-speed.png"),
                             (pictures.draw_convergence, convergence, "convergence.png")):
        if not draw(rows, folder / name):
            print("no " + name + ": no matplotlib, or no times", file=sys.stderr)
    return methods, convergence


def report_strain(program, quick, folder):
    """Compares responses with curves at finite strain. Results of the finite-strain solver are cached in DIR/cache."""
    options = ["--strain", str(DATA)] + (["--quick"] if quick else ["--deep"])
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", PALPATE_CACHE=str(folder / "cache"))
    text = subprocess.run([str(program)] + options, env=environment, check=True, stdout=subprocess.PIPE,
                          universal_newlines=True).stdout
    (folder / "finite-strain.csv").write_text(text, encoding="utf-8")
    rows = strain.read(text)
    (folder / "finite-strain.md").write_text(strain.tables(rows), encoding="utf-8")
    if not strain.draw(rows, folder / "finite-strain.png"):
        print("no finite-strain.png: no matplotlib", file=sys.stderr)
    print(strain.tables(rows))


def measure_relaxation(program, options):
    return subprocess.run([str(program), "--relaxation", str(DATA)] + list(options), check=True, stdout=subprocess.PIPE,
                          universal_newlines=True).stdout


def report_relaxation(program, quick, folder):
    rows = relaxation.read(measure_relaxation(program, ["--quick"] if quick else []))
    write(folder / "relaxation.csv", [row for row in rows if row["part"] != "curve"], relaxation.FORCE_COLUMNS)
    columns, curves = relaxation.curves(rows)
    write(folder / "relaxation-curves.csv", curves, columns)
    (folder / "relaxation.md").write_text(relaxation.tables(rows), encoding="utf-8")
    if not relaxation.draw(rows, folder / "relaxation.png"):
        print("no relaxation.png: no matplotlib", file=sys.stderr)
    print(relaxation.tables(rows))


def measure_tilt(program, options):
    return subprocess.run([str(program), "--tilt", str(DATA)] + list(options), check=True, stdout=subprocess.PIPE,
                          universal_newlines=True).stdout


def report_tilt(program, quick, folder):
    rows = tilt.read(measure_tilt(program, ["--quick"] if quick else []))
    write(folder / "tilt.csv", rows, tilt.COLUMNS)
    (folder / "tilt.md").write_text(tilt.tables(rows), encoding="utf-8")
    if not tilt.draw(rows, folder / "tilt.png"):
        print("no tilt.png: no matplotlib", file=sys.stderr)
    print(tilt.tables(rows))


def report_shape(quick, folder):
    try:
        import palpate  # noqa: F401
    except ImportError as error:
        print("no shape: the package palpate is not on the path ({})".format(error), file=sys.stderr)
        return
    rows = shape.measure(quick, lambda text: print(text, file=sys.stderr))
    write(folder / "shape.csv", rows, shape.COLUMNS)
    (folder / "shape.md").write_text(shape.tables(rows), encoding="utf-8")
    if not shape.draw(rows, folder / "shape.png"):
        print("no shape.png: no matplotlib", file=sys.stderr)
    print(shape.tables(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build" / "studies" / "accuracy-speed")
    parser.add_argument("--program", type=pathlib.Path, default=PROGRAM)
    parser.add_argument("--quick", action="store_true", help="few tips, no finite elements, a coarse head; "
                        "of the shapes one nodule, and no body in series")
    parser.add_argument("--scene", action="append", choices=("block", "layer", "plate", "head"), default=[])
    parser.add_argument("--redraw", type=pathlib.Path, help="rows of an earlier run (rows.csv) instead of a new one")
    parser.add_argument("--only-strain", action="store_true", help="against finite strain alone")
    parser.add_argument("--only-shape", action="store_true", help="on an edge, a horn and a nodule alone")
    parser.add_argument("--only-relaxation", action="store_true", help="bodies that relax alone")
    parser.add_argument("--only-tilt", action="store_true", help="tools that lean alone")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    if arguments.only_shape:
        return report_shape(arguments.quick, arguments.output)
    if not arguments.program.exists() and not arguments.redraw:
        parser.error("there is no {}: was it left out of the build?".format(arguments.program))
    if not arguments.redraw and not arguments.only_strain and not arguments.only_relaxation:
        report_tilt(arguments.program, arguments.quick, arguments.output)
    if arguments.only_tilt:
        return
    if not arguments.redraw and not arguments.only_strain:
        report_relaxation(arguments.program, arguments.quick, arguments.output)
    if arguments.only_relaxation:
        return
    if not arguments.redraw:
        report_strain(arguments.program, arguments.quick, arguments.output)
    if arguments.only_strain:
        return
    if not arguments.redraw:
        report_shape(arguments.quick, arguments.output)
    if arguments.redraw:
        text = arguments.redraw.read_text(encoding="utf-8")
    else:
        heads, why = [], ""
        if not arguments.scene or "head" in arguments.scene:
            heads, why = head.prepare(arguments.output, (4.0,) if arguments.quick else (0.0, 2.0, 4.0))
        if why:
            print("no head: " + why, file=sys.stderr)
        options = ["--quick", "--no-finite"] if arguments.quick else []
        for scene in arguments.scene:
            options += ["--scene", scene]
        text = measure(arguments.program, options, heads)
        (arguments.output / "rows.csv").write_text(text, encoding="utf-8")
    methods, convergence = report(text, arguments.output)
    print(tables(methods, convergence))
    print("results in {}".format(arguments.output))


if __name__ == "__main__":
    main()
