#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the kernels' tests under valgrind's memcheck: no invalid access, no uninitialised value, no leak.

    memcheck.py --build build/release --jobs 2 --output FILE.json [--quick]

These are the GoogleTest programs of the folders without VTK, found by their label in ctest. They are
compiled for release, so that memcheck checks the code that users run. The sanitizers cannot check
CHOLMOD, BLAS and hidapi. --quick: only the ticks (QUICK below). LEFT_OUT lists the tests that are left
out, with the reason. memcheck.supp may excuse third-party code, but never code of Palpate.

FILE.json: {"part": "memcheck", "passed": bool, "figures": {"minutes", "left out": [pattern: reason],
PROGRAM: {...}}}, per program: tests in it, run, left_out, failed (names), errors (kinds and where).
Exit code: 0 if no test failed and memcheck found nothing; 1 otherwise; 77 without valgrind.
"""
import argparse
import fnmatch
import json
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOMS = ("Mechanics", "Contact", "Laws", "Strain", "Solids", "Identification", "Haptics", "Transports", "Trials")
QUICK = {"palpateTickTests": "*"}
SUPPRESSIONS = Path(__file__).with_name("memcheck.supp")
# Tests per valgrind: a start takes a second, and the last chunks should end at about the same time.
CHUNK = 12

# Pattern -> reason. Under valgrind, programs run 30 to 100 times slower, with one thread at a time.
# For each kind of code that is left out, a shorter test remains.
SWEEP = "sweeps numbers for a bound: minutes here, no code that shorter tests of its suite leave out"
TABLES = "solves layers anew for whole tables: minutes here; LayerTable.Bonded* and LayerContact.* remain"
LONG = "compares with closed forms in long double, which valgrind computes in 64 bits"
LEFT_OUT = {
    "ClosedForm.LoadInsideNearTheAxis": LONG,
    "ResponseEnergy.ClosedFormOfPowerLaws": LONG,
    "ClosedForm.NormalDisplacementOutside": LONG,
    "LayerContact.DenseSolution": TABLES,
    "LayerTable.SeveralPoissonsRatios": TABLES,
    "LayerTable.AnyThickness": TABLES,
    "LayerTable.LiverSlab": TABLES,
    "DepthLimit.CostsAtMostTwoThousandthsOfTheForce": SWEEP,
    "PatchCompliance.TheHalfSpaceIsThatOfTheMaterialAtThePoint": SWEEP,
    "FrictionEnergy.NeverGivenBackMoreThanTaken": SWEEP,
    "SmoothContact.IsTheFootOfThePerpendicularAndNoneIsNearer": SWEEP,
    "StorageError.WithinTheBoundsOfTheReferenceSheet": SWEEP,
    "FrictionPath.TheNumberOfTicksDoesNotMatterOnAStraightWay": SWEEP,
    "ShapeFriction.LikeThousandsOfSprings": SWEEP,
    "*ExactContact.*/1": "bodies of 200 000 triangles; those of the same tests with fewer remain",
    "ResponseReduction.ManyPoints": "a million points; the reductions of fewer remain",
    "MemoryForecast.*": "measures what a factorisation takes, which is another amount here",
    "FiniteElementThreads.*": "several times what PatchCompliance.* and GlobalModes.* do",
    "SceneExchange.ThousandsBetweenThreads": "two threads that wait for each other, of which one runs at a time",
    "SceneChange.ThousandsWhileTheLoopRuns": "two threads that wait for each other, of which one runs at a time",
}


def programs(build):
    """The GoogleTest programs of the folders in ROOMS."""
    listing = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, check=True,
                             stdout=subprocess.PIPE, text=True).stdout
    found = set()
    for test in json.loads(listing)["tests"]:
        labels = [label for p in test["properties"] if p["name"] == "LABELS" for label in p["value"]]
        command = test.get("command", [])
        if set(labels) & set(ROOMS) and any("--gtest_filter" in word for word in command):
            found.add(Path(command[0]))
    return sorted(found)


def tests_of(program):
    """The names Suite.Test of all tests that are not disabled."""
    listing = subprocess.run([program, "--gtest_list_tests"], check=True, stdout=subprocess.PIPE,
                             text=True).stdout
    tests, suite = [], ""
    for line in listing.splitlines():
        name = line.split("#")[0].rstrip()
        if not line.startswith(" ") and name.endswith("."):
            suite = name
        elif line.startswith("  ") and "DISABLED_" not in suite + name:
            tests.append(suite + name.strip())
    return tests


def reason_against(test):
    """The reason why a test is left out, or None."""
    return next((why for pattern, why in LEFT_OUT.items() if fnmatch.fnmatchcase(test, pattern)), None)


def errors_in(report):
    """Kind and the innermost frames of each error in valgrind's report."""
    try:
        root = ElementTree.parse(report).getroot()
    except (ElementTree.ParseError, OSError) as error:
        return [f"no report: {error}"]
    found = []
    for error in root.iter("error"):
        kind = error.findtext("kind", "?")
        if kind.startswith("Leak_") and kind != "Leak_DefinitelyLost":
            continue
        frames = [f.findtext("fn") or f.findtext("obj", "?") for f in error.find("stack").iter("frame")]
        found.append(f"{kind}: " + " < ".join(frames[:6]))
    return found


def memcheck(program, tests, folder, number):
    """Runs some tests of a program. Returns the number of tests that ran, the names of failed tests, and errors."""
    report = folder / f"{program.name}-{number}.xml"
    results = folder / f"{program.name}-{number}.json"
    # Some tests replace operator new to count allocations. Valgrind must not intercept it; it calls
    # malloc.
    command = ["valgrind", "--error-exitcode=99", "--leak-check=full",
               "--errors-for-leak-kinds=definite", "--show-leak-kinds=definite", "--num-callers=30",
               "--child-silent-after-fork=yes", "--soname-synonyms=somalloc=nouserintercepts",
               "--xml=yes", f"--xml-file={report}"]
    if SUPPRESSIONS.exists():
        command.append(f"--suppressions={SUPPRESSIONS}")
    log = folder / f"{program.name}-{number}.log"
    with log.open("w") as stream:
        code = subprocess.run([*command, program, "--gtest_filter=" + ":".join(tests),
                               f"--gtest_output=json:{results}"], stdout=stream,
                              stderr=subprocess.STDOUT, check=False, cwd=folder).returncode
    cases = []
    if results.exists():
        cases = [(s["name"] + "." + t["name"], bool(t.get("failures")), t["time"])
                 for s in json.loads(results.read_text())["testsuites"] for t in s["testsuite"]
                 if t["result"] != "SUPPRESSED"]
    errors = errors_in(report)
    failed = [name for name, fails, _ in cases if fails]
    if len(cases) < len(tests):
        failed += sorted(set(tests) - {name for name, *_ in cases})
    if code != 0 and not failed and not errors:
        errors.append(f"ended with exit code {code}, see {log}")
    print(f"{program.name} {number}: {len(cases)} tests in {sum(float(t.rstrip('s')) for _, _, t in cases):.0f} s, "
          + (", ".join(failed + errors) or "nothing found"), flush=True)
    return {"ran": len(cases), "failed": failed, "errors": errors}


def judge(figures):
    """Whether each program ran tests, all of them passed, and valgrind found no error."""
    return bool(figures) and all(f["run"] > 0 and f["failed"] == "none" and f["errors"] == "none"
                                 for f in figures.values())


def check_all(chosen, folder, jobs):
    """Program -> its figures. Runs up to `jobs` valgrinds at the same time."""
    with ThreadPoolExecutor(jobs) as pool:
        started = {}
        for program, tests in chosen.items():
            kept = [t for t in tests if reason_against(t) is None]
            chunks = [kept[i::-(-len(kept) // CHUNK)] for i in range(-(-len(kept) // CHUNK))]
            started[program] = (tests, kept, [pool.submit(memcheck, program, chunk, folder, i)
                                              for i, chunk in enumerate(chunks)])
        figures = {}
        for program, (tests, kept, parts) in started.items():
            results = [part.result() for part in parts]
            figures[program.name] = {
                "tests": len(tests), "run": sum(r["ran"] for r in results),
                "left_out": len(tests) - len(kept),
                "failed": ", ".join(name for r in results for name in r["failed"]) or "none",
                "errors": "; ".join(sorted({e for r in results for e in r["errors"]})) or "none"}
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--quick", action="store_true", help="the tick tests alone")
    parser.add_argument("--output", type=Path)
    arguments = parser.parse_args()
    if not shutil.which("valgrind"):
        print("valgrind is not installed", file=sys.stderr)
        return 77

    begin = time.monotonic()
    chosen = {}
    for program in programs(arguments.build):
        pattern = QUICK.get(program.name, "") if arguments.quick else "*"
        tests = [t for t in tests_of(program) if fnmatch.fnmatchcase(t, pattern)]
        if tests:
            chosen[program] = tests
    with tempfile.TemporaryDirectory(prefix="palpate-memcheck-") as folder:
        figures = check_all(chosen, Path(folder), arguments.jobs)
    passed = judge(figures)
    if arguments.output:
        arguments.output.parent.mkdir(parents=True, exist_ok=True)
        arguments.output.write_text(json.dumps(
            {"part": "memcheck", "passed": passed,
             "figures": {"minutes": round((time.monotonic() - begin) / 60.0, 1),
                         "left out": [f"{pattern}: {why}" for pattern, why in LEFT_OUT.items()],
                         **figures}}, indent=1) + "\n")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
