#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Indentation of finite-element bodies by CalculiX: makes the curves in Data/Studies/calculix.

  run.py [--case NAME ...] [--output DIR] [--jobs N] [--mesh-error] [--keep DIR]

Without --case, all cases are solved (see --list). Each case writes DIR/NAME.csv. With --mesh-error the
cases are solved with elements twice as large instead, and DIR/mesh_error.csv gets the largest relative
difference of the force from that in DIR/NAME.csv. Exit code 77 without `ccx` on the PATH, 1 if a case
fails.
"""
import argparse
import concurrent.futures
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np

import cases
import deck


def version():
    answer = subprocess.run(["ccx", "-v"], capture_output=True, text=True).stdout
    return answer.strip().split()[-1]


def solve(case, coarseness, folder):
    """Returns forces at the deflections of the case, number of nodes of the body, and computing time in s. Raises
    RuntimeError without convergence."""
    text, factor, nodes = deck.write(case, coarseness)
    job = folder / "{}-{:g}".format(case.name, coarseness)
    job.with_name(job.name + ".inp").write_text(text)
    start = time.monotonic()
    answer = subprocess.run(["ccx", "-i", job.name], cwd=folder, capture_output=True, text=True)
    job.with_name(job.name + ".log").write_text(answer.stdout + answer.stderr)
    table = job.with_name(job.name + ".dat")
    forces = deck.forces(table.read_text() if table.exists() else "", case, factor)
    if answer.returncode != 0 or len(forces) < len(cases.deflections(case)):
        last = cases.deflections(case)[len(forces) - 1] if len(forces) else 0
        raise RuntimeError("{}: ccx stopped after a deflection of {:g} mm: {}".format(
            case.name, last, " ".join(answer.stdout.strip().split("\n")[-3:])))
    return forces, nodes, time.monotonic() - start


def write_curve(path, case, forces, nodes):
    body, law = case.body, {"linear": "linear elastic, small strain",
                            "neohooke": "compressible Neo-Hooke, finite strain"}[case.material]
    element = "CAX8R, axisymmetric" if body.half_width == 0 else "C3D20R, quarter model"
    contact = ("u_z of the nodes under the flat prescribed, free sideways" if case.tool.shape == "flat"
               else "rigid sphere, frictionless surface-to-surface contact")
    head = [
        "origin: CalculiX {}, finite elements, made by Testing/Studies/calculix/run.py".format(version()),
        "tool: {}:{:g}".format(case.tool.shape, case.tool.radius),
        "body: {}".format(body.description),
        "material: {}, E = {:g} MPa, nu = {:g}".format(law, cases.YOUNGS_MODULUS, body.poisson_ratio),
        "mesh: {} elements, {} nodes; {}".format(element, nodes, contact)]
    with open(path, "w", encoding="utf-8") as out:
        out.writelines("# {}\n".format(line) for line in head)
        out.write("site,x_mm,y_mm,z_mm,deflection_mm,force_N\n")
        for deflection, force in zip(cases.deflections(case), forces):
            out.write("centre,0,0,0,{:.6g},{:.6g}\n".format(deflection, force))


def read_forces(path):
    with open(path, encoding="utf-8") as curve:
        rows = [line for line in curve if not line.startswith("#")][1:]
    return np.array([float(row.split(",")[5]) for row in rows])


def update_mesh_error(path, name, error):
    """Writes the line of a case to mesh_error.csv and keeps the lines of the other cases."""
    table = {}
    if path.exists():
        table = dict(line.split(",") for line in path.read_text().strip().split("\n")[1:])
    table[name] = "{:.2g}".format(error)
    path.write_text("case,largest_force_difference_to_coarser_mesh\n" + "".join(
        "{},{}\n".format(*row) for row in sorted(table.items())))


def run(case, arguments, folder):
    """Returns number of nodes of the body, computing time in s, and with --mesh-error the largest relative difference from
    the curve of the finer mesh."""
    path = arguments.output / (case.name + ".csv")
    forces, nodes, seconds = solve(case, 2.0 if arguments.mesh_error else 1.0, folder)
    if not arguments.mesh_error:
        write_curve(path, case, forces, nodes)
        return nodes, seconds, None
    fine = read_forces(path)
    # The first depths, at which the contact covers only a few elements, are left out.
    return nodes, seconds, np.max(np.abs(forces / fine - 1)[len(fine) // 4:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--case", nargs="+", metavar="NAME", choices=list(cases.CASES),
                        default=list(cases.CASES))
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("."))
    parser.add_argument("--jobs", type=int, default=1, help="cases at the same time")
    parser.add_argument("--mesh-error", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for decks and CalculiX's files")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    if arguments.list:
        print("\n".join(cases.CASES))
        return 0
    if shutil.which("ccx") is None:
        print("run.py: no ccx on the PATH (Debian: calculix-ccx)", file=sys.stderr)
        return 77
    arguments.output.mkdir(parents=True, exist_ok=True)
    failed = 0
    with tempfile.TemporaryDirectory() as scratch, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        folder = arguments.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        jobs = {pool.submit(run, cases.CASES[name], arguments, folder): name for name in arguments.case}
        for job in concurrent.futures.as_completed(jobs):
            name = jobs[job]
            try:
                nodes, seconds, error = job.result()
            except (OSError, RuntimeError, ValueError) as reason:
                print("run.py: error:", reason, file=sys.stderr, flush=True)
                failed += 1
                continue
            print("{}: {} nodes, {:.0f} s{}".format(name, nodes, seconds, "" if error is None else
                  ", {:.2g} from the finer mesh".format(error)), flush=True)
            if error is not None:
                update_mesh_error(arguments.output / "mesh_error.csv", name, error)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
