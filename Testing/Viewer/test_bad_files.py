# SPDX-License-Identifier: BSD-3-Clause
"""Files that are damaged or are no bodies give an error that names the file, without output or crash."""
import gzip
import unittest

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import bodies
from session import SessionCase


def without_triangles():
    """Points and a line between them."""
    points = vtkPoints()
    line = vtkCellArray()
    line.InsertNextCell(5)
    for i in range(5):
        line.InsertCellPoint(points.InsertNextPoint(10.0 * i, 0.0, 0.0))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(line)
    return data


def with_coordinate(value):
    """The sphere with one coordinate that is not finite."""
    data = vtkPolyData()
    data.DeepCopy(bodies.sphere())
    data.GetPoints().SetPoint(7, value, 0.0, 0.0)
    return data


class BadFiles(SessionCase):
    def path(self, name):
        return self.folder / name

    def refuse_file(self, path, *words):
        self.refuse(path, words=(path, *words))

    def test_no_such_file(self):
        self.refuse_file(self.path("missing.stl"), "no such file")

    def test_folder(self):
        self.path("folder.vtp").mkdir()
        self.refuse_file(self.path("folder.vtp"), "folder")

    def test_empty_file(self):
        for extension in (*bodies.WRITERS, ".nii"):
            with self.subTest(extension=extension):
                self.path(f"empty{extension}").touch()
                self.refuse_file(self.path(f"empty{extension}"), "empty")

    def test_unknown_extension(self):
        for name in ("body.step", "body", "stl", "body.stl.txt"):
            with self.subTest(name=name):
                self.path(name).write_text("solid\n")
                self.refuse_file(self.path(name), "unknown kind of file", ".vtp", ".nii.gz")

    def test_text_that_is_no_body(self):
        for extension in (*bodies.WRITERS, ".nii"):
            with self.subTest(extension=extension):
                path = self.path(f"letter{extension}")
                path.write_text("Dear Sir, please find enclosed a liver.\n" * 50)
                self.refuse_file(path)

    def test_cut_short(self):
        surface, volume = bodies.sphere(), bodies.block()
        scan = bodies.image(bodies.ball_grey())
        for name, data, settings in (
                ("binary.stl", surface, {"FileType": 2}),
                ("ascii.stl", surface, {"FileType": 1}),
                ("binary.ply", surface, {"FileType": 2}),
                ("ascii.ply", surface, {"FileType": 1}),
                ("ascii.vtp", surface, {"DataMode": 0}),
                ("inline.vtp", surface, {"DataMode": 1}),
                ("appended.vtp", surface, {"DataMode": 2}),
                ("binary.vtk", surface, {"FileType": 2}),
                ("volume.vtu", volume, {"DataMode": 1}),
                ("scan.vti", scan, {"DataMode": 1}),
                ("scan.nii.gz", scan, {})):
            path = bodies.write(data, self.path(name), **settings)
            whole = path.read_bytes()
            for share in (0.05, 0.5, 0.9):
                with self.subTest(name=name, share=share):
                    path.write_bytes(whole[:int(share * len(whole))])
                    self.refuse_file(path)

    def test_no_triangles(self):
        for name in ("line.vtp", "line.vtk"):
            with self.subTest(name=name):
                self.refuse_file(bodies.write(without_triangles(), self.path(name)), "no triangles")

    def test_coordinate_that_is_not_finite(self):
        for name in ("point.vtp", "point.ply", "point.vtk"):
            for value in (float("nan"), float("inf")):
                with self.subTest(name=name, value=value):
                    binary = {} if name.endswith(".vtp") else {"FileType": 2}
                    path = bodies.write(with_coordinate(value), self.path(name), **binary)
                    result = self.succeed(path, "--tool", "sphere:3")
                    self.assertIn("6 triangles with a coordinate that is not finite", result.stderr)

    def test_face_of_points_that_are_not_there(self):
        path = bodies.write(bodies.sphere(), self.path("lost.ply"), FileType=1)
        lines = path.read_text().splitlines()
        path.write_text("\n".join([*lines[:-1], "3 0 1 999999"]) + "\n")
        self.refuse_file(path, "names a vertex that does not exist")

    def test_what_makes_readers_of_vtk_crash(self):
        vertices = "v -10 -10 0\nv 10 -10 0\nv 0 10 0\nv 0 0 20\n"
        coordinates = "".join(f"property float {axis}\n" for axis in "xyz")
        for name, text, words in (
                ("seam.obj", vertices + "f 1/1 2/2 3/3\n", "line 5: a corner names texture coordinate 3"),
                ("normal.obj", vertices + "vn 0 0 1\nf 1//1 3//99999 2//1\n", "line 6: a corner names normal 99999"),
                ("order.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "element vertex 3\n" + coordinates + "end_header\n3 0 2 1\n-10 -10 0\n10 -10 0\n0 10 0\n",
                 "element face precedes element vertex")):
            with self.subTest(name=name):
                self.path(name).write_text(text)
                self.refuse_file(self.path(name), words)
        bodies.write(bodies.image(bodies.ball_grey(16, 4.0)), self.path("scan.nii.gz"))
        head = bytearray(gzip.decompress(self.path("scan.nii.gz").read_bytes())[:1000])
        head[42:48] = b"\xff\x7f" * 3
        self.path("huge.nii").write_bytes(head)
        self.refuse_file(self.path("huge.nii"), "states 32767 x 32767 x 32767 voxels")

    def test_scan_without_anything_in_it(self):
        empty = bodies.image(0.0 * bodies.ball_grey(16, 4.0))
        self.refuse_file(bodies.write(empty, self.path("empty.vti")), "nothing to contour")

    def test_site_without_surface(self):
        body = bodies.write(bodies.sphere(), self.path("body.stl"))
        self.refuse(body, "--site", "0,0,0", words=("Direction (0, 0, 0)", "meets no surface"))


if __name__ == "__main__":
    unittest.main()
