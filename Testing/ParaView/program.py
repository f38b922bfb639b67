# SPDX-License-Identifier: BSD-3-Clause
"""Plays a script of events in the ParaView program, and reads its pictures."""
import os
import subprocess
import sys
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def need_display():
    if not os.environ.get("DISPLAY"):
        print("no DISPLAY: the program was not started")
        sys.exit(77)


def play(program, events, folder, *options):
    """Plays the events with clean settings and $PARAVIEW_TEST_ROOT = folder. The program must end without an error."""
    played = subprocess.run([program, "--dr", *options, "--test-script=" + events, "--test-directory=" + str(folder), "--exit"],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=800, check=False)
    print(played.stdout)
    assert played.returncode == 0, played.returncode


def pixels(picture):
    """A row of red, green, blue (integers) for each pixel of a .png."""
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
