#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the long tests of Palpate.

    ./run endurance [--only PART ...] [--soak-seconds S] [--runs N] [--unplugs N] [--points N] [--output DIR]

Runs the parts (README.md) and writes to DIR (default build/endurance) a PART.json and a PART.txt (its whole output) for
each part, and report.md: the machine, and the newest figures of every part with their date and commit. The soak test
runs at the same time as the parts that only compute; they are its load. The parts that measure times run after it,
alone.

Exit code: 0 if every part that was run passed, 1 if one failed, 2 for a wrong call.
"""
import argparse
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

NOTHING = {"passed": False, "figures": {}, "fault": "not run", "seconds": 0.0, "date": "", "commit": ""}


class Part:
    """A command that writes {"part", "passed", "figures"} to its own file. run() adds to this file the date, the
    commit, the duration and the fault.
    """

    def __init__(self, name, what, command):
        self.name, self.what, self.command = name, what, command

    def file(self, folder):
        return folder / (self.name + ".json")

    def run(self, folder):
        result = self.file(folder)
        result.unlink(missing_ok=True)
        begin, date, tried = time.monotonic(), datetime.datetime.now(datetime.timezone.utc), commit()
        code, fault = None, ""
        with open(folder / (self.name + ".txt"), "wb") as said:
            try:
                code = subprocess.run([str(word) for word in self.command] + ["--output", str(result)], stdout=said,
                                      stderr=subprocess.STDOUT, check=False, cwd=ROOT).returncode
            except OSError as error:
                fault = str(error)
        written = judge(code, fault, result)
        written.update(date=date.strftime("%Y-%m-%d %H:%M UTC"), commit=tried, seconds=time.monotonic() - begin)
        result.write_text(json.dumps(written, indent=1), encoding="utf-8")

    def result(self, folder):
        """The results that run() wrote, in this or an earlier call."""
        try:
            return {**NOTHING, **json.loads(self.file(folder).read_text(encoding="utf-8"))}
        except OSError:
            return NOTHING


def judge(code, fault, file):
    """A part has passed only if both its exit code and its file report success."""
    try:
        written = json.loads(file.read_text(encoding="utf-8"))
        passed = code == 0 and written["passed"] is True
        figures = dict(written["figures"])
    except (OSError, ValueError, KeyError, TypeError) as error:
        passed, figures, fault = False, {}, fault or "no result: {}".format(error)
    if not passed and not fault:
        fault = "exit code {}".format(code)
    return {"passed": passed, "figures": figures, "fault": fault}


def make_parts(arguments):
    """The parts that only compute, the soak, and the parts that measure times."""
    release, asan = ROOT / "build" / "release", ROOT / "build" / "asan"
    python, jobs = sys.executable, len(os.sched_getaffinity(0))
    beside = [
        Part("fuzzing", "what comes from devices, files and command lines, under address and undefined sanitizer",
             [python, HERE / "fuzz.py", "--build", asan, "--runs", arguments.runs, "--jobs", jobs]),
        Part("memcheck", "the tests of the kernels under valgrind",
             [python, HERE / "memcheck.py", "--build", release, "--jobs", jobs]),
        Part("limits", "a body of many points against brute force",
             [release / "bin" / "palpateLimits", "--points", arguments.points]),
    ]
    soak = Part("soak", "the servo loop at 4 kHz while bodies are swapped, devices come and go, samples are missing",
                [release / "bin" / "palpateSoak", "--seconds", arguments.soak_seconds])
    alone = [
        Part("unplugs", "devices pulled out at random moments, on the real hidapi",
             ["umockdev-wrapper", release / "bin" / "palpateUnplugs", "--count", arguments.unplugs]),
    ]
    return beside, soak, alone


def run_parts(beside, soak, alone, folder):
    loads = threading.Thread(target=lambda: [part.run(folder) for part in beside])
    loads.start()
    if soak:
        soak.run(folder)
    loads.join()
    for part in alone:
        part.run(folder)


def first_line(*command):
    try:
        said = subprocess.run(command, check=False, stdout=subprocess.PIPE, universal_newlines=True).stdout
    except OSError:
        return "unknown"
    return said.splitlines()[0].strip() if said.strip() else "unknown"


def field(file, name):
    """The value of `name` in a file of `name: value` or `name=value` lines."""
    try:
        for line in pathlib.Path(file).read_text(encoding="utf-8").splitlines():
            key, sign, value = line.partition("=" if "=" in line else ":")
            if sign and key.strip() == name:
                return value.strip().strip('"')
    except OSError:
        pass
    return "unknown"


def commit():
    return first_line("git", "-C", str(ROOT), "describe", "--always", "--dirty")


def machine():
    memory = field("/proc/meminfo", "MemTotal").split()[0]
    return [
        ("processor", "{}, {} in use".format(field("/proc/cpuinfo", "model name"), len(os.sched_getaffinity(0)))),
        ("memory", "{:.0f} GB".format(int(memory) / 2 ** 20) if memory.isdigit() else memory),
        ("system", "{}, Linux {}".format(field("/etc/os-release", "PRETTY_NAME"), platform.release().partition("-")[0])),
        ("compilers", "{}; {}".format(first_line("g++", "--version"), first_line("clang", "--version"))),
        ("valgrind", first_line("valgrind", "--version")),
    ]


def number(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return "{:.5g}".format(value)
    return "{:,}".format(value).replace(",", " ") if isinstance(value, int) else str(value)


def show(figures):
    """Markdown of {name: value}. A list becomes lines below its name. Values that are dictionaries become the rows of
    one table.
    """
    rows = {name: value for name, value in figures.items() if isinstance(value, dict)}
    lines = []
    for name, value in figures.items():
        if isinstance(value, list):
            lines += ["- {}:".format(name)] + ["  - {}".format(number(item)) for item in value]
        elif name not in rows:
            lines.append("- {}: {}".format(name, number(value)))
    if rows:
        columns = list(dict.fromkeys(column for row in rows.values() for column in row))
        lines += [""] if lines else []
        lines += ["| |" + "".join(" {} |".format(column) for column in columns), "|---|" + "---|" * len(columns)]
        lines += ["| {} |".format(name) + "".join(" {} |".format(number(row.get(column, ""))) for column in columns)
                  for name, row in rows.items()]
    return lines


def write_report(parts, folder, about):
    """Markdown of the newest results."""
    lines = ["# What was endured", "", "Made by `./run endurance`; parts may have been repeated alone.", ""]
    lines += ["- {}: {}".format(*entry) for entry in about]
    lines += ["", "| part | passed | begun | commit | time | what |", "|---|---|---|---|---|---|"]
    results = [(part, part.result(folder)) for part in parts]
    for part, result in results:
        lines.append("| {} | {} | {} | {} | {:.0f} s | {} |".format(
            part.name, "yes" if result["passed"] else "NO: " + result["fault"], result["date"], result["commit"],
            result["seconds"], part.what))
    for part, result in results:
        lines += ["", "## " + part.name, ""] + show(result["figures"])
    return "\n".join(lines) + "\n"


def parse(words):
    parser = argparse.ArgumentParser(prog="./run endurance", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="*", metavar="PART", help="these; without any the report is written anew")
    parser.add_argument("--soak-seconds", type=int, default=3600)
    parser.add_argument("--runs", type=int, default=1000000, help="inputs of each fuzzer")
    parser.add_argument("--unplugs", type=int, default=1000)
    parser.add_argument("--points", type=int, default=8000000, help="of the largest body")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build" / "endurance")
    arguments = parser.parse_args(words)
    beside, soak, alone = make_parts(arguments)
    known = [part.name for part in beside + [soak] + alone]
    for name in arguments.only or []:
        if name not in known:
            parser.error("there is no part '{}'; there are: {}".format(name, " ".join(known)))
    return arguments.output.resolve(), beside, soak, alone, set(known if arguments.only is None else arguments.only)


def main(words):
    folder, beside, soak, alone, chosen = parse(words)
    folder.mkdir(parents=True, exist_ok=True)
    run_parts([part for part in beside if part.name in chosen], soak if soak.name in chosen else None,
              [part for part in alone if part.name in chosen], folder)
    parts = [soak] + beside + alone
    report = write_report(parts, folder, machine())
    (folder / "report.md").write_text(report, encoding="utf-8")
    print(report)
    print("report in {}".format(folder / "report.md"))
    return 0 if all(part.result(folder)["passed"] for part in parts if part.name in chosen) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
