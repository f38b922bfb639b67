#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""vtkGradedBody and vtkVoxelBody: the sizes chosen from the body, and the same bits in every process."""
import hashlib
import math
import subprocess
import sys
import unittest

from palpate import vtkGradedBody, vtkVoxelBody
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

HELD = ("z-:2,x-:3", "x-:3,x+:3,z-:2,y-:1")
PROCESSES = 5


def box():
    """A box of 30 x 30 x 20 mm, in triangles of some mm whose corners lie on common circles."""
    cube = vtkCubeSource()
    cube.SetXLength(30)
    cube.SetYLength(30)
    cube.SetZLength(20)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(cube.GetOutputPort())
    finer = vtkLinearSubdivisionFilter()
    finer.SetNumberOfSubdivisions(2)
    finer.SetInputConnection(triangles.GetOutputPort())
    finer.Update()
    return finer.GetOutput()


def ball(radius):
    sphere = vtkSphereSource()
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(80)
    sphere.SetPhiResolution(80)
    sphere.Update()
    return sphere.GetOutput()


def filled(kind, body, **settings):
    solid = kind()
    solid.SetInputData(body)
    for name, value in settings.items():
        getattr(solid, "Set" + name)(value)
    solid.Update()
    return solid


def digests():
    """A line for each case: number of cells, and a digest of points and cells."""
    lines = []
    for name, body in (("box", box()), ("ball", ball(20.0))):
        for held in HELD:
            cells = filled(vtkGradedBody, body, SurfaceSpacing=4.0, FixedFaces=held).GetOutput()
            bits = vtk_to_numpy(cells.GetPoints().GetData()).tobytes() + \
                vtk_to_numpy(cells.GetCells().GetConnectivityArray()).tobytes()
            lines.append("%s %s %d %s" % (name, held, cells.GetNumberOfCells(), hashlib.sha256(bits).hexdigest()))
    return lines


class SameBits(unittest.TestCase):
    """Cuts at several sides. In an earlier version the order of the triangles of each cut depended on memory addresses,
    which differ between processes and runs."""

    def test_in_several_processes(self):
        found = [subprocess.run([sys.executable, __file__, "--digests"], capture_output=True, text=True, check=True).stdout
                 for _ in range(PROCESSES)]
        self.assertEqual(found[0].count("\n"), 2 * len(HELD), found[0])
        self.assertEqual(len(set(found)), 1, found)

    def test_in_one_process(self):
        kept = []                                       # occupies memory, so that addresses differ
        first = digests()
        kept.append([bytes(1000) for _ in range(10000)])
        self.assertEqual(digests(), first)


class ChosenSizes(unittest.TestCase):
    def test_tetrahedra_follow_the_body(self):
        self.assertEqual(vtkGradedBody().GetSurfaceSpacing(), 0.0)
        for radius in (5.0, 70.0):
            solid = filled(vtkGradedBody, ball(radius))
            # sqrt(8.7 area / 20,000) of a ball. The facets have 0.3 % less area.
            self.assertAlmostEqual(solid.GetUsedSpacing() / radius, math.sqrt(8.7 * 4 * math.pi / 20000), delta=3e-4)
            # 8.7 cells per cube is a mean over balls, with a tolerance of a fifth.
            count = solid.GetOutput().GetNumberOfCells()
            self.assertLess(abs(count / solid.GetCellEstimate() - 1), 0.2, (radius, count))
            self.assertLess(5000, count)
            self.assertLess(count, 25000)

    def test_a_flat_body_has_no_more_cells(self):
        solid = filled(vtkGradedBody, box())
        area, volume = 2 * (30 * 30 + 2 * 30 * 20), 30 * 30 * 20
        expected = min(math.sqrt(8.7 * area / 20000), volume ** (1 / 3) / 6)
        self.assertAlmostEqual(solid.GetUsedSpacing(), expected, delta=1e-9 * expected)

    def test_given_sizes_are_kept(self):
        self.assertEqual(filled(vtkVoxelBody, ball(20.0), Spacing=2.5).GetUsedSpacing(), 2.5)
        self.assertEqual(filled(vtkGradedBody, ball(20.0), SurfaceSpacing=5.0).GetUsedSpacing(), 5.0)

    def test_voxels_follow_the_body(self):
        self.assertEqual(vtkVoxelBody().GetSpacing(), 0.0)
        for radius in (5.0, 70.0):
            solid = filled(vtkVoxelBody, ball(radius), Conform=False)
            # The cube root of the volume / 10,000. The facets have 0.3 % less volume.
            self.assertAlmostEqual(solid.GetUsedSpacing() / radius, (4 / 3 * math.pi / 10000) ** (1 / 3), delta=1e-4)
            # Voxels with all corners inside. Partial voxels at the surface are missing: half of a
            # layer, for 22 voxels per diameter.
            count = solid.GetOutput().GetNumberOfCells()
            self.assertLess(6000, count, radius)
            self.assertLess(count, 10000, radius)


if __name__ == "__main__":
    if "--digests" in sys.argv:
        print("\n".join(digests()))
    else:
        unittest.main()
