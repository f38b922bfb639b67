# SPDX-License-Identifier: BSD-3-Clause
"""Palpate: what does this tool feel, pressed here on this body?

Re-exports every wrapped class: ``from palpate import vtkContactTool``. ``palpate.contract`` reads the
response arrays of a saved body with numpy alone.
"""
import importlib
import os
import pkgutil


def _reexport():
    """The wrapped modules stand beside this file; each class goes into the package by its name."""
    here = os.path.dirname(__file__)
    for module in pkgutil.iter_modules([here]):
        if module.name.startswith("palpate"):
            wrapped = importlib.import_module("." + module.name, __name__)
            for name in dir(wrapped):
                if name.startswith("vtk"):
                    globals()[name] = getattr(wrapped, name)


_reexport()
