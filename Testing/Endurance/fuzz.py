#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the fuzzers for a long time: each runs at least the given number of inputs and finds nothing.

    fuzz.py --build build/asan --runs 1000000 --jobs 2 --output FILE.json [--only NAME ...]

ctest lists the fuzzers and their options (label Fuzz). Each starts from its committed corpus and
writes new inputs to a new folder, BUILD/endurance/NAME. Inputs that cause a failure are written to
BUILD/endurance/findings.

--only runs some of them again, after a fault was corrected, and keeps the results of the others in FILE.json.

FILE.json: {"part": "fuzzing", "passed": bool, "figures": {NAME: {...}}}, per fuzzer the commit, seed (as
given to libFuzzer), executions, executions_per_s, new_units (inputs kept because they reached new code),
edges and features (libFuzzer's cov and ft), peak_rss_mb, seconds, finding ("none", or libFuzzer's message
and the path of the input). Exit code: 0 if there is no finding and each fuzzer ran all its inputs,
1 otherwise.
"""
import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from endurance import commit

# Each allocation records three stack frames, because thirty frames would take a third of the time.
# If a failing input is run alone, all frames are reported. Freed memory is kept in quarantine for a
# while to detect later use. A quarantine of 16 MiB holds the memory of many inputs and stays in the
# cache.
ENVIRONMENT = {"ASAN_OPTIONS": "malloc_context_size=3:quarantine_size_mb=16",
               "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1"}
REPLACED = ("-seed=", "-max_total_time=", "-print_final_stats=", "-runs=")


def fuzzers(build):
    """Name -> command line of each fuzzer in the build, as in its test."""
    listing = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, check=True,
                             stdout=subprocess.PIPE, text=True).stdout
    found = {}
    for test in json.loads(listing)["tests"]:
        labels = [p["value"] for p in test["properties"] if p["name"] == "LABELS"]
        if labels == [["Fuzz"]] and "command" in test:
            found[test["name"].split(".", 1)[1]] = test["command"]
    return found


def command_for(command, scratch, findings, runs, seed):
    """The test's command for `runs` inputs. Its folders are the scratch corpus and the committed corpus."""
    program, *rest = command
    options = [word for word in rest if word.startswith("-") and not word.startswith(REPLACED)]
    committed = [word for word in rest if not word.startswith("-")][-1]
    return [program, *options, f"-runs={runs}", f"-seed={seed}", "-print_final_stats=1",
            f"-artifact_prefix={findings}/{scratch.name}-", str(scratch), committed]


def last(pattern, text, default=None):
    """The number in the last match, or the default."""
    found = re.findall(pattern, text)
    return int(found[-1]) if found else default


def read_log(text, runs):
    """The results in libFuzzer's last lines."""
    executions = last(r"stat::number_of_executed_units:\s*(\d+)", text, 0)
    artifact = re.findall(r"Test unit written to (\S+)", text)
    summary = re.findall(r"^(?:SUMMARY: .*|does not hold: .*)$", text, re.MULTILINE)
    return {"executions": executions,
            "complete": executions >= runs,
            "executions_per_s": last(r"stat::average_exec_per_sec:\s*(\d+)", text),
            "new_units": last(r"stat::new_units_added:\s*(\d+)", text),
            "edges": last(r"\bcov: (\d+)", text),
            "features": last(r"\bft: (\d+)", text),
            "peak_rss_mb": last(r"stat::peak_rss_mb:\s*(\d+)", text),
            "finding": ", ".join(summary + artifact) or "none"}


def fuzz(name, command, folder, runs, seed):
    """Runs one fuzzer. Returns its figures."""
    scratch = folder / name
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    findings = folder / "findings"
    findings.mkdir(exist_ok=True)
    log = folder / f"{name}.log"
    begin = time.monotonic()
    with log.open("w") as stream:
        code = subprocess.run(command_for(command, scratch, findings, runs, seed), stdout=stream,
                              stderr=subprocess.STDOUT, check=False,
                              env={**os.environ, **ENVIRONMENT}).returncode
    figures = {"seed": seed, **read_log(log.read_text(errors="replace"), runs),
               "seconds": round(time.monotonic() - begin, 1)}
    if code != 0 and figures["finding"] == "none":
        figures["finding"] = f"ended with exit code {code}, see {log}"
    print(f"{name:16} {figures['executions']:>9} inputs, {figures['executions_per_s']} per s, "
          f"{figures['edges']} edges, "
          f"findings: {figures['finding']}" + ("" if figures["complete"] else ", NOT COMPLETE"), flush=True)
    return figures


def judge(figures):
    """Whether every fuzzer ran all its inputs without a finding; False if there is no fuzzer."""
    return bool(figures) and all(f["complete"] and f["finding"] == "none" for f in figures.values())


def merge(earlier, figures):
    """The earlier file with the new figures in place of the old ones."""
    together = {**earlier.get("figures", {}), **figures}
    passed = judge(together)
    return {**earlier, "part": "fuzzing", "passed": passed, "fault": "" if passed else "see finding",
            "figures": together}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--runs", type=int, default=1_000_000)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, help="of libFuzzer (default: another each time)")
    parser.add_argument("--only", nargs="+", help="these fuzzers; the others' figures are kept")
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()

    known = fuzzers(arguments.build)
    unknown = set(arguments.only or ()) - set(known)
    if unknown or not known:
        sys.exit(f"error: {arguments.build} has no fuzzer {', '.join(sorted(unknown)) or 'at all'}")
    chosen = {name: known[name] for name in known if not arguments.only or name in arguments.only}
    file = arguments.output
    earlier = json.loads(file.read_text(encoding="utf-8")) if arguments.only and file.exists() else {}
    tried = commit() # the commit of the build, read now because it may change during the run
    seed = arguments.seed or random.SystemRandom().randrange(1, 2**31)
    print(f"seed {seed}", flush=True)
    folder = (arguments.build / "endurance").resolve()
    with ThreadPoolExecutor(arguments.jobs) as pool:
        running = {name: pool.submit(fuzz, name, command, folder, arguments.runs, seed)
                   for name, command in chosen.items()}
        figures = {name: {"commit": tried, **result.result()} for name, result in running.items()}
    written = merge(earlier, figures)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(written, indent=1) + "\n", encoding="utf-8")
    return 0 if judge(figures) else 1


if __name__ == "__main__":
    sys.exit(main())
