# SPDX-License-Identifier: BSD-3-Clause
"""The pictures show the place of contact, and summary and trajectory name the same moments."""
import os
import re
import signal
import subprocess
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkmodules.vtkIOImage import vtkPNGReader

import bodies
from own_display import OwnDisplay
from session import PALPATE, PICTURES, TIME_OUT, SessionCase
from test_trajectory import read

RADIUS = 20.0                      # mm, of the ball
WELL, FLOOR, RIM = 30.0, -45.0, 45.0  # mm: inner radius and ends of the wall around the ball


def ball_in_a_well():
    """The usual view is 58 degrees from the normal at the top of the ball. The wall hides this place from directions of
    more than arctan(WELL / (RIM - RADIUS)) = 50 degrees."""
    disk = vtkDiskSource()
    disk.SetInnerRadius(WELL)
    disk.SetOuterRadius(WELL + 3.0)
    disk.SetCircumferentialResolution(64)
    wall = vtkLinearExtrusionFilter()
    wall.SetInputConnection(disk.GetOutputPort())
    wall.SetExtrusionTypeToVectorExtrusion()
    wall.SetVector(0.0, 0.0, RIM - FLOOR)
    wall.Update()
    moved = vtkPolyData()
    moved.DeepCopy(wall.GetOutput())
    for i in range(moved.GetNumberOfPoints()):
        x, y, z = moved.GetPoint(i)
        moved.GetPoints().SetPoint(i, x, y, z + FLOOR)
    both = vtkAppendPolyData()
    both.AddInputData(bodies.sphere(RADIUS))
    both.AddInputData(moved)
    outward = vtkPolyDataNormals()
    outward.SetInputConnection(both.GetOutputPort())
    outward.SplittingOff()
    outward.ConsistencyOn()
    outward.AutoOrientNormalsOn()
    outward.Update()
    return outward.GetOutput()


def dent_pixels(path):
    """Number of pixels with a colour of the dent, left of the legends. These colours are between the grey of the body
    and violet: red is 50 to 120 levels above blue, and the colour is light, unlike the arrow."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    color = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1).astype(int)
    color = color[:, :4 * width // 5]
    above = color[..., 0] - color[..., 2]
    return int(((above > 50) & (above < 120) & (color[..., 1] > 110)).sum())


class View(SessionCase):
    @unittest.skipUnless(OwnDisplay.is_there(), "needs Xvfb")
    def test_a_window_fits_the_screen(self):
        """The window is not larger than the screen, so that the whole window is visible. A signal ends the session."""
        display = OwnDisplay("1100x700")
        self.addCleanup(display.kill)
        picture = self.folder / "window.png"
        with subprocess.Popen([PALPATE, "--window", "--scene", "cylinder", "--screenshot", str(picture)], text=True,
                              env={**os.environ, "DISPLAY": display.name}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT) as program:
            self.assertTrue(any(line.startswith("tool: ") for line in program.stdout))  # the session runs
            program.send_signal(signal.SIGTERM)
            program.communicate(timeout=TIME_OUT)
        reader = vtkPNGReader()
        reader.SetFileName(str(picture))
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        self.assertEqual(width, 1100)
        self.assertTrue(600 <= height <= 700, height)   # leaves space for a title

    def test_a_contact_in_a_well_is_seen(self):
        self.press(ball_in_a_well(), "well.vtp", "--site", "0,0,1", "--slide-to", "0.05,0,1", pictures=PICTURES)
        # At least half of the dent. The dent is a circle of 4 mm; the wall of 66 mm fills two
        # thirds of the picture.
        self.assertGreater(dent_pixels(self.output / "overview.png"), 500)

    def test_summary_names_the_moments(self):
        """Time, place and force of the peak and of the pictures are those of trajectory.csv."""
        felt = self.press(bodies.sphere(), "ball.vtp", "--site", "0,0,1", "--slide-to", "0.5,0,1", pictures=PICTURES)
        _, table = read(self.output / "trajectory.csv")
        moment = r"at ([\d.]+) s, (-?[\d.]+), (-?[\d.]+), (-?[\d.]+) mm$"
        for line, digits in ((r"peak +force ([\d.e+-]+) N, deflection [\d.e+-]+ mm, ", 4),
                             (r"pictures +force ([\d.e+-]+) N, ", 4)):
            with self.subTest(line=line):
                found = re.search(r"(?m)^  " + line + moment, felt.stdout)
                self.assertTrue(found, felt.stdout)
                force, time, *place = map(float, found.groups())
                row = numpy.abs(table["time_s"] - time).argmin()
                self.assertAlmostEqual(table["time_s"][row], time, delta=6e-4)
                self.assertAlmostEqual(table["ideal_force_N"][row], force, delta=0.6 * 10.0 ** (1 - digits) * force)
                for axis, value in zip("xyz", place):
                    self.assertAlmostEqual(table[f"contact_{axis}_mm"][row], value, delta=0.051)  # one decimal
        peak = float(re.search(r"peak +force ([\d.e+-]+) N", felt.stdout).group(1))
        self.assertAlmostEqual(table["ideal_force_N"].max(), peak, delta=1e-3 * peak)

    def test_the_cause_is_that_of_the_largest_error(self):
        """Under a flat end of radius a the error by the ball's own deflection is 0.46 a/R = 2.9 % at every depth. The
        error by small strain is 0.2 (2 d/(pi a)), which is larger from d = 0.37 mm on. The validity (5 %) ends at 0.26
        mm, where the deflection of the ball is the larger part."""
        path = bodies.write(bodies.sphere(25.0), self.folder / "ball.vtp")
        for depth, cause in (("0.2", "curvature of the body"), ("1.2", "strain")):
            with self.subTest(depth=depth):
                felt = self.succeed(path, "--tool", "flat:1.6", "--young", "0.1", "--poisson", "0.3", "--depth", depth,
                                    "--max-deflection", "1.5")
                self.assertRegex(felt.stdout, rf"(?m)^  error .*mainly due to {cause}(;|$)")


if __name__ == "__main__":
    unittest.main()
