#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Limits the lines of a file of the product and the settable properties of a class, to keep them easy to read.

A .h, .cxx or .c of Filters, Interactors and Plugin has at most LINES lines. A VTK class has at most SETTABLE
properties, which are counted by the Set... functions of its header, written out or from a macro of VTK.
SetShapeToSphere() belongs to the property Shape.

    check_sizes.py [SOURCE_DIR]    check the tree (default: the one this script is in)
    check_sizes.py --self-test     exceed the limits and check that it is noticed

Exit code: 0 no fault, 1 a fault, 2 wrong usage.
"""
import re
import sys
from pathlib import Path

from check_layering import code_files, main

LINES = 400
SETTABLE = 25
ROOMS = ("Filters", "Interactors", "Plugin")
SILENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
SETTER = re.compile(r"\bvtkSet\w*Macro\(\s*(\w+)|\bvoid Set([A-Z]\w*)\(|\bbool Set([A-Z]\w*)\(")
INPUT = re.compile(r".+To[A-Z]\w*$|.*(Connection|Data)$")  # value of an enumeration; port of a pipeline


def settable(text):
    names = {next(filter(None, found)) for found in SETTER.findall(SILENT.sub(" ", text))}
    return {name for name in names if not INPUT.match(name)}


def check(texts):
    """Complaints about {path: text}."""
    complaints = []
    for path, text in texts.items():
        lines = text.count("\n")
        if lines > LINES:
            complaints.append(f"{path} has {lines} lines, more than {LINES}")
        if path.name.startswith("vtk") and path.suffix == ".h" and len(settable(text)) > SETTABLE:
            complaints.append(f"{path} has {len(settable(text))} properties that can be set, more than {SETTABLE}")
    return complaints


def self_test():
    few = "".join(f"  vtkSetMacro(P{i}, int);\n" for i in range(SETTABLE))
    wrong = {Path("Filters/A/Long.cxx"): "\n" * (LINES + 1),
             Path("Filters/A/vtkMany.h"): few + "  void SetOther(double other);\n"}
    sound = {Path("Filters/A/Short.cxx"): "\n" * LINES,
             Path("Filters/A/vtkFew.h"): few + "  void SetP1ToOne();\n  // void SetRemark(int);\n  void SetInputData(int);\n"}
    found = [complaint.split()[0] for complaint in check({**wrong, **sound})]
    failures = found != [str(path) for path in wrong]
    print(f"self-test: {len(wrong) + len(sound)} files, complaints about {', '.join(found) or 'none'}")
    return 1 if failures else 0


def check_tree(root):
    return check({path: (root / path).read_text(encoding="utf-8") for path in code_files(root)
                  if path.parts[0] in ROOMS})


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], __doc__, "sizes", check_tree, self_test))
