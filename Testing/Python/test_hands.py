#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two devices of one session on a half-space. A press of the second reduces the force on the first, according to the
equations of two flat ends that lower each other's surface. Without coupling the forces do not change."""
import math
import unittest

import numpy as np
import palpate
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

YOUNG, POISSON, RADIUS, APART = 0.5, 0.45, 2.0, 6.0         # MPa, mm
MODULUS = YOUNG / (1 - POISSON**2)
SPRING = 2 * RADIUS * MODULUS                               # N/mm
MUTUAL = 1 / (math.pi * MODULUS * APART)                    # mm/N
FIRST, SECOND = 0.5, 0.8                                    # depths, mm


def plate(coupling):
    corners = np.array([[-30, -30, 0], [30, -30, 0], [0, 40, 0]], dtype=float)
    return palpate.response((corners, np.array([[0, 1, 2]])), "flat:%g" % RADIUS, young=YOUNG, poisson=POISSON,
                            maximum_deflection=1.0, coupling=coupling)


def path(x, way):
    line, points = vtkPolyData(), vtkPoints()
    points.SetDataTypeToDouble()
    for _, height in way:
        points.InsertNextPoint(x, 0, height)
    line.SetPoints(points)
    times = numpy_to_vtk(np.array([time for time, _ in way], dtype=float), deep=True)
    times.SetName("Time")
    line.GetPointData().AddArray(times)
    return line


class TwoDevices(unittest.TestCase):
    def forces(self, body):
        """Force on the first device alone, then on both devices."""
        session = palpate.vtkHapticSession()
        session.SetBody(body)
        session.GetDevice().SetPath(path(0, [(0, 1), (0.1, -FIRST), (1, -FIRST)]))
        self.assertEqual(session.AddDevice("simulated"), 1)
        session.GetDevice(1).SetPath(path(APART, [(0, 1), (0.2, 1), (0.3, -SECOND), (1, -SECOND)]))
        self.assertTrue(session.Start())
        session.Step(0.15)
        first, second, alone = [0.0] * 3, [0.0] * 3, [0.0] * 3
        session.GetForce(alone)
        session.Step(0.25)
        session.GetForce(0, first)
        session.GetForce(1, second)
        self.assertAlmostEqual(session.GetDeflection(1), second[2] / SPRING, delta=1e-5)
        recording = vtkPolyData()
        session.GetRecorder().GetRecording(recording, 1)
        self.assertEqual(recording.GetNumberOfPoints(), 400)
        return alone[2], first[2], second[2]

    def test_the_second_lifts_force_off_the_first(self):
        alone, first, second = self.forces(plate(True))
        expected = np.linalg.solve([[1 / SPRING, MUTUAL], [MUTUAL, 1 / SPRING]], [FIRST, SECOND])
        for found, right in zip((alone, first, second), (SPRING * FIRST, *expected)):
            self.assertAlmostEqual(found, right, delta=1e-5)    # curves are stored as floats
        self.assertAlmostEqual(alone - first, MUTUAL * second * SPRING, delta=1e-5)
        self.assertGreater(alone - first, 0.2)

    def test_not_without_coupling(self):
        alone, first, second = self.forces(plate(False))
        self.assertEqual(alone, first)
        self.assertAlmostEqual(second, SPRING * SECOND, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
