# SPDX-License-Identifier: BSD-3-Clause
"""Palpate: the force of a tool pressed on a body.

    body = palpate.response("liver.stl", tool="sphere:6.35", young=0.05)     # a curve at each point
    forces, deflection, *rest = palpate.probe(body, tips)                    # N and mm, one row per tip

Functions on numpy arrays, each with its own help: response, probe, curves, regime, measured. The package also contains
every wrapped class of the pipeline (``from palpate import vtkContactTool``). ``palpate.contract`` evaluates the
response arrays of a saved body with numpy alone, and can be imported without VTK.

``palpate.__version__`` is the version of Palpate.

Units: mm, N, MPa, N/mm. Forces act on the tool and point out of the body.
"""
import importlib
import importlib.util
import os
import pkgutil

from ._version import __version__ as __version__

FUNCTIONS = {"_response": ("regime", "response", "Regime"), "_probe": ("probe", "CoupledProbe", "Probe"),
             "_curves": ("curves", "Curves"), "_measured": ("measured", "Measured")}


def _reexport():
    """Imports each class of the wrapped modules in the folder of this file into the package."""
    here = os.path.dirname(__file__)
    for module in pkgutil.iter_modules([here]):
        if module.name.startswith("palpate"):
            wrapped = importlib.import_module("." + module.name, __name__)
            for name in dir(wrapped):
                if name.startswith("vtk"):
                    globals()[name] = getattr(wrapped, name)
    for module, names in FUNCTIONS.items():
        for name in names:
            globals()[name] = getattr(importlib.import_module("." + module, __name__), name)


if importlib.util.find_spec("vtkmodules") is not None:
    _reexport()
else:
    def __getattr__(name):
        if name.startswith("vtk") or any(name in names for names in FUNCTIONS.values()):
            raise ImportError("palpate.%s needs VTK's Python modules (vtkmodules), which are not there; "
                              "palpate.contract works without" % name)
        raise AttributeError("module 'palpate' has no attribute '%s'" % name)
