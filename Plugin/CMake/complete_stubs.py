#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Completes type stubs made by VTK's generate_pyi: adds imports of the classes that a stub uses but does not define.

    complete_stubs.py FOLDER MODULE ...     FOLDER contains the package palpate

VTK 9.1 writes 'vtkPolyData' for a class of another module. A class that no loaded module contains is replaced by Any.
The stubs export only their classes, so that `from .MODULE import *` of two stubs does not define helpers twice.
"""
import importlib
import re
import sys
from pathlib import Path

END_OF_HEAD = re.compile(r"^(?=class )", re.MULTILINE)


def home_of(name, own):
    """Returns the module that contains a class."""
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
