#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the compile time of each library as a Markdown table: seconds from start to end, summed over its object files.

    compile_times.py [BUILD [TARGET]]    BUILD: a build folder of ninja, default build/release; TARGET: its libraries are
                                         counted, default `palpate` (which ./run demo builds)

The times are valid only if nothing else was running and ccache was empty: remove the build folder, set CCACHE_DISABLE=1,
build TARGET.
"""
import collections
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def last_times(build):
    """Output -> seconds, of the last time that it was made."""
    times = {}
    for line in (build / ".ninja_log").read_text().splitlines():
        if not line.startswith("#"):
            start, end, _, output, _ = line.split("\t")
            times[output] = (int(end) - int(start)) / 1000.0
    return times


def objects_of(build, target):
    made_of = subprocess.run(["ninja", "-C", str(build), "-t", "inputs", target], check=True, capture_output=True, text=True)
    return [line for line in made_of.stdout.splitlines() if line.endswith(".o")]


def library_of(output):
    """Filters/Solids/CMakeFiles/palpateSolids.dir/… is of Filters/Solids."""
    return re.sub(r"/?CMakeFiles/.*", "", output)


def main():
    build = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SOURCE / "build" / "release"
    target = sys.argv[2] if len(sys.argv) > 2 else "palpate"
    times = last_times(build)
    seconds, count = collections.Counter(), collections.Counter()
    for output in objects_of(build, target):
        seconds[library_of(output)] += times.get(output, 0.0)
        count[library_of(output)] += 1
    print(f"| library | objects | compile seconds of `{target}` |\n|---|---|---|")
    for library, taken in seconds.most_common():
        print(f"| {library} | {count[library]} | {taken:.0f} |")
    print(f"| all | {sum(count.values())} | {sum(seconds.values()):.0f} |")


if __name__ == "__main__":
    main()
