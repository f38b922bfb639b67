#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The short version of ./run study accuracy-speed: tests errors, which are the same on every machine, but no times.

    test_accuracy_speed.py PROGRAM [UNITTEST ARGS]       PROGRAM: palpateAccuracySpeed

Only the class ShapeNow needs the package palpate.

Expected numbers come from closed forms: the error of the best straight line for δ^1.5, the error of linear
interpolation between squared knots, the order of the error of facets and of area coordinates.
"""
import csv
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import relaxation
import relaxation_checks
import run
import rows as study
import shape
import strain
import tilt_checks

PROGRAM = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else None
STORED = ("Hermite 5", "Hermite 8", "Hermite 16", "Hermite 8, smooth surface", "Hermite 8, float32", "Hermite 8, float64")


def dome(folder, cells=44, spacing=2.0):
    """Writes a cap of a sphere of 90 mm over a base at a depth of 8 to 12 mm, which replaces the head."""
    points, inverse, triangles = [], [], []
    side = cells + 1
    for j in range(side):
        for i in range(side):
            x, y = (i - cells / 2) * spacing, (j - cells / 2) * spacing
            points.append((x, y, math.sqrt(90.0 ** 2 - x * x - y * y) - 90.0))
            inverse.append(1.0 / (10.0 + 2.0 * math.sin(0.15 * x) * math.cos(0.12 * y)))
    for j in range(cells):
        for i in range(cells):
            a = j * side + i
            triangles += [(a, a + 1, a + side + 1), (a, a + side + 1, a + side)]
    file = pathlib.Path(folder) / "dome.body"
    with open(file, "wb") as stream:
        stream.write("palpate-study {} {}\n".format(len(points), len(triangles)).encode())
        stream.write(struct.pack("={}d".format(3 * len(points)), *(c for point in points for c in point)))
        stream.write(struct.pack("={}d".format(len(inverse)), *inverse))
        stream.write(struct.pack("={}i".format(3 * len(triangles)), *(c for corners in triangles for c in corners)))
    return file


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            text = run.measure(PROGRAM, ["--quick", "--no-finite", "--no-times"], [dome(folder)])
        cls.methods, cls.convergence = run.judge(text)

    def error(self, scene, tool, method, column="error"):
        found = study.select(self.methods, scene=scene, tool=tool, method=method)
        self.assertEqual(len(found), 1, (scene, tool, method))
        return found[0][column]

    def scenes(self):
        return study.distinct(self.methods, "scene")

    def tools(self, scene):
        return [tool for tool in study.distinct(study.select(self.methods, scene=scene), "tool") if tool != study.ALL]

    def test_all_is_there_and_answered(self):
        self.assertEqual(self.scenes(), ["half-space block", "10 mm layer", "plate on edges", "head"])
        for row in study.select(self.methods, part="methods"):
            if row["method"] != study.REFERENCE:
                self.assertGreater(row["tips"], 400)
                self.assertEqual(row["unanswered"], 0)

    def test_stored_curves_hold(self):
        # On flat bodies the only error is that of storage. Hermite 8 must be within 1 %. The contract states 5e-4 for
        # layers and spheres, and up to 1.4 % in the first per cent of the depth of a soft plate.
        for scene in self.scenes()[:3]:
            for tool in self.tools(scene):
                for method in STORED:
                    with self.subTest(scene=scene, tool=tool, method=method):
                        self.assertLess(self.error(scene, tool, method), 0.01)
                        self.assertEqual(self.error(scene, tool, method, "noticed"), 0.0)
        for tool in self.tools("half-space block"):
            self.assertLess(self.error("half-space block", tool, "Hermite 8"), 1e-5)

    def test_more_samples_are_better(self):
        for scene in self.scenes()[:3]:
            for tool in self.tools(scene):
                for kind in ("linear", "Hermite"):
                    errors = [max(self.error(scene, tool, "{} {}".format(kind, n)), 1e-6) for n in (3, 5, 8, 16)]
                    # The law of a flat is linear: the remaining error is that of the reference, for
                    # any number of samples.
                    for fewer, more in zip(errors, errors[1:]):
                        with self.subTest(scene=scene, tool=tool, kind=kind):
                            self.assertLessEqual(more, 1.001 * fewer)
        # Linear interpolation has second order; Hermite cubics have fourth, down to rounding.
        for row in study.select(self.convergence, part="samples", method="linear"):
            if "flat" not in row["scene"]:
                self.assertAlmostEqual(row["order"], -2.0, delta=0.2)
        for row in study.select(self.convergence, part="samples", method="Hermite, float64"):
            if row["order"] is not None and "flat" not in row["scene"]:
                self.assertLess(row["order"], -3.0)

    def test_widths(self):
        for scene in self.scenes()[:2]:
            for tool in self.tools(scene):
                # Half an ulp of float16 is 2^-11; the cubic between samples at most doubles it.
                self.assertLess(self.error(scene, tool, "Hermite 8, float16"), 2.0 ** -10)
                self.assertGreater(self.error(scene, tool, "Hermite 8, float16"), 1e-5)
                self.assertLess(self.error(scene, tool, "Hermite 8, float32"), 2e-6)

    def test_springs_know_one_depth_and_one_tool(self):
        # The best straight line through δ^1.5 on (0, 1), with weight 1: √(1 - (1/3.5)²/(1/3 · 1/4))
        # = 14.3 %. The sites begin at 5 % and are few. The exact sphere is slightly less curved.
        spring = self.error("half-space block", "sphere:6.35", "point spring per vertex and tool", "error_sites")
        self.assertAlmostEqual(spring, 0.143, delta=0.025)
        # The law of a flat punch is linear.
        self.assertLess(self.error("half-space block", "flat:1.6", "point spring per vertex and tool"), 1e-6)
        for scene in ("half-space block", "10 mm layer"):
            for tool in ("sphere:1.6", "cone:60"):
                for method in ("one spring", "point spring per vertex", "fixed-traction patch"):
                    self.assertGreater(self.error(scene, tool, method), 1.0)
        # Springs are good if the global deflection dominates: the St. Venant case of the paper.
        for tool in self.tools("plate on edges"):
            self.assertLess(self.error("plate on edges", tool, "point spring per vertex"), 0.25)
        self.assertLess(self.error("plate on edges", "sphere:6.35", "point spring per vertex"), 0.03)

    def test_vertices_inside_the_tool_depend_on_the_mesh(self):
        for tool in ("sphere:1.6", "flat:1.6", "cone:60"):
            for size in ("fine", "medium", "coarse"):
                self.assertGreater(self.error("half-space block", tool, "penetrating vertices, " + size), 0.3)
        # A coarse mesh seldom has a vertex under a narrow tool: the tool's area is π 1.6² mm², the area per vertex 4² mm².
        self.assertGreater(self.error("half-space block", "flat:1.6", "penetrating vertices, coarse"),
                           self.error("half-space block", "flat:1.6", "penetrating vertices, fine"))

    def test_table_1_holds_on_a_half_space_alone(self):
        for tool in ("flat:1.6", "cone:60"):
            self.assertLess(self.error("half-space block", tool, "Table 1 at run time"), 1e-6)
        # The paraboloid is stiffer than the sphere by 2.8 % at δ/R = 2/6.35 (closed forms).
        self.assertAlmostEqual(self.error("half-space block", "sphere:6.35", "Table 1 at run time"), 0.028, delta=0.004)
        self.assertGreater(self.error("10 mm layer", "sphere:6.35", "Table 1 at run time"), 0.2)
        self.assertGreater(self.error("plate on edges", "flat:1.6", "Table 1 at run time"), 1.0)

    def test_order_over_the_mesh(self):
        # Facets are h²/(6R) below the ball, and interpolation between vertices has an error of h²/6 |f″|. Both are of
        # second order. There are three and four sizes.
        for body in ("ball", "uneven layer"):
            found = study.select(self.convergence, part="mesh", scene=body, method="Hermite, facets")
            self.assertAlmostEqual(found[0]["order"], 2.0, delta=0.25)
        smooth = study.select(self.convergence, part="mesh", scene="ball", method="Hermite, smooth surface")
        facets = study.select(self.convergence, part="mesh", scene="ball", method="Hermite, facets")
        for one, other in zip(smooth, facets):
            self.assertLess(one["error"], 0.05 * other["error"])

    def test_curved_and_uneven_body(self):
        # With edges of 2 mm and a radius of 90 mm the errors come from the sag of the facets, h²/(6R), and from the waves
        # of the layer: at most 1 % on the smooth surface.
        for tool in self.tools("head"):
            self.assertLess(self.error("head", tool, "Hermite 8, smooth surface"), 0.01)
            self.assertLess(self.error("head", tool, "Hermite 8"), 0.05)
            self.assertLess(self.error("head", tool, "reduced basis, 1 %"), 0.06)

    def test_finite_elements_agree_with_the_references(self):
        # The difference between finite and small strain, and the errors of the meshes (Data/Studies/calculix), are a few
        # per cent.
        for scene in ("half-space block", "10 mm layer"):
            for tool in ("sphere:6.35", "sphere:1.6", "flat:1.6"):
                self.assertLess(self.error(scene, tool, study.REFERENCE, "error_calculix"), 0.03)
                self.assertLess(abs(self.error(scene, tool, "Hermite 8", "error_calculix") -
                                    self.error(scene, tool, study.REFERENCE, "error_calculix")), 1e-3)


class StrainChecks:
    """Responses compared with curves at finite strain: the numbers in README and manual."""

    def errors(self, method, **wanted):
        return [row for row in self.rows if row["part"] == "force" and row["method"] == method and
                all(row[name] == value for name, value in wanted.items())]

    def test_finite_strain_is_stored(self):
        for row in self.errors("finite strain, stored", ball_mm=0.0):
            if not strain.is_pressed(row) or row["tool"].startswith("flat"):
                continue  # in CalculiX the rim of the flat moves with the flat, a difference of a few per cent
            with self.subTest(row=row):
                if row["code"] == "CalculiX" and row["nu"] == 0.3 and abs(row["depth_mm"] / 6.35 - 0.098) < 0.003:
                    continue  # one outlier of that curve
                # Errors of tables, storage and two meshes: 0.5 %. Layers by CalculiX: 1.3 % at the
                # largest depth, see ../calculix/README.md.
                calculix_layer = row["thickness_mm"] and row["code"] == "CalculiX"
                self.assertLess(abs(row["error"]), 0.014 if calculix_layer else 0.005)

    def test_small_strain_is_off_by_what_another_code_says(self):
        with open(run.DATA / "Reference" / "deep" / "finite_sphere_halfspace.csv", encoding="utf-8") as file:
            table = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        compared = 0
        for row in self.errors("small strain", code="solver", thickness_mm=0.0):
            near = [each for each in table if each["nu"] == row["nu"] and abs(each["delta_over_R"] - row["depth_mm"]) < 0.02]
            if row["tool"] == "sphere:1" and near and row["depth_mm"] > 0.1:
                # c changes by 0.1 per radius of depth: 0.2 % within 0.02; and 0.5 % between the
                # codes.
                self.assertAlmostEqual(row["error"], 1 / near[0]["c=F/F_small"] - 1, delta=0.007)
                compared += 1
        self.assertGreater(compared, 10)

    def test_the_stated_error_covers(self):
        for method in ("small strain", "finite strain, stored"):
            rows = [row for row in self.errors(method, code="solver") if strain.is_pressed(row)]
            held = sum(abs(row["error"]) <= row["stated_error"] + 0.001 for row in rows)  # 0.001: their mesh
            self.assertGreater(len(rows), 60)
            self.assertGreaterEqual(held, 0.95 * len(rows))

    def test_on_balls_curvature_is_the_larger_part(self):
        rows = self.errors("small strain, curvature", code="another code")
        self.assertEqual(len(rows), 9)
        for row, flat in zip(rows, self.errors("small strain", code="another code")):
            self.assertLess(abs(row["error"]), 0.5 * abs(flat["error"]))
            # The remaining error is the global deflection of the ball.
            self.assertAlmostEqual(row["error"], -0.46 * row["contact_radius_mm"] / row["ball_mm"], delta=0.005)


class Strain(StrainChecks, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        text = subprocess.run([str(PROGRAM), "--strain", str(run.DATA), "--no-times"], check=True, stdout=subprocess.PIPE,
                              universal_newlines=True).stdout
        cls.rows = strain.read(text)


class StrainCommitted(StrainChecks, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = strain.read((run.DATA / "Studies" / "accuracy-speed" / "finite-strain.csv").read_text(encoding="utf-8"))

    def test_the_tick_is_the_same(self):
        def median(method):
            return study.median([row["hot_ns"] for row in self.rows if row["part"] == "time" and row["method"] == method])

        # The kernel is the same, with other numbers. The tolerance is the scatter on a busy machine.
        for method in strain.METHODS:
            self.assertAlmostEqual(median(method) / median("small strain"), 1, delta=0.1)


class Relaxation(relaxation_checks.RelaxationChecks, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rows = relaxation.read(run.measure_relaxation(PROGRAM, ["--no-times"]))


class RelaxationCommitted(relaxation_checks.RelaxationChecks, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        file = run.DATA / "Studies" / "accuracy-speed" / "relaxation.csv"
        cls.rows = relaxation.read(file.read_text(encoding="utf-8"))


class Tilt(tilt_checks.TiltChecks, unittest.TestCase):
    text = staticmethod(lambda: run.measure_tilt(PROGRAM, ["--quick", "--no-times"]))


class TiltCommitted(tilt_checks.TiltChecks, unittest.TestCase):
    text = staticmethod(tilt_checks.committed)


def shape_table(name):
    with open(run.DATA / "Reference" / "shape" / name, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def sphere_on_half_space(size, depth):
    """Returns force over E* of the exact sphere: with l = ln((R+a)/(R-a)), δ = a l/2, F = (a²+R²) l/2 - aR."""
    low, high = 0.0, 0.999 * size
    for _ in range(60):
        a = (low + high) / 2
        logarithm = math.log((size + a) / (size - a))
        low, high = (a, high) if a * logarithm / 2 < depth else (low, a)
    return (a * a + size * size) * logarithm / 2 - a * size


class ShapeCommitted(unittest.TestCase):
    """The committed results for an edge, a horn and a nodule: the numbers in README and manual."""

    @staticmethod
    def rows_kept():
        return shape.read((run.DATA / "Studies" / "accuracy-speed" / "shape.csv").read_text(encoding="utf-8"))

    @classmethod
    def setUpClass(cls):
        cls.rows = cls.rows_kept()

    def of(self, body, method):
        found = shape.of(self.rows, body, method)
        self.assertEqual(len(found), {"edge": 4, "horn": 6, "nodule": 2 * 4 * 8}[body])  # rows of the tables
        return found

    def test_true_shape(self):
        for row in self.of("edge", shape.TRUE) + self.of("horn", shape.TRUE):
            # The table of the edge without harmonics has an error of 0.6 %; elements of a quarter
            # of the distance add 0.3 % of the force. The table of the ball, on meshes as fine as
            # this, has an error of 0.4 %; facets of 1 mm, h²/6R deep, add 0.3 %.
            self.assertLess(abs(row["error"]), 0.01, row)
        for row in self.of("nodule", shape.TRUE):
            # Mixed cells of 1 mm (vtkNoduleMaterial): the error is 1.5 % for tops at least two cells deep, 4 % for one.
            self.assertLess(abs(row["error"]), 0.04 if shape.abscissa(row) == 1 else 0.015, row)

    def test_coarse(self):
        for row in self.of("edge", shape.COARSE) + self.of("horn", shape.COARSE):
            # The elements are twice as large and of second order: four times the 0.3 % of the edge. Facets of 2 mm are
            # h²/6R deep: 1 % of the force.
            self.assertLess(abs(row["error"]), 0.015, row)
        for row in self.of("nodule", shape.COARSE):
            if shape.abscissa(row) >= 2:
                self.assertLess(abs(row["error"]), 0.04, row)   # one cell of 2 mm, see above
        # A cell twice as large as the depth of the top reaches the surface; its mixed material is
        # no longer valid there.
        self.assertGreater(max(abs(row["error"]) for row in self.of("nodule", shape.COARSE) if row["error"]), 0.1)

    def test_half_space_is_off_by_what_the_tables_say(self):
        reduced = 1 / (1 - 0.45 ** 2)
        for row, given in zip(self.of("edge", shape.HALF_SPACE), shape_table("edge_axisymmetric_vs_full.csv")):
            size, depth = float(row["tool"].split(":")[1]), float(given["delta"])
            force = reduced * (2 * size * depth if row["tool"].startswith("flat") else sphere_on_half_space(size, depth))
            self.assertAlmostEqual(row["error"], force / float(given["full 2-D: F"]) - 1, delta=2e-4) # digits, samples
            self.assertGreater(row["error"], 0.2)
        given = {(each["tool"].replace("sphere", "sphere:"), "a/R=" + each["a/R"]): float(each["err Hertz R_eff only %"])
                 for each in shape_table("hemisphere.csv") if each["nu"] == "0.45"}
        for row in self.of("horn", shape.HALF_SPACE):
            # The error of the half-space law for a sphere on a ball by Hertz; the facets of the mesh add 0.3 %.
            self.assertAlmostEqual(row["error"], given[row["tool"], row["case"]] / 100, delta=0.005)
        given = [each for each in shape_table("nodule_forces.csv") if each["R_nodule"] == "3.0"]
        for row in self.of("nodule", shape.HALF_SPACE):
            ratio = [float(each["F_half_space"]) / float(each["F_nodule"]) - 1 for each in given if
                     each["tool"] == row["tool"].replace(":", "") and float(each["delta"]) == row["depth_mm"] and
                     float(each["top_depth"]) == shape.abscissa(row) and float(each["E_ratio"]) == float(shape.modulus(row))]
            self.assertAlmostEqual(row["error"], ratio[0], delta=1e-3)      # the same closed forms, five digits

    def test_a_number_in_series(self):
        for row in self.of("edge", shape.IN_SERIES):
            self.assertLess(abs(row["error"]), 0.035, row)      # error of a table without the tilt
        # Over a nodule, C_g is the value at a single point. With H00 of the table, F = δ/(1/(2E*a) + H00) of the flat is
        # 26 % too large 2 mm above a hard nodule, and 13 % too small above a soft one. The error is larger for a sphere
        # whose contact is as wide as the nodule.
        wide = [row for row in self.of("nodule", shape.IN_SERIES) if row["tool"] == "sphere:6.35" and row["depth_mm"] == 1.2]
        for row in wide:
            if shape.abscissa(row) <= 2 and row["error"] is not None:
                self.assertGreater(abs(row["error"]), 0.13, row)

    def test_stated_errors(self):
        for body in shape.BODIES:
            for method in (shape.TRUE, shape.IN_SERIES):
                for row in self.of(body, method):
                    if row["error"] is not None:
                        self.assertLess(abs(row["error"]), row["stated_error"] + 0.0015, row)   # tables: 0.15 %
        for row in self.of("edge", shape.HALF_SPACE) + self.of("horn", shape.HALF_SPACE):
            self.assertLess(abs(row["error"]), row["stated_error"], row)
        # The response of a half-space ignores the structure below.
        for row in self.of("nodule", shape.HALF_SPACE):
            if shape.abscissa(row) == 1:
                self.assertGreater(abs(row["error"]), 2 * row["stated_error"], row)


class ShapeNow(unittest.TestCase):
    """Checks that the committed table is reproduced by the present code, for the edge on its coarse mesh."""

    def test_edge(self):
        import shape_bodies
        body = shape_bodies.edge(fine=None)
        body.cases = body.at("flat:1.5")
        found, = shape.rows_of(body, (shape.COARSE,), timed=False)
        kept, = [row for row in ShapeCommitted.rows_kept() if row["tool"] == "flat:1.5" and row["method"] == shape.COARSE]
        self.assertAlmostEqual(found["force_N"], kept["force_N"], delta=1e-4 * kept["force_N"])  # five digits
        self.assertAlmostEqual(found["error"], 0, delta=0.015)      # as for the table above


class Fronts(unittest.TestCase):
    def row(self, method, time, error, size=4.0):
        return {"scene": "s", "tool": "t", "method": method, "hot_ns": time, "error": error,
                "model_bytes_per_vertex": size}

    def test_front(self):
        rows = [self.row("a", 100, 0.5), self.row("b", 200, 0.1), self.row("worse", 250, 0.2), self.row("c", 300, 1e-3),
                self.row(study.REFERENCE, 1, 1e-9), self.row("equal, larger", 300, 1e-3, 80.0),
                self.row("rounding", 400, 1e-8), self.row("slower rounding", 500, 1e-9), self.row("untimed", None, 0.0)]
        self.assertEqual([row["method"] for row in study.front(rows)], ["a", "b", "c", "rounding"])

    def test_order(self):
        points = [{"size": size, "error": 0.3 * size ** 2} for size in (1.0, 2.0, 4.0)]
        self.assertAlmostEqual(study.order(points), 2.0, delta=1e-9)
        self.assertIsNone(study.order(points[:2]))

    def test_pooled(self):
        rows = [dict({name: None for name in run.METHOD_COLUMNS}, scene="s", tool=tool, method="m", error=error,
                     hot_ns=time) for tool, error, time in (("a", 3.0, 5.0), ("b", 4.0, 7.0))]
        pooled = study.pool(rows)
        self.assertEqual(len(pooled), 1)
        self.assertAlmostEqual(pooled[0]["error"], math.sqrt(12.5), delta=1e-12)
        self.assertAlmostEqual(pooled[0]["hot_ns"], 6.0, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
