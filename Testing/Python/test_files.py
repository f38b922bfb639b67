#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Files of bodies and scans: any damaged file is refused with a message. Unusual but valid files are read correctly."""
import gzip
import os
import random
import struct
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np
import palpate
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance, vtkMassProperties, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkSphereSource

sys.path.insert(0, str(Path(__file__).parent.parent / "Viewer"))
import bodies  # noqa: E402
from bodies import lump, nifti  # noqa: E402

CORNERS = np.array([[-10, -10, 0], [10, -10, 0], [0, 10, 0], [0, 0, 20]], dtype=float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
VERTICES = "".join("v %g %g %g\n" % tuple(corner) for corner in CORNERS)
# Files of each kind that VTK reads, each read in its own process.
DAMAGED = int(os.environ.get("PALPATE_DAMAGED_FILES", "8"))
# Kinds that Palpate reads, in this process; ten times as many files.
OURS = (".stl", ".obj")


def skin_of(image, contour=50.0):
    skin = palpate.vtkSkinSurface()
    skin.SetInputData(image)
    skin.SetContourValue(contour)
    skin.SetClosingRadius(0)
    skin.Update()
    return skin.GetOutput()


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def volume_of(surface):
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    return mass.GetVolume()


def apart(points, surface):
    """Distances of points to the surface."""
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(surface)
    return np.array([abs(distance.EvaluateFunction(point)) for point in points])


def tetrahedron(low=True):
    words = "solid one\n" + "".join(
        "facet normal 0 0 0\n outer loop\n" + "".join("  vertex %g %g %e\n" % tuple(CORNERS[i]) for i in face)
        + " endloop\nendfacet\n" for face in FACES) + "endsolid one\n"
    return words if low else words.upper()


def binary_tetrahedron(head=b"binary", stated=4):
    return head.ljust(80, b"\0") + struct.pack("<I", stated) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *CORNERS[face].ravel(), 0) for face in FACES)


class Files(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def written(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def read(self, name, content):
        reader = palpate.vtkBodyFileReader()
        reader.SetFileName(str(self.written(name, content)))
        faults = []
        reader.AddObserver("ErrorEvent", lambda *_: faults.append(reader.GetFault()))
        reader.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        self.assertEqual(faults, [])
        return reader

    def refused(self, name, content, words):
        with self.assertRaisesRegex(RuntimeError, words) as raised:
            palpate.response(self.written(name, content), compliance=None)
        self.assertIn(name, str(raised.exception))


class Faults(Files):
    def test_obj(self):
        for text, words in (
                ("v 0 0 0\nv 10 0 0\nv 0 10 0\nf 1/1 2/2 3/3\n",
                 "line 4: a corner names texture coordinate 3, but the number of them is 0"),
                (VERTICES + "vn 0 0 1\nf 1//1 3//99999 2//1\nf 1//1 2//1 4//1\n",
                 "line 6: a corner names normal 99999, but the number of them is 1"),
                (VERTICES + "f 1 2 5\n", "line 5: a corner names vertex 5, but the number of them is 4"),
                (VERTICES + "f 1 2 -5\n", "line 5: the corner '-5' names vertex -5, but only 4 precede it"),
                (VERTICES + "f 1 2 0\n", "line 5: the corner '0' cannot be understood"),
                (VERTICES + "f 1 2 3/x\n", "line 5: the corner '3/x' cannot be understood"),
                (VERTICES + "f 1 2 3/1/1/1\n", "line 5: the corner '3/1/1/1'"),
                (VERTICES + "f 1 2\n", "line 5: a face needs three corners, but has 2"),
                ("v 0 0\n", "line 1: three numbers are needed"),
                ("Dear Sir, please find enclosed a liver.\n", "it has no faces"),
                ("v 0 0 0\nv 0 nan 0\n", "line 2: 'nan' is not a finite number"),
                (VERTICES + "f 1 2 99999999999999999999\n", "line 5: the corner '9+' cannot be understood")):
            with self.subTest(text=text[-30:]):
                self.refused("body.obj", text, words)

    def test_ply(self):
        vertex = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        face = "element face 4\nproperty list uchar int vertex_indices\n"
        rows = "".join("%g %g %g\n" % tuple(corner) for corner in CORNERS)
        faces = "".join("3 %d %d %d\n" % tuple(one) for one in FACES)
        start = "ply\nformat ascii 1.0\n"
        self.assertEqual(self.read("body.ply", start + vertex + face + "end_header\n" + rows + faces)
                         .GetOutput().GetNumberOfCells(), 4)
        for text, words in (
                (start + face + vertex + "end_header\n" + faces + rows, "element face precedes element vertex"),
                (start + vertex + vertex + face + "end_header\n" + 2 * rows + faces, "element vertex occurs twice"),
                (start + "element vertex 4\nproperty float x\n" + face + "end_header\n" + rows + faces, "no x, y and z"),
                (start + vertex + face + "element odd 9999999999\nend_header\n" + rows + faces, "odd has no properties"),
                (start + vertex + face + "end_header\n" + rows + faces.replace("3 2", "3 9"), "face . of 4 names a vertex"),
                (start + vertex + "comment " + 5000 * "x" + "\n" + face + "end_header\n" + rows + faces, "line 7 is longer")):
            with self.subTest(words=words):
                self.refused("body.ply", text, words)

    def test_stl(self):
        for content, words in (
                ("Dear Sir, please find enclosed a liver.\n", "does not begin with 'solid'"),
                (tetrahedron().replace("-10 -10", "-10 x", 1), "line 4: 'x' is not a finite number"),
                (tetrahedron().replace("vertex 0 10 0.000000e+00", "vertex 0 10 nan", 1), "line 5: 'nan' is not a finite number"),
                (tetrahedron()[:-13], "line 29: the file ends without an 'endsolid'"),
                (tetrahedron().replace(" endloop\n", "  vertex 1 1 1\n endloop\n"), "line 7: 'vertex'"),
                (tetrahedron().replace("facet", "facette", 1), "line 2: 'facette' is not understood"),
                (binary_tetrahedron()[:-1], "it ends after 3 of 4 facets"),
                (binary_tetrahedron()[:-14] + struct.pack("<fH", np.nan, 0), "it ends after 3 of 4"),
                (binary_tetrahedron()[:-6] + struct.pack("<fH", np.inf, 0), "facet 3 has a coordinate that is not a finite"),
                (b"\0" * 70, "shorter than the head")):
            with self.subTest(words=words):
                self.refused("body.stl", content, words)

    def test_nifti(self):
        grey = lump()
        whole = nifti(grey)
        for content, words in (
                (nifti(grey, dim=(3, 32767, 32767, 32767, 1, 1, 1, 1)), "states 32767 x 32767 x 32767 voxels"),
                (whole[:-1], "its header states 34 x 30 x 26 voxels from byte 352 on, 106432 bytes, but it has 106431"),
                (nifti(grey, dim=(4, 17, 30, 26, 2, 1, 1, 1)), r"it holds 2 images \(dim\[4\] of its header\)"),
                (nifti(grey, dim=(5, 17, 30, 26, 1, 2, 1, 1)), r"it holds 2 images \(dim\[5\] of its header\)"),
                (nifti(grey, dim=(3, 0, 30, 26, 1, 1, 1, 1)), r"dim\[1\] of its header is 0"),
                (nifti(grey, dim=(3, -4, 30, 26, 1, 1, 1, 1)), "negative|dim.1."),
                (nifti(grey, dim=(2, 34, 30, 26, 1, 1, 1, 1)), "it has 2 dimensions"),
                (nifti(grey, sform=np.ones((3, 4))), "the sform of its header does not span a volume"),
                (nifti(grey, sform=np.full((3, 4), np.nan)), "the sform of its header does not span a volume"),
                (nifti(grey, qform=(0, 0, 0, np.inf, 0, 0)), "the qform of its header does not span a volume"),
                (nifti(grey, scale=(np.inf, 0)), "scl_slope and scl_inter of its header are inf and 0"),
                (whole[:344] + b"\0\0\0\0" + whole[348:], "not a NIfTI file")):
            with self.subTest(words=words):
                self.refused("scan.nii", content, words)
        for name in ("scan.nii.gz", "SCAN.NII.GZ"):
            self.refused(name, gzip.compress(nifti(grey, dim=(3, 32767, 32767, 32767, 1, 1, 1, 1))), "compressed")

    def test_an_image_is_no_body(self):
        for name, content in (("scan.nii", nifti(lump())), ("scan.nii.gz", gzip.compress(nifti(lump())))):
            with self.assertRaisesRegex(ValueError, "an image is not a body.*vtkSkinSurface"):
                palpate.response(self.written(name, content), compliance=None)
        with self.assertRaisesRegex(ValueError, "an image is not a body.*vtkSkinSurface"):
            palpate.response(vtkImageData())

    def test_files_that_are_damaged_anyhow(self):
        """A damaged file is refused with a message, or gives a body whose forces are finite. A crash would end this
        program."""
        random.seed(7)
        for name, content in self.seeds():
            read = refused = 0
            for _ in range(DAMAGED * (10 if name.endswith(OURS) else 1)):
                path = self.written(name, self.damaged(content))
                with self.subTest(name=name, read=read, refused=refused), warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    try:
                        force = vtk_to_numpy(self.pressed(path).GetPointData().GetArray("ResponseForce"))
                    except (RuntimeError, ValueError) as fault:
                        self.assertTrue(str(fault))
                        refused += 1
                        continue
                    self.assertTrue(np.isfinite(force).all())
                    read += 1
            with self.subTest(name=name, read=read, refused=refused):
                self.assertGreater(refused, 0)

    def seeds(self):
        source = vtkSphereSource()
        source.SetRadius(20)
        normals = vtkPolyDataNormals()
        normals.SetInputConnection(source.GetOutputPort())
        normals.Update()
        surface, volume, scan = normals.GetOutput(), bodies.block((5, 5, 4)), bodies.image(lump()[::2, ::2, ::2])
        for name, data, settings in (
                ("a.stl", surface, {"FileType": 1}), ("b.stl", surface, {"FileType": 2}),
                ("a.ply", surface, {"FileType": 1}), ("b.ply", surface, {"FileType": 2}),
                ("a.obj", surface, {}), ("scan.nii.gz", scan, {}),
                ("a.vtk", surface, {"FileType": 1}), ("b.vtk", surface, {"FileType": 2}),
                ("volume.vtk", volume, {"FileType": 1}), ("scan.vtk", scan, {"FileType": 2}),
                ("a.vtp", surface, {"DataMode": 0}), ("b.vtp", surface, {"DataMode": 1}), ("c.vtp", surface, {"DataMode": 2}),
                ("a.vtu", volume, {"DataMode": 0}), ("b.vtu", volume, {"DataMode": 2}),
                ("scan.vti", scan, {"DataMode": 2})):
            yield name, bodies.write(data, self.folder / name, **settings).read_bytes()
        yield "scan.nii", nifti(lump()[::2, ::2, ::2], kind=4, qform=(0, 0, 0.2, 1, 2, 3), scale=(0.5, 1))

    @staticmethod
    def damaged(content):
        """Changes some bytes or numbers, or omits, repeats or moves a part. Half of the changes are near the start."""
        made = bytearray(content)
        for _ in range(random.choice((1, 1, 2, 4))):
            at = random.randrange(min(len(made), random.choice((400, len(made)))))
            length = random.choice((1, 2, 4, 30))
            kind = random.randrange(6)
            if kind == 0:
                made[at] = random.randrange(256)
            elif kind == 1:
                made[at:at + length] = random.choice((b"", b"-1", b"99999999", b"4294967296", b"nan", b"\xff" * 4, b"\0" * 8))
            elif kind == 2:
                del made[at:at + length]
            elif kind == 3:
                made[at:at] = made[at:at + length]
            elif kind == 4:
                made[at] ^= 1 << random.randrange(8)
            else:
                made[at:at + 1] = b"%d" % random.randrange(10 ** random.randrange(1, 12))
        return bytes(made)

    @staticmethod
    def pressed(path):
        if ".nii" not in path.name and "scan" not in path.name:
            return palpate.response(path, "sphere:3", compliance=None)
        reader = palpate.vtkBodyFileReader()
        reader.SetFileName(str(path))
        image = palpate._filters.run(reader, RuntimeError).GetOutput()
        skin = palpate.vtkSkinSurface()
        if not isinstance(image, vtkImageData):
            raise ValueError("no image")
        skin.SetInputData(image)
        skin.SetContourValue(50)
        skin.SetClosingRadius(0)
        return palpate.response(palpate._filters.run(skin).GetOutput(), "sphere:3", compliance=None)


class Stl(Files):
    def test_ways_to_write_one_body(self):
        expected = self.read("plain.stl", binary_tetrahedron()).GetOutput()
        self.assertEqual((expected.GetNumberOfPoints(), expected.GetNumberOfCells()), (4, 4))
        for name, content in (
                ("ascii", tetrahedron()), ("upper case", tetrahedron(low=False)), ("crlf", tetrahedron().replace("\n", "\r\n")),
                ("blanks", " \n\t " + tetrahedron()), ("mark", b"\xef\xbb\xbf" + tetrahedron().encode()),
                ("mark, blanks and upper case", b"\xef\xbb\xbf\r\n " + tetrahedron(low=False).encode()),
                ("undefined normals", tetrahedron().replace("normal 0 0 0", "normal nan inf -nan")),
                ("two solids", tetrahedron().replace("endfacet\n", "endfacet\nendsolid one\nsolid two\n", 1)),
                ("one line each", tetrahedron().replace("loop\n", "loop ")),
                ("trailing", binary_tetrahedron() + b"\0" * 78), ("trailing facet", binary_tetrahedron() + b"\1" * 50),
                ("solid", binary_tetrahedron(b"solid of another kind")),
                ("solid in blanks", binary_tetrahedron(b"solid".ljust(80, b" ")))):
            with self.subTest(name=name):
                read = self.read(name + ".stl", content).GetOutput()
                np.testing.assert_array_equal(points_of(read), points_of(expected))
                np.testing.assert_array_equal(vtk_to_numpy(read.GetPolys().GetConnectivityArray()),
                                              vtk_to_numpy(expected.GetPolys().GetConnectivityArray()))

    def test_what_follows_the_facets_is_noted(self):
        reader = self.read("body.stl", binary_tetrahedron() + b"\0" * 78)
        self.assertIn("the 78 bytes after its 4 facets left out", [reader.GetNote(i) for i in range(reader.GetNumberOfNotes())])


class Obj(Files):
    def test_ways_to_write_one_body(self):
        plain = "".join("f %d %d %d\n" % tuple(face + 1) for face in FACES)
        seams = "".join("f %d/%d %d/%d %d/%d\n" % tuple(np.ravel([(face[k] + 1, 3 * i + k + 1) for k in range(3)]))
                        for i, face in enumerate(FACES))
        for name, text in (
                ("plain", VERTICES + plain), ("faces first", plain + VERTICES),
                ("relative", VERTICES + "".join("f %d %d %d\n" % tuple(face - 4) for face in FACES)),
                ("a texture coordinate per corner", VERTICES + "vt 0 0\n" * 12 + seams),
                ("mixed", "\ufeff# a comment\no one\n" + VERTICES + "vt 0 0\nvn 0 0 1\ng two\nusemtl red\ns off\n"
                 "f 1 3/1 2//1 # three\r\nf 1/1/1 2/1/1 4/1/1\nf 2 \\\n 3 4\nf 3//1 1//1 4//1\nl 1 2\n"),
                ("colours", "".join(line + " 1 0 0\n" for line in VERTICES.splitlines()) + plain)):
            with self.subTest(name=name):
                read = self.read("body.obj", text).GetOutput()
                np.testing.assert_array_equal(points_of(read), CORNERS)
                np.testing.assert_array_equal(vtk_to_numpy(read.GetPolys().GetConnectivityArray()).reshape(-1, 3), FACES)

    def test_normals_are_kept_if_a_point_has_one(self):
        normals = "".join("vn %g %g %g\n" % tuple(corner / 20) for corner in CORNERS)
        one = "".join("f %d//%d %d//%d %d//%d\n" % tuple(np.repeat(face + 1, 2)) for face in FACES)
        read = self.read("body.obj", VERTICES + normals + one).GetOutput()
        np.testing.assert_array_equal(vtk_to_numpy(read.GetPointData().GetNormals()), (CORNERS / 20).astype(np.float32))
        for faces, words in ((one.replace("1//1", "1//2", 1), "different ones"), (one.replace("1//1", "1", 1), "not all corners")):
            reader = self.read("body.obj", VERTICES + normals + faces)
            self.assertIsNone(reader.GetOutput().GetPointData().GetNormals())
            self.assertIn(words, reader.GetNote(0))


class Nifti(Files):
    """The header places the skin of a scan. The skin is that of the voxels, moved by the header's matrix."""

    def setUp(self):
        super().setUp()
        self.plain = skin_of(self.image(nifti(lump())))

    def image(self, content, name="scan.nii"):
        return self.read(name, content).GetOutput()

    def test_where_the_header_puts_it(self):
        turn = np.radians(30)
        oblique = np.array([[np.cos(turn), -np.sin(turn), 0, -10], [np.sin(turn), np.cos(turn), 0, -40], [0, 0, 1, -33]])
        left = np.array([[-1.0, 0, 0, 33], [0, 1, 0, 0], [0, 0, 1, 0]])
        upside_down = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, 25]])
        other_axes = np.array([[0, 0, 2.0, 5], [1.5, 0, 0, 6], [0, 0.5, 0, 7]])
        odd = (0, 0, np.sin(turn / 2), -10, -40, -33)
        for name, matrix, head in (
                ("sform", oblique, {"sform": oblique}), ("qform", oblique, {"qform": odd}),
                ("both", oblique, {"sform": oblique, "qform": (0, 0, 0, 1, 2, 3)}),
                ("big-endian", oblique, {"sform": oblique, "order": ">"}),
                ("LAS", left, {"sform": left}), ("LAS by qform", left, {"qform": (0, 1, 0, 33, 0, 0), "qfac": -1.0}),
                ("LAS by both", left, {"sform": left, "qform": (0, 1, 0, 33, 0, 0), "qfac": -1.0}),
                ("sform turns over, qform does not", left, {"sform": left, "qform": (0, 0, 0, 0, 0, 0)}),
                ("upside down", upside_down, {"sform": upside_down}), ("other axes", other_axes, {"sform": other_axes}),
                ("metres", 1000 * other_axes, {"sform": other_axes, "unit": 1}),
                ("micrometres", 0.001 * other_axes, {"sform": other_axes, "unit": 3}),
                ("sides", np.diag([2.0, 3.0, 0.5, 0])[:3], {"sides": (2.0, 3.0, 0.5)}),
                ("compressed", left, {"sform": left, "name": "scan.nii.gz"})):
            with self.subTest(name=name):
                file = head.pop("name", "scan.nii")
                content = nifti(lump(), **head)
                found = skin_of(self.image(gzip.compress(content) if file.endswith("gz") else content, file))
                place = points_of(self.plain) @ matrix[:, :3].T + matrix[:, 3]
                size = np.abs(np.linalg.det(matrix[:, :3])) ** (1 / 3)
                # In reversed slices the smoothing uses other triangles, which gives a difference of
                # a fifth of a voxel at the creases. Wrong axes would give several voxels.
                off = apart(place[::7], found) / size
                self.assertLess(off.max(), 0.3)
                self.assertLess(off.mean(), 0.05)
                self.assertAlmostEqual(volume_of(found) / (volume_of(self.plain) * size ** 3), 1, delta=1e-3)

    def test_values_are_scaled(self):
        for kind, scale in ((4, (0.01, 0.0)), (8, (0.02, -20.0)), (16, (2.0, 0.0)), (2, (0.5, 7.0))):
            stored = (lump() - scale[1]) / scale[0]
            if kind == 2:
                stored = np.clip(stored, 0, 255)
            image = self.image(nifti(stored, kind=kind, scale=scale))
            # Stored as integers: an error of at most 1.
            np.testing.assert_allclose(vtk_to_numpy(image.GetPointData().GetScalars()),
                                       (stored * scale[0] + scale[1]).ravel(order="F"), atol=1.01 * scale[0] + 1e-5)
        image = self.image(nifti(lump(), scale=(0.0, 5.0)))         # a slope of 0 means that the values are not scaled
        np.testing.assert_array_equal(vtk_to_numpy(image.GetPointData().GetScalars()),
                                      lump().ravel(order="F").astype(np.float32))

    def test_layers_and_materials_follow_it(self):
        """Thickness over a ball of bone, and materials of the halves of a block, are correct in a scan that is stored
        in reverse."""
        left = np.array([[-1.0, 0, 0, 33], [0, 1, 0, 0], [0, 0, 1, 0]])
        x, y, z = np.ogrid[:34, :34, :34]
        away = np.sqrt((x - 15.0) ** 2 + (y - 16.0) ** 2 + (z - 17.0) ** 2)
        grey = np.clip(50 + 50 * (14 - away), 0, 100) - np.clip(50 + 50 * (9 - away), 0, 100)
        found = []
        for content in (nifti(grey), nifti(grey[::-1], sform=left)):
            image = self.image(content)
            thickness = palpate.vtkLayerThickness()
            thickness.SetInputData(0, skin_of(image))
            thickness.SetScanData(image)
            thickness.Update()
            found.append(vtk_to_numpy(thickness.GetOutput().GetPointData().GetArray("LayerThickness")))
        for each in found:
            # Balls of 14 and 9 mm around one centre. Tolerance: a tenth of a voxel plus the effect
            # of smoothing.
            self.assertAlmostEqual(np.median(each), 5.0, delta=0.25)
        labels = np.where(x + 0 * (y + z) < 12, 1.0, 2.0)
        grid = bodies.block()                                       # 30 x 30 x 20 mm from the origin
        moduli = []
        for content in (nifti(labels, kind=2), nifti(labels[::-1], kind=2, sform=left)):
            tissues = palpate.vtkScannedMaterial()
            tissues.SetInputData(grid)
            tissues.SetImageData(self.image(content))
            tissues.AddMaterial(1, 0.1, 0.4)
            tissues.AddMaterial(2, 0.4, 0.4)
            tissues.Update()
            moduli.append(vtk_to_numpy(tissues.GetOutput().GetCellData().GetArray("YoungsModulus")))
        np.testing.assert_array_equal(*moduli)
        self.assertEqual((moduli[0].min(), moduli[0].max()), (0.1, 0.4))


if __name__ == "__main__":
    unittest.main(verbosity=2)
