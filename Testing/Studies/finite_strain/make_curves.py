#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Solves the curves at finite strain that the studies use as a reference: Data/Studies/finite-strain/curves.csv.

    make_curves.py PROGRAM FILE [--only TEXT]    PROGRAM: bin/palpatePress of the build (a target of its own)

Cases whose key begins with TEXT are solved again; the others are kept as in FILE. Without --only all cases are solved.
Forces are for E* = 1 MPa. Cost: half a minute per half-space, some seconds per layer; half an hour in total on two
processors.
"""
import argparse
import csv
import pathlib
import subprocess
from concurrent.futures import ThreadPoolExecutor

COLUMNS = ("tool", "thickness_mm", "nu", "model", "parameter", "edge", "fillet_mm", "depth_mm", "force_over_modulus_mm2",
           "contact_radius_mm", "least_volume")
SPHERE, LARGE, SMALL, FLAT = "sphere:1", "sphere:6.35", "sphere:1.6", "flat:1"
NEO = ("neohooke", 0)
STIFFENING = (("ogden", 9), ("ogden", -5), ("demiray", 0.5), ("demiray", 2))
LIVER = 10  # mm


def cases():
    """Yields (tool, thickness, nu, model, parameter, deepest, edge, fillet): edge length of the mesh, fillet of corners."""
    edge = 0.05
    for nu in (0.495, 0.45, 0.3, 0.49, 0.4995):
        yield SPHERE, 0, nu, *NEO, 1.35, edge, 0.1
    for nu in (0.495, 0.49, 0.48, 0.45):
        for tool, deepest in ((LARGE, 5), (SMALL, 3)):
            for law in (NEO, *(STIFFENING if nu == 0.495 else ())):
                yield tool, LIVER, nu, *law, deepest, edge, 0.1
    for law in STIFFENING:
        yield SPHERE, 0, 0.495, *law, 1.35, 0.08 if law[0] == "demiray" else edge, 0.1
    for h in (0.5, 1, 2):
        for nu in (0.3, 0.45, 0.495, 0.4995):
            yield SPHERE, h, nu, *NEO, 0.5 * h, edge, 0.1
    for model in ("neohooke", "linear"):
        yield FLAT, 0, 0.495, model, 0, 0.75, edge, 0.1


def key(case):
    return ",".join("%s" % (x if isinstance(x, str) else "%g" % x) for x in case)


def solve(program, case):
    tool, thickness, nu, model, parameter, deepest, edge, fillet = case
    run = subprocess.run([program] + [str(x) for x in (tool, thickness, nu, model, parameter, deepest, 13, edge, fillet)],
                         capture_output=True, text=True, check=False)
    head = [tool] + ["%g" % x for x in (thickness, nu)] + [model] + ["%g" % x for x in (parameter, edge, fillet)]
    rows = [head + line.split(",")[:4] for line in run.stdout.splitlines()]
    print(key(case), len(rows), "depths", run.stderr.strip(), flush=True)
    return rows


def kept(path):
    """Returns the rows of an earlier run, with the columns of their case as keys."""
    found = {}
    if path.exists():
        with open(path, encoding="utf-8") as file:
            for row in csv.reader(file):
                found.setdefault(tuple(row[:7]), []).append(row)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--only")
    parser.add_argument("--threads", type=int, default=2)
    arguments = parser.parse_args()
    old = kept(arguments.file) if arguments.only is not None else {}

    def rows(case):
        tool, thickness, nu, model, parameter, _, edge, fillet = case
        head = (tool, "%g" % thickness, "%g" % nu, model, "%g" % parameter, "%g" % edge, "%g" % fillet)
        if arguments.only is not None and not key(case).startswith(arguments.only) and head in old:
            return old[head]
        return solve(arguments.program, case)

    with open(arguments.file, "w", encoding="utf-8", newline="") as file, ThreadPoolExecutor(arguments.threads) as threads:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for each in threads.map(rows, list(cases())):
            writer.writerows(each)
            file.flush()


if __name__ == "__main__":
    main()
