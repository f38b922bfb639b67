#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""--tissue: a segmentation is filled, solved and shown as a map of the force."""
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest

import bodies
import numpy
from session import CACHE, PALPATE, TIME_OUT, SessionCase, run

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "Python"))
import palpate
from labels import block, write_nifti
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

SIZE, SPACING = (16, 16, 8), 2.0                    # voxels; mm
TISSUES = ("--tissue", "1:0.05:0.45", "--tissue", "2:0.5:0.4")
TERMS = ("--solid", "6", "--strain", "small", "--tool", "sphere:3", "--max-deflection", "0.6", "--depth", "0.5")


class Tissue(SessionCase):
    def setUp(self):
        super().setUp()
        self.labels = self.folder / "labels.nii.gz"
        write_nifti(self.labels, block(SIZE, SPACING, ball=(15, 15, 4, 4), margin=2),
                    [[SPACING, 0, 0, -4], [0, SPACING, 0, -4], [0, 0, SPACING, -4]])

    def saved(self, file):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(file))
        reader.Update()
        return reader.GetOutput()

    def test_its_responses_are_those_of_python(self):
        """Program and package use the same filters with the same defaults, so the bits are the same. The ball changes
        the force."""
        for solved in pathlib.Path(CACHE.name).glob("palpate/tissues-*.vtp"):
            solved.unlink()
        file = self.folder / "felt.vtp"
        first = self.succeed(self.labels, *TISSUES, *TERMS, "--save", file, "--fixed", "z-")
        self.assertIn("finer in 1 enclosed region", first.stderr)
        self.assertIn("label 2: E = 0.5 MPa, nu = 0.4", first.stdout)
        felt = self.saved(file)
        body = palpate.response(self.labels, "sphere:3", tissues={1: (0.05, 0.45), 2: (0.5, 0.4)}, spacing=6,
                                maximum_deflection=0.6)
        for name in ("Force", "Stiffness", "Range", "Validity", "Status", "Error"):
            here, there = (vtk_to_numpy(each.GetPointData().GetArray("Response" + name)) for each in (felt, body))
            numpy.testing.assert_array_equal(here, there, name)
        points = vtk_to_numpy(body.GetPoints().GetData())
        force = palpate.curves(body, deflection=0.5).force[:, 0]
        upper = points[:, 2] > points[:, 2].max() - 0.6            # without the rounded edges
        away = numpy.hypot(points[:, 0] - 15, points[:, 1] - 15)
        # Balls of 3 and 5 mm radius, 4 mm deep and ten times as hard, increase the force by 6 to 10
        # % and 11 to 23 % (nodule.md).
        self.assertGreater(numpy.nanmax(force[upper & (away < 2)]),
                           1.06 * numpy.nanmedian(force[upper & (away > 8) & (away < 11)]))
        again = self.succeed(self.labels, *TISSUES, *TERMS)
        self.assertIn("taken from the cache", again.stderr)
        other = self.succeed(self.labels, *TISSUES[:2], "--tissue", "2:0.6:0.4", *TERMS)
        self.assertNotIn("taken from the cache", other.stderr)

    def test_the_map(self):
        result = run(self.labels, *TISSUES, *TERMS, "--map", "--output", self.output, "--save", self.folder / "felt.vtp")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(set(self.files()), {"map.png"})
        self.check_largest(result.stdout, self.saved(self.folder / "felt.vtp"))

    def check_largest(self, printed, body):
        """The largest force of the map is that of the points whose error is below 100 %, and which are farther from all
        held points than two contact radii of the sphere."""
        found = re.search(r"largest force ([\d.]+) N ± \d+ %\s+at (-?[\d.]+), (-?[\d.]+), (-?[\d.]+) mm\s+"
                          r"\(without the places within ([\d.]+) mm\s+of the held part\)", printed)
        self.assertTrue(found, printed)
        force, *place, distance = map(float, found.groups())
        radius = distance / 2
        depth = radius / 2 * math.log((3 + radius) / (3 - radius))   # depth for a rigid sphere (Sneddon 1965)
        self.assertAlmostEqual(depth, 0.5, delta=0.01)               # the distance has three digits
        points = vtk_to_numpy(body.GetPoints().GetData())
        held = points[vtk_to_numpy(body.GetPointData().GetArray("Fixed")) != 0]
        away = numpy.linalg.norm(points[:, None] - held[None], axis=2).min(axis=1) > distance
        curves = palpate.curves(body, deflection=0.5)
        known = numpy.isfinite(curves.force[:, 0]) & (self.errors(body) < 1.0)
        self.assertGreater((known & ~away).sum(), 0)
        self.assertAlmostEqual(force, curves.force[known & away, 0].max(), delta=1e-3 * force)
        nearest = numpy.linalg.norm(points - place, axis=1).argmin()
        self.assertTrue(away[nearest])
        self.assertAlmostEqual(curves.force[nearest, 0], force, delta=1e-3 * force)

    def errors(self, body):
        """Relative error at 0.5 mm of each point; NaN at points without a force."""
        mapped = palpate.vtkForceMap()
        mapped.SetInputData(body)
        mapped.SetDepth(0.5)
        mapped.Update()
        return vtk_to_numpy(mapped.GetOutput().GetPointData().GetArray("ErrorAtDepth"))

    def test_without_an_output_it_opens_a_window(self):
        result = run(self.labels, *TISSUES, *TERMS, environment={"DISPLAY": None})
        self.assertEqual(result.returncode, 1)
        self.assertIn("X server", result.stderr)
        environment = {**os.environ, "XDG_CACHE_HOME": CACHE.name}
        with subprocess.Popen([PALPATE, str(self.labels), *TISSUES, *TERMS], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              env=environment, text=True) as process:
            shown = iter(process.stdout.readline, "")
            printed = [line for line in iter(lambda: next(shown, "window open\n"), "window open\n")]
            is_open = process.poll() is None
            process.terminate()
        self.assertTrue(is_open, printed)
        self.assertTrue(any("largest force" in line for line in printed), printed)

    def test_progress_on_a_terminal(self):
        reading, terminal = os.openpty()
        command = [PALPATE, str(self.labels), *TISSUES, *TERMS, "--no-pictures", "--output", str(self.output)]
        environment = {**os.environ, "XDG_CACHE_HOME": str(self.folder / "cache")}
        with subprocess.Popen(command, stderr=terminal, stdout=subprocess.DEVNULL, env=environment) as process:
            os.close(terminal)
            shown = b""
            try:
                while piece := os.read(reading, 4096):
                    shown += piece
            except OSError:                         # the program has closed its end
                pass
            self.assertEqual(process.wait(TIME_OUT), 0, shown)
        os.close(reading)
        for step in (b"the tissues are filled with tetrahedra", b"the tissues are solved under sphere:3"):
            self.assertRegex(shown, step + rb": +\d+ %")

    def test_faults(self):
        for arguments, words in (
                (("--tissue", "1:0.05:0.45", "--tissue", "3:0.5:0.4"), ("label 3 is not in the image", "0, 1, 2")),
                (("--tissue", "1:0.05:0.45", "--tissue", "1:0.5:0.4"), ("label 1 has two tissues",)),
                (("--tissue", "1:0.05:0.5"), ("0.5 does not lie between 0 and 0.499",)),
                (("--tissue", "1:0:0.4"), ("0 is not positive",)),
                (("--tissue", "1:0.05"), ("'1:0.05' is not LABEL:MPA:NU",)),
                (("--tissue", "skin:0.05:0.4"), ("skin",)),
                ((*TISSUES, "--young", "0.1"), ("--young",)),
                ((*TISSUES, "--layer", "3"), ("--layer",)),
                ((*TISSUES, "--tool", "cube:3"), ("cube",))):
            with self.subTest(arguments=arguments):
                self.refuse(self.labels, *arguments, words=words)
        surface = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        self.refuse(surface, *TISSUES, words=("ball.vtp", "needs an image of labels"))
        self.refuse(*TISSUES, words=("BODY",))
        self.refuse(self.folder / "nowhere.nii", *TISSUES, words=("nowhere.nii",))

    def test_a_label_of_empty_voxels_changes_nothing(self):
        """The image without the empty voxels around the block, and thus without label 0, gives the same forces."""
        alone = self.folder / "alone.nii"
        write_nifti(alone, block(SIZE, SPACING, ball=(15, 15, 4, 4)),
                    [[SPACING, 0, 0, 0], [0, SPACING, 0, 0], [0, 0, SPACING, 0]])
        largest = []
        for file in (alone, self.labels):
            saved = self.folder / "felt.vtp"
            self.succeed(file, *TISSUES, *TERMS, "--save", saved)
            largest.append(vtk_to_numpy(self.saved(saved).GetPointData().GetArray("ResponseForce")).max())
        self.assertGreater(largest[0], 0.0)
        # The bounding box differs, and with it the rounding of the places, so the bits differ.
        self.assertAlmostEqual(largest[0] / largest[1], 1.0, delta=0.02)


if __name__ == "__main__":
    unittest.main()
