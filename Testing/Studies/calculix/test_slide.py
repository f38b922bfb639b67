#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the committed curves of a dragged sphere (Data/Studies/sliding), and the parts of slide.py that need no
CalculiX. The study of the paper compares the prediction with these curves."""
import csv
import pathlib
import unittest

import numpy as np

import mesh
import slide
import slide_mesh
import theory

DATA = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Studies" / "sliding"


def volumes(body):
    """Returns the volume of each element from its eight corners, with 2 x 2 x 2 Gauss points; negative: inside out."""
    signs = np.array([(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1),
                      (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)])
    corners, total = body.points[body.elements[:, :8]], 0.0
    for at in signs / np.sqrt(3):
        factors = 1 + signs * at
        slopes = np.stack([signs[:, k] / 8 * np.prod(np.delete(factors, k, axis=1), axis=1) for k in range(3)])
        total = total + np.linalg.det(slopes @ corners)
    return total


class TestMesh(unittest.TestCase):
    def test_half_body(self):
        body = slide_mesh.half_body(2, np.array([1.0, 2.0, 4.0]), np.array([-3.0, -1.0, 0.0]))
        parts = volumes(body)
        self.assertTrue(np.all(parts > 0))
        # The rim is a polygon of 16 sides through these corners: its area is at least sin(π/8) /
        # (π/8) of the circle.
        half = 0.5 * np.pi * 4 ** 2 * 3
        self.assertLess(parts.sum(), half)
        self.assertGreater(parts.sum(), 0.97 * half)
        self.assertTrue(np.all(body.points[:, 1] > -1e-12))
        # Each point at x has one at -x; no point is missing or doubled.
        keys = {tuple(p) for p in np.round(body.points, 8) + 0.0}
        self.assertEqual(len(keys), len(body.points))
        self.assertEqual(keys, {(-x + 0.0, y, z) for x, y, z in keys})

    def test_half_tool(self):
        tool = slide_mesh.half_tool(1.6, 2.4, 2, 4, 0.16)
        self.assertTrue(np.all(volumes(tool) > 0))
        face_one = [0, 1, 2, 3, 8, 9, 10, 11]
        outside = np.unique([tool.elements[e][face_one] for e, _ in tool.contact])
        x, y, z = tool.points[outside].T
        radius = np.where(z < 1.6, np.sqrt(x * x + y * y + (z - 1.6) ** 2), np.hypot(x, y))
        np.testing.assert_allclose(radius, 1.6, rtol=1e-12)
        # The arc beyond the quarter circle is the shaft.
        self.assertAlmostEqual(z.max(), 1.6 + 1.6 * (2.4 - 0.5 * np.pi), places=12)

    def test_face_one_is_outside(self):
        # Nodes 1 to 4 (face 1 in CalculiX) of every element of the tool are on the outside.
        tool = slide_mesh.half_tool(6.35, 0.5, 2, 2, 0.6)
        corners = tool.points[tool.elements[:, :4]].reshape(-1, 3) - [0, 0, 6.35]
        np.testing.assert_allclose(np.linalg.norm(corners, axis=1), 6.35, rtol=1e-12)
        self.assertEqual({face for _, face in tool.contact}, {1})
        self.assertIsInstance(tool, mesh.Mesh)


def printed(name, moment, force):
    """Returns the text that CalculiX prints."""
    return (" total force (fx,fy,fz) for set {} and time  {:.7E}\n\n        {:.6E}  {:.6E}  {:.6E}\n\n".format(
        name, moment, *force))


class TestReading(unittest.TestCase):
    CASE = slide.CASES["control-nu0.49-neohooke"]

    def text(self, moments, out_of_balance=0.0):
        return "".join(printed("TOOL", t, (0.4 * t, 0.1, -1.5)) + printed(
            "SUPPORT", t, (-0.4 * t, -0.5, 1.5 + out_of_balance)) for t in moments)

    def test_rows(self):
        rows = slide.read(self.text([0.5, 1, 1.25, 2, 2.5, 3, 3.5, 4]), self.CASE)
        u, depth = self.CASE.reach, self.CASE.depth
        self.assertEqual([row[0] for row in rows], ["press"] * 3 + ["out"] * 2 + ["back"] * 2 + ["forth"] * 2)
        np.testing.assert_allclose([row[1] for row in rows], [0, 0.5 * depth] + [depth] * 7)
        np.testing.assert_allclose([row[2] for row in rows], np.array([0, 0, 0, 0.25, 1, 0, -1, 0, 1]) * u)
        # The model is one half, so that the reaction is doubled.
        np.testing.assert_allclose([row[3] for row in rows[1:]], 3.0)
        np.testing.assert_allclose([row[4] for row in rows[3:5]], [1.0, 1.6])
        self.assertTrue(slide.finished(self.CASE, rows))
        self.assertFalse(slide.finished(self.CASE, rows[:-1]))

    def test_increments_of_no_length_are_dropped(self):
        self.assertEqual(len(slide.read(self.text([0.5, 0.999999, 1.0, 1.25]), self.CASE)), 4)

    def test_out_of_balance(self):
        with self.assertRaisesRegex(ValueError, "differ"):
            slide.read(self.text([0.5], out_of_balance=0.1), self.CASE)


class TestFiles(unittest.TestCase):
    def test_heads_and_columns(self):
        files = sorted(DATA.glob("*.csv"))
        self.assertGreater(len(files), 3)
        for path in files:
            with self.subTest(path.name):
                case = slide.CASES[path.stem]
                head = path.read_text(encoding="utf-8")
                self.assertIn("# origin: CalculiX ", head)
                self.assertIn("# tool: sphere:{:g}, rigid\n".format(case.radius), head)
                self.assertIn("nu = {:g}\n".format(case.poisson_ratio), head)
                with open(path, encoding="utf-8") as lines:
                    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
                depth = np.array([float(row["depth_mm"]) for row in rows])
                reach = np.array([float(row["slide_mm"]) for row in rows])
                normal = np.array([float(row["normal_N"]) for row in rows])
                dragged = np.array([row["leg"] != "press" for row in rows])
                np.testing.assert_allclose(depth[dragged], case.depth, rtol=1e-5)
                self.assertLess(np.abs(reach).max(), case.reach * (1 + 1e-5) + 1e-12)
                self.assertTrue(np.all(np.diff(normal[~dragged]) > 0))
                # Either the path is complete, or the file states that it is not.
                whole = slide.finished(case, [(row["leg"], d, x) for row, d, x in zip(rows, depth, reach)])
                self.assertEqual(whole, "# end: of the way\n" in head)
                self.assertTrue(whole or "gave up here\n" in head)

    def test_frictionless_press(self):
        # The body is 100 mm high: a bonded layer, 1.4 % (nu = 0.3) and 1.8 % (0.49) stiffer than a
        # half-space, and also held at its side. At 0.49 the remaining error is that of the mesh:
        # four elements across the contact radius. At 0.3 the surface moves inward under the tool by
        # (1 - 2 nu), which linear theory ignores: 2.4 %.
        for nu, allowed in ((0.3, 0.03), (0.49, 0.006)):
            case = slide.CASES["control-nu{:g}-neohooke-frictionless".format(nu)]
            with open(DATA / (case.name + ".csv"), encoding="utf-8") as lines:
                last = list(csv.DictReader(line for line in lines if not line.startswith("#")))[-1]
            exact = theory.BondedLayer(slide.FAR, nu).force(
                "sphere", case.radius, slide.REDUCED_MODULUS, case.depth)
            self.assertAlmostEqual(float(last["normal_N"]) / exact, 1, delta=allowed)


if __name__ == "__main__":
    unittest.main()
