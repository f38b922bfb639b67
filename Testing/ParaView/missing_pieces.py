# SPDX-License-Identifier: BSD-3-Clause
"""Without the module Pieces, a filter on two processes ends with an error that names the library of the module. On one
process the filter does not need it.

    missing_pieces.py FOLDER MPIEXEC PVBATCH MECHANICS    runs itself in pvbatch; FOLDER gets only the loading library
"""
import os
import shutil
import subprocess
import sys


def update():
    """Runs in pvbatch: prints the first error of each filter on a piece of a plane."""
    from palpate import vtkBodySurface, vtkContactRegime, vtkContactTool, vtkToolContactResponse
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter
    from vtkmodules.vtkFiltersSources import vtkPlaneSource
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    controller = vtkMultiProcessController.GetGlobalController()
    plane, triangles = vtkPlaneSource(), vtkTriangleFilter()
    plane.SetOrigin(20 * controller.GetLocalProcessId(), 0, 0)
    plane.SetPoint1(20 * controller.GetLocalProcessId() + 20, 0, 0)
    plane.SetPoint2(20 * controller.GetLocalProcessId(), 20, 0)
    triangles.SetInputConnection(plane.GetOutputPort())
    for algorithm in (vtkBodySurface(), vtkToolContactResponse(), vtkContactRegime()):
        errors = []

        def note(_, event, text="", errors=errors):
            errors.append(text)
        note.CallDataType = "string0"
        for who in (algorithm, algorithm.GetExecutive()):
            who.AddObserver("ErrorEvent", note)
        if not isinstance(algorithm, vtkBodySurface):
            algorithm.SetTool(vtkContactTool())
        if isinstance(algorithm, vtkContactRegime):
            algorithm.SetDeflection(1)
        algorithm.SetInputConnection(triangles.GetOutputPort())
        algorithm.Update()
        said = (errors or ["nothing"])[0].replace("\n", " ")
        print(f"{algorithm.GetClassName()} said: {said}\n", end="", flush=True)  # in one piece
        controller.Barrier()


def main(folder, mpiexec, pvbatch, mechanics):
    libraries = os.path.join(folder, "missing_pieces")
    os.makedirs(libraries, exist_ok=True)
    # The library under its soname.
    shutil.copy(mechanics, os.path.join(libraries, os.path.basename(mechanics).rsplit(".", 1)[0]))
    path = ":".join(filter(None, (libraries, os.environ.get("LD_LIBRARY_PATH"))))
    for ranks in (1, 2):
        done = subprocess.run([mpiexec, "--allow-run-as-root", "--oversubscribe", "-np", str(ranks), pvbatch, "--dr", "--sym",
                               os.path.abspath(__file__)], env={**os.environ, "LD_LIBRARY_PATH": path},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
        said = [line for line in done.stdout.splitlines() if " said: " in line]
        assert done.returncode == 0 and len(said) == 3 * ranks, done.stdout
        for line in said:
            if ranks == 1:
                assert line.endswith("said: nothing"), line
            else:
                assert "a body on 2 processes" in line and "libpalpatePieces.so" in line and "./run build" in line, line
    print("done")


if len(sys.argv) > 1:
    main(*sys.argv[1:])
else:
    update()
