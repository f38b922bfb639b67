#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Segmentations: vtkSegmentedBody, its responses, vtkForceMap and palpate.response(..., tissues=...)."""
import math
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np
import palpate
from labels import block, image, top, write_nifti
from palpate import _filters
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource

SOFT, HARD = (0.1, 0.45), (1.0, 0.45)               # MPa, Poisson's ratio
DEPTH = 0.8                                         # mm


def filled(labels, spacing, tissues, cells, fixed="z-", kind=RuntimeError):
    """vtkSegmentedBody of an array of labels, or of an image."""
    made = palpate.vtkSegmentedBody()
    made.SetInputData(image(labels, spacing) if isinstance(labels, np.ndarray) else labels)
    for label, material in tissues.items():
        made.AddTissue(label, *material)
    made.SetSurfaceSpacing(cells)
    made.SetFixedFaces(fixed)
    return _filters.run(made, kind)


def pressed(solid, tool, places, sources):
    """The responses within a contact of places on the upper face. Returns the force and the error at these places, at
    DEPTH."""
    grid = solid.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    near = np.min([np.hypot(points[:, 0] - x, points[:, 1] - y) for x, y in places], axis=0) < 4
    choice = numpy_to_vtk(near.astype(np.uint8), deep=True)
    choice.SetName("Pressed")
    grid.GetPointData().AddArray(choice)
    kind = palpate.vtkContactTool()
    kind.SetSpecification(tool)
    felt = palpate.vtkElasticContactResponse()
    felt.SetInputData(grid)
    felt.SetInputArrayToProcess(0, 0, 0, 1, "YoungsModulus")
    felt.SetInputArrayToProcess(1, 0, 0, 1, "PoissonRatio")
    felt.SetTool(kind)
    felt.SetMaximumDeflection(DEPTH)
    felt.SetSourceSpacing(sources)
    felt.StoreMotionOff()
    body = _filters.run(felt, RuntimeError, expected="have no response").GetOutput()
    points = vtk_to_numpy(body.GetPoints().GetData())
    found = []
    for x, y in places:
        below = points[:, 2].max() - points[:, 2]       # 0 on the upper face
        distance = np.hypot(points[:, 0] - x, points[:, 1] - y) + 10 * below
        curve = palpate.curves(body, int(np.argmin(distance)), deflection=DEPTH)
        found.append((curve.force[0], curve.error[0]))
    return found


class Forces(unittest.TestCase):
    def test_a_block_is_a_layer(self):
        """A block of one tissue, 24 mm thick and 64 mm wide, on its fixed base has the law of a bonded layer.

        Its free sides are 32 mm away, which is more than its thickness, and soften it by less than 1 %. The voxels
        place its faces to 0.1 mm, which changes the force by 1 % through the thickness. Elements as long as a sixth of
        the thickness have an error of about 1 %.
        """
        size, spacing = (64, 64, 24), 1.0
        solid = filled(block(size, spacing), spacing, {1: SOFT}, cells=4)
        (force, error), = pressed(solid, "sphere:6.35", [(31.5, 31.5)], 2)
        flat = (40 * np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [0, 0, 0]]),
                np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]))
        layer = palpate.response(flat, "sphere:6.35", *SOFT, layer=24.0, maximum_deflection=DEPTH, curvature=False)
        expected = palpate.curves(layer, 4, deflection=DEPTH).force[0]
        self.assertAlmostEqual(force / expected, 1.0, delta=0.03)
        self.assertLess(abs(force / expected - 1.0), error + 0.02)   # the stated error, plus 0.02 for shape and sides
        half_space = 4 / 3 * SOFT[0] / (1 - SOFT[1] ** 2) * math.sqrt(6.35) * DEPTH ** 1.5  # Hertz; the layer is stiffer
        self.assertGreater(force, half_space)

    def test_a_hard_ball_is_felt(self):
        """A ball of 3 mm radius, ten times as hard, whose top is 2 mm deep, increases the force on a sphere by 24.0 %.

        The sphere has a radius of 1.6 mm. The number is from axisymmetric finite elements that follow the ball, by
        another code (Data/Studies/nodule/nodule.md). Cells as long as half the depth of a ball have an error of 5 % of
        the force (vtkElasticContactResponse). The voxels place the ball's top to half their side, 0.25 mm; the force
        changes by 16 % per mm there.
        """
        size, spacing, ball = (80, 80, 40), 0.5, (20.0, 20.0, 2.0, 3.0)
        walls = "z-,x-,x+,y-,y+"
        lump = filled(block(size, spacing, ball), spacing, {1: SOFT, 2: HARD}, 4, walls)
        self.assertEqual(lump.GetNumberOfFineRegions(), 1)
        (above, _), (beside, _) = pressed(lump, "sphere:1.6", [(20.0, 20.0), (10.0, 10.0)], 1.5)
        without = filled(block(size, spacing, ball), spacing, {1: SOFT, 2: SOFT}, 4, walls)
        (same, _), = pressed(without, "sphere:1.6", [(20.0, 20.0)], 1.5)
        self.assertAlmostEqual(above / same, 1.240, delta=0.05 * 1.24 + 0.25 * 0.16)
        self.assertGreater(above / beside, 1.15)
        # Next to the lump the force equals the force without a lump. The cells are longer there,
        # which gives an error of 3 %.
        self.assertAlmostEqual(beside / same, 1.0, delta=0.03)

    def test_the_label_of_empty_voxels_needs_no_row(self):
        """With and without empty voxels around it, the block is the same body."""
        size, spacing = (16, 16, 10), 2.0
        alone = filled(block(size, spacing), spacing, {1: SOFT}, 8).GetOutput()
        around = filled(image(block(size, spacing, margin=3), spacing, (-6.0, -6.0, -6.0)), spacing, {1: SOFT}, 8).GetOutput()
        for get in ("GetPoints", ):
            np.testing.assert_allclose(*(vtk_to_numpy(each.GetPoints().GetData()) for each in (alone, around)), atol=1e-4)
        for each in (alone, around):
            moduli = vtk_to_numpy(each.GetCellData().GetArray("YoungsModulus"))
            np.testing.assert_allclose(moduli, SOFT[0], rtol=1e-12)  # the empty voxels around a cell do not soften it
            self.assertEqual(vtk_to_numpy(each.GetPointData().GetArray("Fixed")).max(), 7)


class Body(unittest.TestCase):
    def volume(self, grid):
        points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        corners = points[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 10)[:, :4]]
        a, b, c = (corners[:, i] - corners[:, 0] for i in (1, 2, 3))
        return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6

    def test_the_affine_of_a_file(self):
        """Axes that are rotated, mirrored and scaled: the body has the position that the header gives, and its
        volume."""
        size = (20, 12, 10)
        affine = np.array([[0, -2.0, 0, 50], [1.5, 0, 0, -20], [0, 0, 3.0, 7]])      # x of the file is y of the body
        labels = block(size, 1.0, margin=2)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "labels.nii.gz"
            write_nifti(file, labels, affine)
            reader = palpate.vtkBodyFileReader()
            reader.SetFileName(str(file))
            reader.Update()
            self.assertEqual(reader.GetFault(), "")
            grid = filled(reader.GetOutput(), None, {1: SOFT}, 6).GetOutput()
        corners = np.array([affine @ [i, j, k, 1] for i in (1.5, 21.5) for j in (1.5, 13.5) for k in (1.5, 11.5)])
        bounds = np.reshape(grid.GetBounds(), (3, 2))
        # Smoothing moves edges by a fraction of a voxel.
        np.testing.assert_allclose(bounds, np.array([corners.min(0), corners.max(0)]).T, atol=1.0)
        self.assertAlmostEqual(self.volume(grid) / (20 * 12 * 10 * 9.0), 1.0, delta=0.05)

    def test_layers_have_their_materials(self):
        labels = block((16, 16, 10), 2.0)
        labels[6:] = 7
        grid = filled(labels, 2.0, {1: SOFT, 7: (2.0, 0.3)}, 3).GetOutput()
        moduli = vtk_to_numpy(grid.GetCellData().GetArray("YoungsModulus"))
        height = np.array([grid.GetCell(i).GetBounds()[4:] for i in range(grid.GetNumberOfCells())])
        interface = 2.0 * 5.5                           # mm: half-way between the voxels 5 and 6
        np.testing.assert_allclose(moduli[height[:, 1] < interface], SOFT[0], rtol=1e-12)
        np.testing.assert_allclose(moduli[height[:, 0] > interface], 2.0, rtol=1e-12)
        self.assertTrue(((moduli >= SOFT[0]) & (moduli <= 2.0)).all())

    def test_cavities_remain_and_specks_go(self):
        labels = block((24, 24, 24), 1.0)
        labels[8:16, 8:16, 8:16] = 0                    # a cavity of 512 mm³
        grid = filled(labels, 1.0, {1: SOFT}, 3).GetOutput()
        self.assertAlmostEqual(self.volume(grid) / (24 ** 3 - 512), 1.0, delta=0.03)
        labels = block((24, 24, 24), 1.0)
        labels[12, 12, 12] = 0                          # one voxel without a label
        whole = filled(labels, 1.0, {1: SOFT}, 4).GetOutput()
        np.testing.assert_allclose(self.volume(whole) / 24 ** 3, 1.0, atol=0.03)
        np.testing.assert_allclose(vtk_to_numpy(whole.GetCellData().GetArray("YoungsModulus")), SOFT[0], rtol=1e-12)

    def test_islands_are_left_out_with_a_warning(self):
        labels = np.zeros((12, 12, 30), np.int16)
        labels[:, :, :12] = 1
        labels[:, :, 24:] = 1                           # a third of the voxels
        with self.assertWarnsRegex(RuntimeWarning, r"not connected: 33\.\d* % of their voxels"):
            grid = filled(labels, 2.0, {1: SOFT}, 6).GetOutput()
        self.assertLess(grid.GetBounds()[1], 25.0)

    def test_finer_cells_cost_no_more_than_the_surface(self):
        """The cells of many small regions just below the surface are longer than half the depth of the regions."""
        labels = block((40, 40, 20), 1.0)
        for x in range(4, 36, 8):
            for y in range(4, 36, 8):
                labels[14:17, y:y + 3, x:x + 3] = 2
        made = filled(labels, 1.0, {1: SOFT, 2: HARD}, 6)
        self.assertGreater(made.GetNumberOfFineRegions(), 0)
        self.assertLess(made.GetOutput().GetNumberOfCells(), 40000)


class Map(unittest.TestCase):
    def body(self, **other):
        source = vtkSphereSource()
        source.SetRadius(30)
        source.SetThetaResolution(20)
        source.SetPhiResolution(20)
        return palpate.response(source, "sphere:6.35", compliance=None, maximum_deflection=1.0, points=[0, 5, 9], **other)

    def test_it_is_the_force_of_the_curves(self):
        body = self.body()
        made = palpate.vtkForceMap()
        made.SetInputData(body)
        made.SetDepth(0.7)
        data = _filters.run(made).GetOutput().GetPointData()
        curves = palpate.curves(body, deflection=0.7)
        for name, expected in (("Force", curves.force), ("Stiffness", curves.stiffness), ("Error", curves.error)):
            # The map is stored in floats.
            np.testing.assert_allclose(vtk_to_numpy(data.GetArray(name + "AtDepth")), expected[:, 0], rtol=1e-5)
        self.assertEqual(data.GetScalars().GetName(), "ForceAtDepth")
        self.assertEqual(np.isfinite(curves.force).sum(), 3)

    def test_beyond_the_curve_there_is_no_force(self):
        made = palpate.vtkForceMap()
        made.SetInputData(self.body())
        for depth, known in ((1.0, 3), (1.001, 0)):
            made.SetDepth(depth)
            force = vtk_to_numpy(_filters.run(made).GetOutput().GetPointData().GetArray("ForceAtDepth"))
            self.assertEqual(np.isfinite(force).sum(), known)

    def test_faults(self):
        made = palpate.vtkForceMap()
        made.SetInputData(self.body(name="Punch"))
        with self.assertRaisesRegex(ValueError, "Wrong body: .*Response"):
            _filters.run(made)
        made.SetResponseName("Punch")
        for depth in (0.0, -1.0, math.nan):
            made.SetDepth(depth)
            with self.assertRaisesRegex(ValueError, "Depth must be positive and finite"):
                _filters.run(made)
        made.SetInputData(vtkPolyData())
        self.assertEqual(_filters.run(made).GetOutput().GetNumberOfPoints(), 0)


class Response(unittest.TestCase):
    """palpate.response(..., tissues=...)."""

    LABELS = block((10, 10, 6), 3.0, margin=1)
    TISSUES = {1: SOFT}

    def test_a_file(self):
        steps = []
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("error")              # held points have no response, which must not give a warning
            file = Path(folder) / "labels.nii.gz"
            write_nifti(file, self.LABELS, [[3, 0, 0, -3], [0, 3, 0, -3], [0, 0, 3, -3]])
            body = palpate.response(file, "sphere:3", tissues=self.TISSUES, spacing=6, maximum_deflection=0.5, name="Punch",
                                    progress=lambda *step: steps.append(step))
        for step in ("filling the tissues", "solving"):
            done = [fraction for name, fraction in steps if name == step]
            self.assertEqual(done, sorted(done))
            self.assertEqual(done[-1], 1.0)
            self.assertGreater(len(done), 3)
        force = palpate.curves(body, deflection=0.4, name="Punch").force
        points = vtk_to_numpy(body.GetPoints().GetData())
        held = points[:, 2] < points[:, 2].min() + 1e-3
        self.assertTrue(np.isnan(force[held]).all())
        middle = np.hypot(points[:, 0] - 13.5, points[:, 1] - 13.5) - 10 * points[:, 2]
        hertz = 4 / 3 * SOFT[0] / (1 - SOFT[1] ** 2) * math.sqrt(3.0) * 0.4 ** 1.5
        # The block is 18 mm thick and the contact 1.1 mm wide, so the force is a few per cent
        # larger. The cells are as long as a third of the contact.
        self.assertAlmostEqual(force[np.argmin(middle), 0] / hertz, 1.04, delta=0.08)

    def refuses(self, kind, words, body=None, tissues=None, **other):
        with self.assertRaisesRegex(kind, words):
            palpate.response(image(self.LABELS, 3.0) if body is None else body, "sphere:3",
                             tissues=self.TISSUES if tissues is None else tissues, **other)

    def test_faults_of_the_tissues(self):
        self.refuses(ValueError, "label 2 is not in the image: its labels are 0, 1", tissues={1: SOFT, 2: HARD})
        self.refuses(ValueError, "label 1.*Poisson's ratio must lie between 0 and 0.499, but is 0.5", tissues={1: (0.1, 0.5)})
        self.refuses(ValueError, "label 1.*Young's modulus must be positive and finite .MPa., but is 0", tissues={1: (0, 0.4)})
        self.refuses(ValueError, "Tissues are required", tissues={})
        self.refuses(ValueError, r"tissues\[1\] must be \(young in MPa, poisson\)", tissues={1: 0.1})
        self.refuses(TypeError, "tissues must be a dictionary", tissues=[(1, 0.1, 0.45)])
        self.refuses(TypeError, "a label must be a number", tissues={"skin": SOFT})

    def test_a_label_twice(self):
        made = palpate.vtkSegmentedBody()
        made.SetInputData(image(self.LABELS, 3.0))
        made.AddTissue(1, *SOFT)
        made.AddTissue(1, *HARD)
        with self.assertRaisesRegex(ValueError, "Label 1 has two tissues"):
            _filters.run(made)
        self.assertEqual(made.GetOutput().GetNumberOfCells(), 0)

    def test_faults_of_the_image(self):
        grey = np.arange(1000, dtype=np.int16).reshape(10, 10, 10)
        self.refuses(ValueError, "label 2000 is not in the image.*is it a scan instead of labels", body=image(grey, 3.0),
                     tissues={2000: SOFT})
        self.refuses(ValueError, "must extend in three dimensions", body=image(np.ones((1, 10, 10), np.int16), 3.0))
        self.refuses(TypeError, "must be an image of labels", body=vtkSphereSource())
        self.refuses(FileNotFoundError, "nowhere.nii", body="nowhere.nii")
        with self.assertRaisesRegex(ValueError, "an image is not a body; give tissues="):
            palpate.response(image(self.LABELS, 3.0))

    def test_faults_of_other_arguments(self):
        for name, value in (("young", 0.2), ("layer", 3.0), ("compliance", None), ("curvature", False), ("points", [0]),
                            ("young", np.ones(3))):
            self.refuses(ValueError, "%s cannot be combined with tissues" % name, **{name: value})
        self.refuses(ValueError, "Surface Spacing must be 0 or positive", spacing=-1)
        self.refuses(ValueError, "cannot be filled.*'w-'", fixed="w-")
        with self.assertRaisesRegex(ValueError, "cube:3"):
            palpate.response(image(self.LABELS, 3.0), "cube:3", tissues=self.TISSUES)

    def test_an_exception_of_the_progress_ends_the_work(self):
        def stop(step, fraction):
            raise KeyboardInterrupt(step)

        with self.assertRaisesRegex(KeyboardInterrupt, "filling"):
            palpate.response(image(self.LABELS, 3.0), tissues=self.TISSUES, progress=stop)


if __name__ == "__main__":
    if not palpate.vtkSegmentedBody.IsAvailable():
        print("built without CGAL")
        raise SystemExit(77)
    unittest.main(verbosity=2)
