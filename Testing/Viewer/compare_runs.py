#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that two runs of a scene wrote the same files, byte by byte.

    compare_runs.py ONE OTHER    the folders of the runs

Exit code: 0 they are the same, 1 they are not, 77 the scene was not run (see run_scene.py).
"""
import sys
from pathlib import Path

SKIPPED = 77


def files(folder):
    return {path.name: path.read_bytes() for path in Path(folder).iterdir() if path.is_file()}


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 2
    one, other = map(files, arguments)
    if not one and not other:
        print("skipped: the folders are empty, the scene could not be run here")
        return SKIPPED
    for name in sorted(one.keys() | other.keys()):
        print(f"{name}: {'the same' if one.get(name) == other.get(name) else 'DIFFERENT'}")
    expected = {"trajectory.csv", "overview.png", "deflection.png", "curves.png"}
    missing = expected - one.keys()
    print(*(f"{name}: MISSING" for name in sorted(missing)), sep="\n", end="")
    return 0 if one == other and not missing else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
