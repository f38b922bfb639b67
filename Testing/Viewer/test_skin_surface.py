# SPDX-License-Identifier: BSD-3-Clause
"""vtkSkinSurface on synthetic scans: a ball with a cavity, with a channel, and cut by the field of view."""
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataConnectivityFilter

from bodies import ball_grey, distances, image
from palpate import vtkSkinSurface

SIZE = 64
RADIUS = 20.3
CENTRE = numpy.array([31.2, 30.7, 31.5])  # not on the voxel grid
CONTOUR = 50.0
SUB_VOXEL = 0.06  # mm, for voxels of 1 mm


def ball(centre=CENTRE):
    return ball_grey(SIZE, RADIUS, tuple(centre))


def skin(values, spacing=(1.0, 1.0, 1.0), **settings):
    filter_ = skin_filter(image(values, spacing), **settings)
    filter_.Update()
    return filter_.GetOutput()


def skin_filter(data, **settings):
    filter_ = vtkSkinSurface()
    filter_.SetInputData(data)
    filter_.SetContourValue(CONTOUR)
    filter_.SetClosingRadius(0.0)
    for name, value in settings.items():
        getattr(filter_, f"Set{name}")(value)
    return filter_


def points(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def radii(surface, centre=CENTRE):
    return numpy.linalg.norm(points(surface) - centre, axis=1)


def border_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput()


def passed(wave, iterations=30, pass_band=0.02):
    """
    Remaining fraction of a wave after windowed-sinc smoothing. The wave is `wave` spacings long, on a lattice of
    squares with a diagonal each.

    Taubin, Zhang and Golub 1996: with the wave's eigenvalue k of the umbrella operator, here 2/3 (1 - cos(2 pi / wave))
    of six neighbours, f(k) = sum of w_n c_n T_n(1 - k/2). c_n are the coefficients of the ideal low pass up to an edge
    that is moved until f(pass band) = 1; w_n is Hamming's window. The result is divided by f(0), because the skin does
    not shrink.
    """
    n = numpy.arange(iterations + 1)
    window = 0.54 + 0.46 * numpy.cos(n * numpy.pi / (iterations + 1))

    def left(k, edge):
        ideal = numpy.where(n == 0, edge, 2.0 * numpy.sin(n * edge) / numpy.maximum(n, 1)) / numpy.pi
        return (window * ideal * numpy.cos(n * numpy.arccos(1.0 - 0.5 * k))).sum()

    start = numpy.arccos(1.0 - 0.5 * pass_band)
    edge = next(edge for edge in numpy.arange(start, numpy.pi, 1e-4) if left(pass_band, edge) >= 1.0)
    return left(2.0 / 3.0 * (1.0 - numpy.cos(2.0 * numpy.pi / wave)), edge) / left(0.0, edge)


def errors_of(data, **settings):
    filter_ = skin_filter(data, **settings)
    found = []

    def note(_caller, _event, text):
        found.append(text)

    note.CallDataType = "string0"
    filter_.AddObserver("ErrorEvent", note)
    filter_.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    filter_.Update()
    return "".join(found), filter_.GetOutput().GetNumberOfPoints()


class SkinSurface(unittest.TestCase):
    def check_ball(self, surface, radius=RADIUS, tolerance=SUB_VOXEL):
        found = radii(surface)
        self.assertAlmostEqual(found.mean(), radius, delta=0.5 * tolerance)
        self.assertLess(abs(found - radius).max(), 2.0 * tolerance)
        self.assertEqual(border_edges(surface).GetNumberOfCells(), 0)
        regions = vtkPolyDataConnectivityFilter()
        regions.SetInputData(surface)
        regions.SetExtractionModeToAllRegions()
        regions.Update()
        self.assertEqual(regions.GetNumberOfExtractedRegions(), 1)

    def check_normals(self, surface, centre=CENTRE):
        """The normals are unit vectors, outward, and agree with the orientation of the triangles."""
        normals = vtk_to_numpy(surface.GetPointData().GetNormals()).astype(float)
        outward = points(surface) - centre
        outward /= numpy.linalg.norm(outward, axis=1)[:, None]
        numpy.testing.assert_allclose(numpy.linalg.norm(normals, axis=1), 1.0, atol=1e-5)
        self.assertGreater((normals * outward).sum(axis=1).min(), 0.99)
        triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        a, b, c = (points(surface)[triangles[:, k]] for k in range(3))
        winding = numpy.cross(b - a, c - a)
        self.assertTrue(((winding * outward[triangles[:, 0]]).sum(axis=1) > 0.0).all())

    def test_ball(self):
        surface = skin(ball())
        self.check_ball(surface)
        self.check_normals(surface)
        self.assertEqual(surface.GetPointData().GetNumberOfArrays(), 1)

    def test_cavity_is_not_part_of_the_surface(self):
        values = numpy.minimum(ball(), 100.0 - ball_grey(SIZE, 9.0, tuple(CENTRE)))
        self.check_ball(skin(values))

    def test_channel_to_the_cavity_is_closed(self):
        values = numpy.minimum(ball(), 100.0 - ball_grey(SIZE, 9.0, tuple(CENTRE)))
        x, y, _ = numpy.ogrid[:SIZE, :SIZE, :SIZE]
        channel = (numpy.hypot(x - CENTRE[0], y - CENTRE[1]) < 2.0) & (numpy.arange(SIZE) > CENTRE[2])
        values[channel] = 0.0
        self.assertLess(radii(skin(values)).min(), 10.0)  # the cavity is open and belongs to the surface
        closed = skin(values, ClosingRadius=4.0)
        found = radii(closed)
        self.assertGreater(found.min(), RADIUS - 1.0)  # the mouth of 4 mm is closed by a flat surface
        away = points(closed)[:, 2] < CENTRE[2]
        self.assertLess(abs(found[away] - RADIUS).max(), 2.0 * SUB_VOXEL)  # other places are unchanged
        self.assertEqual(border_edges(closed).GetNumberOfCells(), 0)

    def test_island_is_left_out(self):
        values = numpy.maximum(ball(), ball_grey(SIZE, 3.0, (6.0, 6.0, 6.0)))
        self.check_ball(skin(values))

    def test_resolution(self):
        whole, half = skin(ball(), Resolution=1.0), skin(ball(), Resolution=0.5)
        self.check_ball(half)
        self.check_normals(half)
        ratio = half.GetNumberOfPoints() / whole.GetNumberOfPoints()
        self.assertAlmostEqual(ratio, 4.0, delta=0.3)
        self.check_ball(skin(ball(), Resolution=2.0), tolerance=4.0 * SUB_VOXEL)

    def test_what_smoothing_leaves_of_a_wave(self):
        """Smoothing removes the terraces of voxels and keeps the form of the body, with every version of VTK, although
        their defaults differ."""
        x, z = numpy.arange(130), numpy.arange(12)
        for wave in (6, 8, 11, 16, 33):
            height = 5.3 + 0.28 * numpy.cos(2.0 * numpy.pi * x / wave)     # within one layer of voxels
            grey = numpy.clip(50.0 + 50.0 * (height[:, None, None] - z), 0.0, 100.0)
            found = points(skin(numpy.broadcast_to(grey, (x.size, 80, z.size))))
            # The border is fixed. Its influence extends over 30 edges, one edge per iteration.
            inner = found[(found[:, 0] > 31) & (found[:, 0] < 31.5 + 66) & (abs(found[:, 1] - 39.5) < 6)]
            phase = 2.0 * numpy.pi * inner[:, 0] / wave
            design = numpy.stack([numpy.cos(phase), numpy.sin(phase), numpy.ones(len(phase))], axis=1)
            cosine, sine, _ = numpy.linalg.lstsq(design, inner[:, 2], rcond=None)[0]
            # VTK ends its search for the edge when f(pass band) > 0.999. Where f decreases fastest,
            # the value is 0.02 lower.
            self.assertAlmostEqual(cosine / 0.28, passed(wave), delta=0.025, msg=str(wave))
            self.assertAlmostEqual(sine, 0.0, delta=1e-3)

    def test_spacing_of_the_scan(self):
        surface = skin(ball(), spacing=(0.5, 0.5, 0.5))
        found = radii(surface, 0.5 * CENTRE)
        self.assertAlmostEqual(found.mean(), 0.5 * RADIUS, delta=0.5 * SUB_VOXEL)

    def test_field_of_view_cuts(self):
        centre = numpy.array([31.2, 30.7, 8.5])  # the ball extends 12 mm beyond the first slice
        surface = skin(ball(centre))
        border = border_edges(surface)
        self.assertGreater(border.GetNumberOfCells(), 50)
        self.assertAlmostEqual(abs(points(border)[:, 2]).max(), 0.0, delta=0.01)
        rim = numpy.linalg.norm(points(border)[:, :2] - centre[:2], axis=1)
        self.assertLess(abs(rim - numpy.sqrt(RADIUS ** 2 - centre[2] ** 2)).max(), 0.2)
        # The surface is not capped: there are no points inside the rim at the first slice.
        low = points(surface)[:, 2] < 0.5
        self.assertGreater(radii(surface, centre)[low].min(), RADIUS - 0.3)
        self.check_normals(surface, centre)

    def test_threads_do_not_matter(self):
        values = numpy.minimum(ball(), 100.0 - ball_grey(SIZE, 9.0, tuple(CENTRE)))
        before = vtkSMPTools.GetBackend()
        self.addCleanup(vtkSMPTools.SetBackend, before)
        vtkSMPTools.SetBackend("STDThread")
        results = []
        for threads in (1, 2, 2):
            vtkSMPTools.Initialize(threads)
            self.assertEqual(vtkSMPTools.GetEstimatedNumberOfThreads(), threads)
            surface = skin(values, ClosingRadius=3.0, Resolution=0.7)
            results.append((
                vtk_to_numpy(surface.GetPoints().GetData()).tobytes(),
                vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).tobytes(),
                vtk_to_numpy(surface.GetPointData().GetNormals()).tobytes()))
        vtkSMPTools.Initialize(0)
        self.assertTrue(results[0] == results[1] == results[2])

    def test_what_is_not_finite_is_air(self):
        values = ball()
        away = distances(SIZE, tuple(CENTRE)) > RADIUS + 6.0
        values[away] = numpy.nan
        values[:2] = numpy.inf
        self.check_ball(skin(values))

    def test_input_is_left_alone(self):
        values = numpy.minimum(ball(), 100.0 - ball_grey(SIZE, 9.0, tuple(CENTRE)))
        data = image(values)
        before = data.GetMTime()
        skin_filter(data, ClosingRadius=3.0).Update()
        self.assertEqual(data.GetMTime(), before)
        kept = vtk_to_numpy(data.GetPointData().GetScalars())
        self.assertTrue((kept == values.ravel(order="F").astype(numpy.float32)).all())

    def test_errors(self):
        data = image(ball())
        bare = vtkImageData()
        bare.SetDimensions(8, 8, 8)
        colours = vtkImageData()
        colours.SetDimensions(8, 8, 8)
        colours.AllocateScalars(3, 3)  # three unsigned chars
        for scan, settings, words in (
                (bare, {}, ("no point scalars",)),
                (colours, {}, ("3 components",)),
                (image(ball()[:, :, :1]), {}, ("three dimensions", "64 x 64 x 1")),
                (data, {"ContourValue": 100.0}, ("Contour Value 100", "0 to 100")),
                (data, {"ContourValue": -5.0}, ("Contour Value -5",)),
                (data, {"ContourValue": float("nan")}, ("Contour Value nan",)),
                (data, {"ClosingRadius": -1.0}, ("Closing Radius", "-1")),
                (data, {"Resolution": -1.0}, ("Resolution", "-1")),
                (data, {"Resolution": 1e-4}, ("0.0001 mm is too fine",))):
            with self.subTest(words=words):
                message, count = errors_of(scan, **settings)
                for word in words:
                    self.assertIn(word, message)
                self.assertEqual(count, 0)

    def test_level_is_chosen_from_grey_values(self):
        """The level is 12 % of the range, for a ball from 0 to 255 and for CT numbers from -1024 to 3071, both with the
        same edge width."""
        self.assertEqual(vtkSkinSurface().GetContourValue(), 0.0)
        for least, most, level in ((0.0, 255.0, 30.6), (-1024.0, 3071.0, -532.6)):
            grey = least + (most - least) * ball() / 100.0
            filter_ = skin_filter(image(grey), ContourValue=0.0)
            filter_.Update()
            self.assertAlmostEqual(filter_.GetUsedContourValue(), level, delta=0.1)
            given = skin(grey, ContourValue=filter_.GetUsedContourValue())
            self.assertTrue((points(filter_.GetOutput()) == points(given)).all())

    def test_labels_end_in_the_middle_between_voxels(self):
        """Labels 2 and 7 in label 1: the skin is that of a mask, for any outer label."""
        inside = distances(SIZE, tuple(CENTRE)) < RADIUS
        labels = numpy.where(inside, 2, 1)
        labels[inside & (numpy.arange(SIZE)[:, None, None] > SIZE // 2)] = 7
        data = vtkImageData()
        data.SetDimensions(SIZE, SIZE, SIZE)
        data.GetPointData().SetScalars(
            numpy_to_vtk(labels.ravel(order="F").astype(numpy.uint8), deep=True))
        filter_ = skin_filter(data, ContourValue=0.0)
        filter_.Update()
        # A mask is exact to half a voxel diagonal. Smoothing reduces this error.
        found = radii(filter_.GetOutput())
        self.assertAlmostEqual(found.mean(), RADIUS, delta=0.05)
        self.assertLess(abs(found - RADIUS).max(), 0.5 * 3 ** 0.5)
        middle = CENTRE[0] + 0.5                        # both labels have the same extent
        left = points(filter_.GetOutput())[:, 0] < middle
        self.assertAlmostEqual(found[left].mean(), found[~left].mean(), delta=0.05)

    def test_an_image_of_one_value_has_no_skin(self):
        message, count = errors_of(image(numpy.full((8, 8, 8), 3.0)), ContourValue=0.0)
        self.assertIn("nothing to contour", message)
        self.assertEqual(count, 0)

    def test_bubble_in_tissue_has_no_skin(self):
        message, count = errors_of(image(100.0 - ball()))
        self.assertIn("no air", message)
        self.assertEqual(count, 0)


if __name__ == "__main__":
    unittest.main()
