# SPDX-License-Identifier: BSD-3-Clause
"""Evaluates a saved body with numpy alone, without the filters: prints force and stiffness at a point.

    ./run python Plugin/Python/examples/read_contract.py BODY.vtp [RESPONSE [POINT]]

For a body that attach_responses.py has saved: ./run python ... read_contract.py ball.vtp Finger 100. If Palpate is
installed, palpate.curves("ball.vtp", 100, name="Finger") does the same.
"""
import sys
import numpy as np
from palpate import contract
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

reader = vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
name = sys.argv[2] if len(sys.argv) > 2 else "Response"
point = int(sys.argv[3]) if len(sys.argv) > 3 else 0
response = contract.load(reader.GetOutput(), name)          # a dictionary of numpy arrays
deflection = np.linspace(0, response["range"][point], 9)
force, stiffness = contract.evaluate(response, point, deflection)
for row in zip(deflection, force, stiffness):
    print("%.3f mm  %.6f N  %.6f N/mm" % row)
