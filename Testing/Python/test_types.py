#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Version and type annotations of the package, without a type checker; test_mypy.py runs one."""
import ast
import builtins
import inspect
import re
import typing
import unittest
from pathlib import Path

import numpy as np
import palpate
from vtkmodules.vtkCommonDataModel import vtkPolyData

SOURCE = Path(__file__).resolve().parents[2]
FUNCTIONS = (palpate.response, palpate.probe, palpate.curves, palpate.regime, palpate.measured)
STUBS = sorted(Path(palpate.__file__).parent.glob("palpate*.pyi"))


def undefined_names(text):
    """Names in the annotations of a stub, quoted or not, that are neither defined nor imported."""
    tree = ast.parse(text)
    known = set(dir(builtins))
    for node in ast.walk(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            known |= {(alias.asname or alias.name).split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ClassDef):
            known.add(node.name)
        elif isinstance(node, ast.Assign):
            known |= {target.id for target in node.targets if isinstance(target, ast.Name)}
    used = set()
    for node in ast.walk(tree):
        given = [node.annotation] if isinstance(node, (ast.arg, ast.AnnAssign)) else \
            [node.returns] if isinstance(node, ast.FunctionDef) else []
        for annotation in filter(None, given):
            for part in ast.walk(annotation):
                if isinstance(part, ast.Constant) and isinstance(part.value, str):
                    used |= {name.id for name in ast.walk(ast.parse(part.value)) if isinstance(name, ast.Name)}
                elif isinstance(part, ast.Name):
                    used.add(part.id)
    return used - known


class Version(unittest.TestCase):
    def test_it_is_that_of_the_project(self):
        project = re.search(r"^project\(Palpate VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(), re.MULTILINE)
        self.assertEqual(palpate.__version__, project.group(1))
        cited = re.search(r"^version: (.*)$", (SOURCE / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual(palpate.__version__, cited.group(1))


class Types(unittest.TestCase):
    def test_every_argument_has_a_type(self):
        for function in FUNCTIONS:
            types = typing.get_type_hints(function)
            for argument in (*inspect.signature(function).parameters, "return"):
                with self.subTest(function=function.__name__, argument=argument):
                    self.assertIn(argument, types)
                    self.assertIsNot(types[argument], typing.Any)

    def test_defaults_have_the_type(self):
        """Checks numbers, flags and texts in the signature. Other defaults are None or empty."""
        simple = (bool, int, float, str)
        for function in FUNCTIONS:
            types = typing.get_type_hints(function)
            for name, parameter in inspect.signature(function).parameters.items():
                if types[name] in simple and parameter.default is not inspect.Parameter.empty:
                    with self.subTest(function=function.__name__, argument=name):
                        self.assertIsInstance(parameter.default, types[name])

    def test_results(self):
        self.assertIs(typing.get_type_hints(palpate.response)["return"], vtkPolyData)
        for fields in (palpate.Probe, palpate.Curves, palpate.Regime):
            self.assertEqual(set(typing.get_type_hints(fields).values()), {np.ndarray})

    def test_stubs_define_what_they_use(self):
        for stub in STUBS:
            with self.subTest(stub=stub.name):
                self.assertEqual(undefined_names(stub.read_text(encoding="utf-8")), set())

    def test_an_undefined_name_is_noticed(self):
        self.assertEqual(undefined_names("class A:\n    def f(self, x: 'vtkB') -> C: ...\n"), {"vtkB", "C"})
        self.assertEqual(undefined_names("from m import vtkB, C\nclass A:\n    def f(self, x: 'vtkB') -> C: ...\n"), set())


if __name__ == "__main__":
    unittest.main(verbosity=2)
