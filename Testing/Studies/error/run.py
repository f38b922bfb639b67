#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks whether the stated error holds, and computes the share of a body on which it is small enough.

    ./run study error [--contacts N] [--cases FILE ...] [--body FILE[:LENGTH] ...] [--output DIR]

Cases: random contacts on half-spaces, layers, stacks, balls and in cavities, each solved by the finite-strain solver
(palpateErrorCases; N of each, 5 to 20 s of a processor per contact), or the rows of existing FILEs.
Writes cases.csv, cases.md (how often the bound holds, and how wide it is) and scatter.png: stated error over true
error, with the 1:1 line.

Cover: the share of the surface on which the stated error of a tool at 1 mm is at most 5 %, with curvature correction
and Neo-Hooke, nu = 0.45: on the head of Debian's mricron-data if it is installed, and on each FILE (.stl .ply .obj
.vtp ...), scaled so that its longest side is LENGTH mm. Writes cover.csv. A missing scan or file is reported.

    ./run study error --solid SIDES --body FILE[:LENGTH] ... [--finer CELLS | --direct N | --press N] [--smooth TIMES]

Computes the cover by finite elements of true shape for each FILE, a closed surface held at SIDES (such as y-:4). With
--finer also compares the stated error with the change of the force on a mesh of CELLS tetrahedra. Writes solid.csv.
Takes minutes per body.

With --direct instead: compares the stated error with direct contact on a separate finer mesh, at N random places for each
tool and each range of the stated error (direct.py). The surface is smoothly refined TIMES times. Writes direct.csv. Takes
a dozen seconds per place. Without --solid, the responses are those of the law in series with the compliance of the whole
body (whole_body.py).

With --press: computes the additional share of the body whose error is within 5 % with direct contact
(vtkDirectContactResponse), from N random places for each tool in the rest of the body (pressed.py). The surface is
smoothly refined TIMES + 1 times. Writes pressed.csv.
"""
import argparse
import csv
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = ROOT / "build" / "release" / "bin" / "palpateErrorCases"
SCAN = pathlib.Path("/usr/share/mricron/templates/ch2.nii.gz")  # Debian's mricron-data: Colin 27
FAMILIES = ("half-space", "layer", "stack", "ball", "cavity")
SOLVER = 0.004  # error of the solver's own force
DIRECT = 0.01  # error of direct contact, in addition to half the difference between its two forces


def solve(family, count, seed):
    done = subprocess.run([str(PROGRAM), family, str(count), str(seed)], stdout=subprocess.PIPE, text=True, check=True)
    return list(csv.DictReader(done.stdout.splitlines()))


def read(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def summary(rows):
    """Yields for each family and law: number of rows, share for which the stated error holds, median ratio of the stated
    error to the true error (at least 0.5 %)."""
    groups = {}
    for row in rows:
        groups.setdefault((row["family"], row["law"]), []).append((float(row["stated"]), float(row["error"])))
    for family in FAMILIES:
        for law in ("small", "finite", "curved", "curved finite"):
            found = groups.get((family, law), [])
            if found:
                ratios = sorted(stated / max(error, 0.005) for stated, error in found)
                held = sum(error <= stated + SOLVER for stated, error in found)
                yield family, law, len(found), held / len(found), ratios[len(ratios) // 2]


def write_cases(rows, output):
    with open(output / "cases.csv", "w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    held = sum(float(row["error"]) <= float(row["stated"]) + SOLVER for row in rows)
    with open(output / "cases.md", "w", encoding="utf-8") as stream:
        stream.write("| body | law | forces | bound holds | stated over true error, median |\n|---|---|---|---|---|\n")
        for family, law, count, share, ratio in summary(rows):
            stream.write("| {} | {} | {} | {:.0%} | {:.1f} |\n".format(family, law, count, share, ratio))
        stream.write("| all | | {} | {:.1%} | |\n".format(len(rows), held / len(rows)))


def draw(rows, output):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plot
    figure, axes = plot.subplots(figsize=(6.4, 5.6), layout="constrained")
    colours = dict(zip(FAMILIES, ("#0072b2", "#56b4e9", "#e69f00", "#009e73", "#d55e00")))
    marks = {"small": "o", "finite": "s", "curved": "^", "curved finite": "D"}
    least = 2e-4
    for (family, law) in sorted({(row["family"], row["law"]) for row in rows}):
        some = [row for row in rows if (row["family"], row["law"]) == (family, law)]
        axes.loglog([max(least, float(row["error"])) for row in some], [float(row["stated"]) for row in some],
                    marks[law], color=colours[family], markersize=4, alpha=0.7, label="{}, {}".format(family, law))
    ends = (least, 1.0)
    axes.plot(ends, ends, "k-", linewidth=1)
    axes.plot(ends, [3 * end for end in ends], "k:", linewidth=1)
    axes.annotate("stated = true", (0.3, 0.22), rotation=42)
    axes.annotate("3 times", (0.1, 0.36), rotation=42)
    axes.set(xlim=ends, ylim=(1e-3, 1.0), xlabel="true error of the force (finite elements)",
             ylabel="stated error", title="The stated error of a force beside the true one")
    axes.legend(fontsize=7, loc="upper left", title="body, law", title_fontsize=7)
    figure.savefig(output / "scatter.png", dpi=130)


def bodies(files):
    """Yields names and bodies; prints a text for a missing body."""
    from cover import read_body, read_head
    if SCAN.exists():
        yield "head", read_head(SCAN)
    else:
        print("No head: {} is missing (Debian's mricron-data).".format(SCAN))
    if not files:
        print("No other body: name one by --body FILE:LENGTH, the bunny by --body bunny.ply:150, say.")
    for given in files:
        file, _, length = given.rpartition(":") if given.rpartition(":")[2].replace(".", "").isdigit() else (given, "", "")
        yield pathlib.Path(file).stem, read_body(file, float(length) if length else None)


def write_cover(files, output):
    from cover import TOOLS, cover
    with open(output / "cover.csv", "w", encoding="utf-8") as stream:
        stream.write("body,points,tool,share_within_5_percent,rest_by_largest_part\n")
        for name, body in bodies(files):
            for tool in TOOLS:
                share, rest = cover(body, tool)
                words = "; ".join("{} {:.3f}".format(*part) for part in sorted(rest.items(), key=lambda part: -part[1]))
                stream.write("{},{},{},{:.3f},{}\n".format(name, body.GetNumberOfPoints(), tool, share, words))
                print("{}, {}: {:.1%} ({})".format(name, tool, share, words), flush=True)


def write_solid(files, fixed, finer, output):
    import true_shape
    with open(output / "solid.csv", "w", encoding="utf-8") as stream:
        stream.write("body,points,tool,share_within_5_percent,beyond_stated,compared,median_error,median_surface_error,rest_by_limit\n")
        for name, body in bodies(files):
            if name == "head" and len(files) > 0:
                continue  # the head is studied with layers, not as a solid
            try:
                made = true_shape.press(body, fixed)
                better = true_shape.press(body, fixed, finer, coarser=0) if finer else None
            except ValueError as fault:
                print("{} {}.".format(name, fault), file=sys.stderr, flush=True)
                continue
            for tool in true_shape.TOOLS:
                share, rest = true_shape.cover(made, tool)
                judged = true_shape.beyond(made, better, tool) if better else ("", "", "")
                words = "; ".join("{} {:.3f}".format(*part) for part in sorted(rest.items(), key=lambda part: -part[1]))
                stream.write("{},{},{},{:.3f},{},{},{},{:.3f},{}\n".format(
                    name, body.GetNumberOfPoints(), tool, share, *("{:.4g}".format(v) if isinstance(v, float) else v for v in judged),
                    true_shape.surface_error(made, tool), words))
                print("{}, {}: {:.1%} ({}); beyond what is stated, of, median error: {}".format(
                    name, tool, share, words, judged), flush=True)


def holds(row):
    """Whether the stated error of a row of direct.csv bounds its true error, within the uncertainty of direct contact."""
    return abs(float(row["error"])) <= float(row["stated"]) + DIRECT + float(row["open"])


def write_direct(files, fixed, count, times, output):
    import direct
    import true_shape
    import whole_body
    press = (lambda surface: (true_shape.press(surface, fixed, small=True), fixed)) if fixed else whole_body.press
    rows = direct.write((found for found in bodies(files) if found[0] != "head"), press, count, times, output)
    for found in direct.summary(rows, holds):
        print("{}, {}, stated {:.0%} to {:.0%}: of {} hold {}, median error {:.2%}".format(*found))


def write_pressed(files, fixed, count, times, output):
    import pressed
    pressed.write((found for found in bodies(files) if found[0] != "head"), fixed, count, times + 1 if times else 0, output)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/studies/error"))
    parser.add_argument("--contacts", type=int, default=24, help="of each kind")
    parser.add_argument("--cases", nargs="*", default=[], help="rows made before, instead")
    parser.add_argument("--body", action="append", default=[])
    parser.add_argument("--no-cover", action="store_true")
    parser.add_argument("--solid", metavar="SIDES")
    parser.add_argument("--finer", type=int, metavar="CELLS")
    parser.add_argument("--direct", type=int, metavar="N")
    parser.add_argument("--press", type=int, metavar="N")
    parser.add_argument("--smooth", type=int, metavar="TIMES", default=2)
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    if options.direct:
        write_direct(options.body, options.solid, options.direct, options.smooth, options.output)
        return
    if options.solid and options.press:
        write_pressed(options.body, options.solid, options.press, options.smooth, options.output)
        return
    if options.solid:
        write_solid(options.body, options.solid, options.finer, options.output)
        return
    if options.cases:
        rows = [row for file in options.cases for row in read(file)]
    else:
        with ThreadPoolExecutor(2) as threads:
            made = threads.map(lambda i: solve(FAMILIES[i], options.contacts, 21 + i), range(len(FAMILIES)))
            rows = [row for part in made for row in part]
    write_cases(rows, options.output)
    try:
        draw(rows, options.output)
    except ImportError as error:
        print("No picture: {}".format(error), file=sys.stderr)
    print((options.output / "cases.md").read_text(encoding="utf-8"))
    if not options.no_cover:
        write_cover(options.body, options.output)


if __name__ == "__main__":
    main()
