# SPDX-License-Identifier: BSD-3-Clause
"""The example many_tools_mpi.py prints the same on one process and on two.

    many_tools.py FOLDER MPIEXEC PVBATCH SCRIPT
"""
import os
import subprocess
import sys
import raw_xml
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLPPolyDataReader

FOLDER, MPIEXEC, PVBATCH, SCRIPT = sys.argv[1:]


def forces(ranks, *arguments):
    command = [MPIEXEC, "--allow-run-as-root", "--oversubscribe", "-np", str(ranks), PVBATCH, "--dr", SCRIPT]
    done = subprocess.run(command + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=800)
    assert done.returncode == 0 and "ERR|" not in done.stdout, done.stdout
    rows = [line.split() for line in done.stdout.splitlines() if line.endswith(" N")]
    return {row[0]: [float(number) for number in row[1:-1]] for row in rows}


alone = forces(1)
assert set(alone) == {"Sphere", "Flat", "Cone"}, alone
# F = 2 E* (a d - a^3 / 3 R) of the flat punch on a ball of R = 50 mm. The ball's facets are up to
# 0.0063 mm deep (0.79 mm from the pole).
for depth, force in zip((0.5, 1.0, 1.5, 2.0), alone["Flat"][3:]):
    stiffness = 2 * 0.05 / (1 - 0.45 ** 2) * 3
    touched = depth - 3 ** 2 / (3 * 50)
    assert stiffness * (touched - 0.0063) < force < stiffness * touched, (depth, force)

raw_xml.need_raw_xml()
ball = os.path.join(FOLDER, "many_tools_ball.vtp")
output = os.path.join(FOLDER, "many_tools.pvtp")
source = vtkSphereSource()
source.SetRadius(50)
source.SetThetaResolution(200)
source.SetPhiResolution(200)
writer = vtkXMLPolyDataWriter()
writer.SetInputConnection(source.GetOutputPort())
writer.SetDataModeToBinary()
writer.SetFileName(ball)
writer.Write()
several = forces(2, ball, output)
assert several == alone, (several, alone)

reader = vtkXMLPPolyDataReader()
reader.SetFileName(output)
reader.Update()
assert reader.GetNumberOfPieces() == 2
saved = reader.GetOutput()
source.Update()
assert saved.GetNumberOfCells() == source.GetOutput().GetNumberOfCells()
for name in ("Sphere", "Flat", "Cone"):
    assert saved.GetPointData().GetArray(name + "Force").GetRange(7)[0] > 0
print("done")
