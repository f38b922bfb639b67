#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the files to open for a complete reading of one topic, and their lines.

There are three readings, each a program of this folder: `tick` (from ServoStep's step to the written force, with every
surface, force form, friction model and link of the safety chain), `response` (from vtkToolContactResponse's
RequestData to its arrays; half-space and one layer) and `picture` (from a vtkHapticSession that has ticked to the
rendered picture). Each is compiled with --coverage in a build folder of its own, at -O0, and run once. A file of
Filters or Interactors belongs to the reading if a line of it was executed. NAME.h next to an executed NAME.cxx belongs
to it too, since both are read together. Headers that hold only declarations or tables are not found in this way.
Lines are counted as by `wc -l`, including comments, because they are read too.

It also prints the product's size: lines of .h, .cxx, .c and .py of Filters, Interactors and Plugin that are neither
blank nor comment; and the types that hold a contact: a force, a point and a normal. One is `Contact`, others are
copies of it.

    reading.py [--build DIR] [--jobs N] [--most] [READING ...]

--build   default build/reading; some 5 minutes the first time
--most    list the files too, longest first
Exit code: 0, or 1 if a program could not be built or run.
"""
import argparse
import ast
import io
import json
import os
import re
import subprocess
import sys
import tokenize
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
READINGS = {"tick": "palpateReadTick", "response": "palpateReadResponse", "picture": "palpateReadPicture"}
ROOMS = ("Filters", "Interactors")
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|("(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\')', re.DOTALL)


def build(folder, programs, jobs):
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
                        "-DCMAKE_CXX_FLAGS=--coverage -O0", "-DPALPATE_BUILD_BENCHMARKS=OFF",
                        "-DPython3_EXECUTABLE=/usr/bin/python3"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", *programs, "--", f"-j{jobs}"], check=True,
                   stdout=subprocess.DEVNULL)


def executed(folder, program):
    """The lines of Filters and Interactors that the program executes while it counts: {file: {line}}."""
    for data in folder.rglob("*.gcda"):
        data.unlink()
    display = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset"] if "Picture" in program else []
    found = subprocess.run([*display, folder / "bin" / program], check=True, capture_output=True, text=True)
    print(f"{program}: {found.stdout.strip()}", file=sys.stderr)
    lines = defaultdict(set)
    for data in folder.rglob("*.gcda"):
        text = subprocess.run(["gcov", "--json-format", "--stdout", data], check=True, capture_output=True,
                              cwd=data.parent).stdout
        for report in text.decode().splitlines():
            for entry in json.loads(report)["files"] if report else ():
                path = (folder / entry["file"]).resolve()  # ccache makes names relative to the build folder
                if not path.is_relative_to(ROOT) or path.relative_to(ROOT).parts[0] not in ROOMS:
                    continue
                lines[path.relative_to(ROOT)] |= {line["line_number"] for line in entry["lines"] if line["count"] > 0}
    return {path: numbers for path, numbers in lines.items() if numbers}


def to_open(lines):
    """The files of a reading, with their lines."""
    files = set(lines) | {path.with_suffix(".h") for path in lines if (ROOT / path.with_suffix(".h")).exists()}
    return {path: len((ROOT / path).read_text().splitlines()) for path in files}


def code_lines(path):
    text = path.read_text(encoding="utf-8")
    if path.suffix != ".py":
        text = COMMENT.sub(lambda match: match.group(1) or "\n" * match.group().count("\n"), text)
        return sum(bool(line.strip()) for line in text.splitlines())
    used = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in (tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT,
                              tokenize.ENDMARKER):
            used |= set(range(token.start[0], token.end[0] + 1))
    for node in ast.walk(ast.parse(text)):  # a string statement counts as a comment
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            used -= set(range(node.lineno, node.end_lineno + 1))
    return len(used)


def product():
    names = subprocess.run(["git", "ls-files", "Filters", "Interactors", "Plugin"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.split()
    files = [ROOT / name for name in names if Path(name).suffix in (".h", ".cxx", ".c", ".py")]
    return [path for path in files if path.exists()]


STRUCT = re.compile(r"^(?:struct|class) (?:\w+_EXPORT )?(\w+)[^;{()]*\n\{\n(.*?)^\};", re.DOTALL | re.MULTILINE)
COMPONENTS = ("force", "point", "normal")


def contacts(files):
    """Types that hold what a contact is: vectors called so and so force, point and normal, as members of their own."""
    found = []
    for path in files:
        if path.suffix == ".h":
            for name, body in STRUCT.findall(COMMENT.sub(" ", path.read_text())):
                members = [re.sub(r"\s*(?:=[^;]*|\{[^;]*\});", ";", line) for line in body.splitlines()]
                vectors = " ".join(re.findall(r"^  (?:Eigen::)?(?:Vector3d?|double) (\w+)(?:\[3\])?;", "\n".join(members),
                                              re.MULTILINE)).lower()
                if all(component in vectors for component in COMPONENTS):
                    found.append((name, path.relative_to(ROOT)))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("readings", nargs="*", metavar="READING", help=", ".join(READINGS))
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "reading")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--most", action="store_true", help="list the files, longest first")
    arguments = parser.parse_args()
    names = arguments.readings or list(READINGS)
    if set(names) - set(READINGS):
        parser.error(f"a reading is one of {', '.join(READINGS)}")
    folder = arguments.build.resolve()
    try:
        build(folder, [READINGS[name] for name in names], arguments.jobs)
        for name in names:
            lines = executed(folder, READINGS[name])
            files = to_open(lines)
            print(f"{name}: {len(files)} files, {sum(files.values())} lines "
                  f"({len(lines)} with an executed line, {sum(files[path] for path in lines)} lines)")
            for path in sorted(files, key=lambda path: (-files[path], path)) if arguments.most else ():
                print(f"{files[path]:6}  {len(lines.get(path, ())):4} executed  {path}")
    except subprocess.CalledProcessError as fault:
        print(f"reading.py: {fault}\n{fault.stderr or ''}", file=sys.stderr)
        return 1
    sources = product()
    print(f"product: {len(sources)} files, {sum(map(code_lines, sources))} lines of code")
    found = contacts(sources)
    print("types with a force, a point and a normal: "
          + ", ".join(f"{kind} ({path})" for kind, path in found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
