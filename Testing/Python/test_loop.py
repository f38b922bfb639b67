#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A slab of liver pressed 5 mm at 1 mm/s has the loop of Data/Reference/rate/loops_paper.csv, both probed along a path
with times and in a session in virtual time."""
import csv
import unittest
from pathlib import Path

import numpy as np
import palpate
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

DEPTH, ABOVE = 5.0, 0.25                                    # mm, at 1 mm/s
LIVER = [(0.5, 0.5), (0.5, 10)]
TABLE = Path(__file__).parents[2] / "Data/Reference/rate/loops_paper.csv"


def slab(radius, relax=LIVER):
    corners = np.array([[-30, -30, 0], [30, -30, 0], [0, 30, 0]], dtype=float)
    return palpate.response((corners, np.array([[0, 1, 2]])), "paraboloid:%g" % radius, young=0.01, poisson=0.5, layer=10,
                            maximum_deflection=DEPTH, samples=16, relax=relax)


def expected(radius):
    """Ratios: peak force to the slow peak force, energy loss to work, depth at the end of contact to the largest
    depth."""
    with open(TABLE, encoding="utf-8", newline="") as table:
        for row in csv.DictReader(table):
            if row["press"] == "liver slab h=10 R=%g to 5 mm" % radius and row["preset"].startswith("liver") \
                    and row["v_mm_s"] == "1":
                return [float(row[name]) for name in ("F_peak/f", "loss/W_load", "liftoff_depth/delta_max")]
    raise AssertionError("no such row")


def loop(deflection, force, slow):
    way = np.diff(deflection)
    work = way * (force[1:] + force[:-1]) / 2
    return force.max() / slow.max(), work.sum() / work[way > 0].sum(), deflection[-1] / DEPTH


class LiverSlab(unittest.TestCase):
    def check(self, radius, deflection, force, memory):
        peak, loss, end = expected(radius)
        found = loop(deflection, force, force - memory)
        # The slow curve has sixteen samples, and there are sixteen elements. Their errors are less
        # than a hundredth of the peak.
        self.assertAlmostEqual(found[0], peak, delta=0.01 * peak)
        self.assertAlmostEqual(found[1], loss, delta=0.01)
        self.assertAlmostEqual(found[2], end, delta=0.005)

    def test_probed_along_a_path_with_times(self):
        for radius in (6.35, 1.6):
            body = slab(radius)
            for rate in (1000, 100):
                time = np.arange(int(2 * DEPTH * rate)) / rate
                tips = np.stack([0 * time, 0 * time, np.abs(time - DEPTH) - DEPTH], axis=1)
                felt = palpate.probe(body, tips, path=True, time=time)
                touches = felt.contact_cell >= 0
                self.check(radius, felt.deflection[touches], felt.normal_force[touches], felt.memory[touches])

    def test_felt_by_a_session_in_virtual_time(self):
        for radius in (6.35, 1.6):
            recording = self.recorded(slab(radius))
            arrays = [vtk_to_numpy(recording.GetPointData().GetArray(name))
                      for name in ("ContactCell", "Deflection", "NormalForce", "MemoryForce")]
            self.check(radius, *(array[arrays[0] >= 0] for array in arrays[1:]))

    def test_nothing_is_told_where_nothing_relaxes(self):
        self.assertFalse(self.recorded(slab(6.35, ())).GetPointData().HasArray("MemoryForce"))

    @staticmethod
    def recorded(body):
        path, points = vtkPolyData(), vtkPoints()
        points.SetDataTypeToDouble()
        for height in (ABOVE, -DEPTH, ABOVE):
            points.InsertNextPoint(0, 0, height)
        path.SetPoints(points)
        times = numpy_to_vtk(np.array([0, ABOVE + DEPTH, 2 * (ABOVE + DEPTH)]), deep=True)
        times.SetName("Time")
        path.GetPointData().AddArray(times)
        session = palpate.vtkHapticSession()
        session.SetBody(body)
        session.GetDevice().SetPath(path)
        assert session.Start()
        session.Step(2 * (ABOVE + DEPTH))
        recording = vtkPolyData()
        session.GetRecorder().GetRecording(recording)
        return recording


if __name__ == "__main__":
    unittest.main()
