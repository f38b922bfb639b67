#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Stability of a loop: the stiffnesses, forces, friction, geometry and failures for which a loop is stable.

    ./run study stability [--quick] [--output DIR] [--program FILE]

Runs the parts of palpateStability, two at a time, and writes to DIR (default build/studies/stability): a CSV per
part that also has the values of theory, verdicts.csv and verdicts.md (method by failure), and with matplotlib
stability.png, details.png and relaxing.png. All runs are in virtual time, with the same results on every machine. Columns
and units: README.md.
"""
import argparse
import concurrent.futures
import csv
import io
import pathlib
import subprocess
import sys

import theory
import verdicts

ROOT = pathlib.Path(__file__).resolve().parents[3]
PARTS = ("press", "cylinder", "limits", "encoder", "leak", "friction", "geometry", "faults",
         "relaxing", "relaxing-press", "relaxing-paths", "hands", "hands-press")  # the longest first
WORDS = {"model", "evaluated", "control", "start", "tool", "body", "form", "surface", "edges", "what", "method", "failure",
         "material", "path", "motion"}


def measure(program, part, is_quick):
    command = [str(program), part] + (["--quick"] if is_quick else [])
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout


def read(text):
    rows = list(csv.DictReader(io.StringIO(text)))
    return [{name: value if name in WORDS or value == "" else float(value) for name, value in row.items()} for row in rows]


def select(rows, **wanted):
    return [row for row in rows if all(row[name] == value for name, value in wanted.items())]


def hand_of(row):
    return {"hand_stiffness": row.get("hand_N_per_m", 0.0), "hand_damping": row.get("hand_Ns_per_m", 0.0)}


def limits_with_theory(rows):
    for row in rows:
        period = 1 / row["rate_Hz"]
        row["exact_N_per_m"] = theory.exact_limit(row["mass_kg"], row["damping_Ns_per_m"], period, row["delay_ticks"],
                                                  **hand_of(row))
        row["passive_N_per_m"] = theory.passive_limit(row["damping_Ns_per_m"], period)
        row["rule_N_per_m"] = theory.delay_bound(row["damping_Ns_per_m"], period, row["delay_ticks"])
        row["error"] = row["limit_N_per_m"] / row["exact_N_per_m"] - 1


def encoder_with_theory(rows):
    for row in rows:
        step = 1e-6 * row["encoder_um"]
        row["bound_N_per_m"] = theory.encoder_bound(row["damping_Ns_per_m"], 1 / row["rate_Hz"], step, row["coulomb_N"])
        row["friction_N_per_m"] = 2 * row["coulomb_N"] / step


def press_with_theory(rows):
    """Adds the stiffness at which a loop without control becomes unstable, and the force of Table 1 at this stiffness."""
    for row in rows:
        exact = theory.exact_limit(theory.MASS, row["damping_Ns_per_m"], 1 / row["rate_Hz"])
        force = theory.force_at_stiffness(row["model"], exact, row["modulus_MPa"])
        row["exact_N_per_m"] = exact
        row["exact_force_N"] = "" if force is None else min(force, theory.STRONGEST_PUSH)


def cylinder_with_theory(rows):
    for row in rows:
        exact = theory.exact_limit(theory.MASS, row["damping_Ns_per_m"], 1 / row["rate_Hz"], **hand_of(row))
        row["exact_N_per_m"] = exact
        row["exact_modulus_MPa"] = theory.modulus_at(row["tool"], exact, row["push_N"])


def leak_with_theory(rows):
    for row in rows:
        row["expected_mJ"] = 1e3 * theory.leaked(row["peak_force_N"], row["speed_m_s"], 1 / row["rate_Hz"],
                                                 row["delay_ticks"])


def relaxing_with_theory(rows):
    for row in rows:
        period, damping = 1 / row["rate_Hz"], row["damping_Ns_per_m"]
        row["exact_N_per_m"] = theory.relaxing_limit(row["material"], row["mass_kg"], damping, period, row["delay_ticks"])
        row["elastic_N_per_m"] = theory.exact_limit(row["mass_kg"], damping, period, row["delay_ticks"])
        row["passive_N_per_m"] = theory.passive_relaxing(row["material"], damping, period)
        row["error"] = row["limit_N_per_m"] / row["exact_N_per_m"] - 1


def hands_with_theory(rows):
    for row in rows:
        alone = theory.exact_limit(row["mass_kg"], row["damping_Ns_per_m"], 1 / row["rate_Hz"], row["delay_ticks"])
        row["alone_N_per_m"] = alone
        row["exact_N_per_m"] = theory.pair_limit(alone, row["apart_radii"], row["motion"])
        row["error"] = row["limit_N_per_m"] / row["exact_N_per_m"] - 1


THEORY = {"hands": hands_with_theory, "relaxing": relaxing_with_theory, "limits": limits_with_theory, "encoder": encoder_with_theory, "press": press_with_theory,
          "cylinder": cylinder_with_theory, "leak": leak_with_theory}


def study(program, is_quick, parts=PARTS):
    """Runs the parts and returns their rows: {part: rows}."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        texts = dict(zip(parts, pool.map(lambda part: measure(program, part, is_quick), parts)))
    tables = {part: read(text) for part, text in texts.items()}
    for part, add in THEORY.items():
        if part in tables:
            add(tables[part])
    return tables


def write(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build" / "studies" / "stability")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "release" / "bin" / "palpateStability")
    parser.add_argument("--quick", action="store_true", help="some rows of each part: no pictures")
    arguments = parser.parse_args()
    if not arguments.program.exists():
        parser.error(f"there is no {arguments.program}: was it left out of the build?")
    arguments.output.mkdir(parents=True, exist_ok=True)
    tables = study(arguments.program, arguments.quick)
    for part, rows in tables.items():
        write(arguments.output / f"{part}.csv", rows)
    cells = verdicts.judge(tables)
    write(arguments.output / "verdicts.csv", cells)
    (arguments.output / "verdicts.md").write_text(verdicts.markdown(cells), encoding="utf-8")
    print(verdicts.markdown(cells))
    if not arguments.quick:
        try:
            import pictures
        except ImportError:
            print("no matplotlib (python3-matplotlib): no pictures", file=sys.stderr)
        else:
            pictures.draw(tables, cells, arguments.output)
    print(f"results in {arguments.output}")


if __name__ == "__main__":
    main()
