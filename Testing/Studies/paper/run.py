#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tests of Mahvash and Hayward (2002), sections 2 and 4, computed.

    ./run study paper [--quick] [--only NAME] [--output DIR]

Writes a CSV and, with matplotlib, a PNG per figure to DIR (default build/studies/paper), and prints the
numbers that the README discusses. --quick: coarser meshes and fewer points, as the test does.
"""
import argparse
import pathlib
import sys

import castigliano
import finite_strain
import flowing
import friction
import liver_slab
import local_rubber
import results
import rubber_on_edges
import sliding
import st_venant

PARTS = {"st_venant": st_venant, "castigliano": castigliano, "rubber_on_edges": rubber_on_edges,
         "local_rubber": local_rubber, "liver_slab": liver_slab, "friction": friction,
         "sliding": sliding, "finite_strain": finite_strain, "flowing": flowing}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parents[3] / "build" / "studies" / "paper")
    parser.add_argument("--only", choices=PARTS, action="append")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    if results.pyplot is None:
        print("no matplotlib (python3-matplotlib): no pictures", file=sys.stderr)
    for name in arguments.only or PARTS:
        print(PARTS[name].__doc__.splitlines()[0])
        PARTS[name].make(arguments.output, arguments.quick)
    print("results in {}".format(arguments.output))


if __name__ == "__main__":
    main()
