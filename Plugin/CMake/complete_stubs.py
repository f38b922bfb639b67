#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Completes type stubs that VTK's generate_pyi has made: imports the classes that they name and do not define.

    complete_stubs.py FOLDER MODULE ...     of the package palpate in FOLDER

VTK 9.1 writes 'vtkPolyData' for a class of another module. A class that no loaded module has becomes Any. The stubs
export their classes alone, so that `from .MODULE import *` of two of them does not define helpers twice.
"""
import importlib
import re
import sys
from pathlib import Path

END_OF_HEAD = re.compile(r"^(?=class )", re.MULTILINE)


def home_of(name, own):
    """The module that has a class."""
    for module in sorted(key for key in sys.modules if key.startswith(("vtkmodules.vtk", "palpate."))):
        found = getattr(sys.modules[module], name, None)
        if module != own and isinstance(found, type) and found.__module__ == module:
            return module
    return None


def complete(stub, own):
    text = stub.read_text(encoding="utf-8")
    defined = re.findall(r"^class (\w+)", text, re.MULTILINE)
    if "__all__" in text or not defined:
        return
    head = ["__all__ = %r" % defined]
    for name in sorted(set(re.findall(r"'(vtk\w+)'", text)) - set(defined)):
        module = home_of(name, own)
        head.append("from %s import %s" % (module, name) if module else "%s = Any" % name)
    place = END_OF_HEAD.search(text).start()
    stub.write_text(text[:place] + "\n".join(head) + "\n\n" + text[place:], encoding="utf-8")


if __name__ == "__main__":
    for each in sys.argv[2:]:
        importlib.import_module("palpate." + each)
        complete(Path(sys.argv[1]) / (each + ".pyi"), "palpate." + each)
