#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""mypy reads the package's annotations. It finds no error in them, determines the types of results, and finds the
errors of a program that uses the package. Exit code 77 without mypy; test_types.py does not need it."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import palpate

PACKAGE = Path(palpate.__file__).parent

# A line that ends with "# is: T" contains an expression of type T. A line that ends with "# wrong:
# W" gives an error that contains W.
PROGRAM = """\
import numpy as np
import palpate

body = palpate.response("liver.stl", tool="sphere:6.35", young=0.05)
soft = palpate.response((np.zeros((3, 3)), [[0, 1, 2]]), young=np.full(3, 0.05), layer="Thickness", compliance=None)
two = palpate.response(body, strain=("ogden", 8.0), layers=[(2.0, 0.1, 0.45), (3.0, 0.1, 0.45, True)], relax=[(0.5, 0.1)])
reveal_type(palpate.__version__)                                # is: str
reveal_type(palpate.probe(body, np.zeros((4, 3))).forces)       # is: numpy.ndarray
reveal_type(palpate.probe(body, np.zeros((4, 3))).error)        # is: numpy.ndarray
reveal_type(palpate.probe(body, np.zeros((4, 3)), coupled=True))  # is: palpate._probe.CoupledProbe
reveal_type(palpate.curves(body, points=0).stiffness)           # is: numpy.ndarray
reveal_type(palpate.regime(body).verdict)                       # is: numpy.ndarray
reveal_type(palpate.measured(body, ["a.csv"]).sites)            # is: builtins.list[builtins.dict[builtins.str, Any]]
reveal_type(palpate.vtkContactTool().GetForce(0.1, 1.0))        # is: builtins.float
reveal_type(palpate.vtkToolContactResponse().GetTool())         # is: palpate.palpateResponse.vtkContactTool
palpate.response(body, tool=3)                                  # wrong: "tool"
palpate.response(body, yuong=0.05)                              # wrong: "yuong"
palpate.response(body, strain="hooke")                          # wrong: "strain"
palpate.response(body, samples="8")                             # wrong: "samples"
palpate.probe(body)                                             # wrong: "probe"
palpate.probe(body, np.zeros((4, 3)), force_form="smooth")      # wrong: "probe"
palpate.probe(body, np.zeros((4, 3))).force                     # wrong: "force"
palpate.vtkContactTool().SetRadius("2")                         # wrong: "SetRadius"
"""


def mypy(*arguments, **environment):
    # Debian's VTK has no stubs. Its classes are unknown to mypy, which is not an error of the
    # program.
    command = ["mypy", "--ignore-missing-imports", "--python-executable", sys.executable, "--no-color-output",
               "--no-error-summary", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, **environment})


class Mypy(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def test_nothing_is_wrong_in_the_package(self):
        done = mypy("--cache-dir", self.folder / "cache", "-p", "palpate", MYPYPATH=str(PACKAGE.parent))
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_a_program(self):
        program = self.folder / "program.py"
        program.write_text(PROGRAM, encoding="utf-8")
        done = mypy("--cache-dir", self.folder / "cache", program, PYTHONPATH=str(PACKAGE.parent))
        self.assertEqual(done.stderr, "")
        found = {}
        for line, kind, text in re.findall(r"^.*?program\.py:(\d+): (\w+): (.*)$", done.stdout, re.MULTILINE):
            found.setdefault(int(line), []).append((kind, text))
        for number, line in enumerate(PROGRAM.splitlines(), 1):
            messages = found.pop(number, [])
            errors = [text for kind, text in messages if kind == "error"]
            notes = " ".join(text for kind, text in messages)
            with self.subTest(line=line):
                if "# wrong: " in line:
                    self.assertTrue(errors, "mypy finds nothing wrong")
                    self.assertIn(line.split("# wrong: ")[1], notes)
                else:
                    self.assertEqual(errors, [])
                if "# is: " in line:
                    self.assertIn(line.split("# is: ")[1], notes)
        self.assertEqual(found, {})


if __name__ == "__main__":
    if shutil.which("mypy") is None:
        print("mypy is not installed")
        sys.exit(77)
    unittest.main(verbosity=2)
