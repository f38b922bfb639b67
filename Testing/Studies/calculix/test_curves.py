#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the committed finite-element curves (Data/Studies/calculix) with contact and plate theory.

CalculiX is not needed. The accuracy of the curves has two limits: mesh_error.csv (elements twice as
large), and the scatter from depth to depth, up to 0.3 %, of the contact search, which converges to
0.1 % of the touching points. MESH allows both. Larger differences between curves and theory are
physical; the test states their size.
"""
import pathlib
import unittest

import numpy as np

import cases
import compare
import theory

REFERENCE = pathlib.Path(__file__).resolve().parents[3] / "Data" / "Reference"
MESH = 0.006


def curve(body, tool, material, suffix=""):
    name = "{}-{}-{}{}".format(body.name, tool.name, material, suffix)
    return (cases.CASES[name],) + compare.read_curve(compare.DATA / (name + ".csv"))


def ratio_to_theory(body, tool, material, suffix=""):
    """Returns deflections, contact radius over tool radius, and force over that of the exact small-strain law."""
    case, deflections, forces = curve(body, tool, material, suffix)
    return (deflections, compare.contact_radii(case, deflections),
            forces / compare.predicted(case, deflections))


class TestTheory(unittest.TestCase):
    """Tests the laws of theory.py."""

    def table(self, name):
        with open(REFERENCE / name, encoding="utf-8") as lines:
            rows = [line.strip().split(",") for line in lines]
        return np.array(rows[0][1:], float), {row[0]: np.array(row[1:], float) for row in rows[1:]}

    def test_half_space(self):
        with open(REFERENCE / "punches.csv", encoding="utf-8") as lines:
            rows = [line.split(",") for line in lines if line.startswith("sphere_exact")]
        self.assertGreater(len(rows), 2)
        for row in rows:
            radius, depth, force = float(row[0].split("=")[1]), float(row[1]), float(row[3])
            self.assertAlmostEqual(
                theory.half_space_force("sphere", radius, 3.45, depth) / force, 1, delta=1e-10)

    def test_bonded_layer(self):
        stiffening, values = self.table("layer_bonded_flat_kappa.csv")
        ratios, spheres = self.table("layer_bonded_sphere_ratio.csv")
        for nu in ("0.3", "0.45"):
            layer = theory.BondedLayer(10, float(nu))
            for a, kappa in zip(stiffening[stiffening <= 1], values[nu]):
                self.assertAlmostEqual(layer.force("flat", 10 * a, 1, 1) / (20 * a), kappa, delta=1e-8)
            # chi = sqrt(R depth) / h; the table is for the paraboloid. Bisection to seven digits.
            for chi, expected in zip(ratios[ratios <= 1], spheres[nu]):
                depth = (10 * chi) ** 2 / 6.35
                hertz = 4 / 3 * np.sqrt(6.35) * depth ** 1.5
                self.assertAlmostEqual(layer.force("paraboloid", 6.35, 1, depth) / hertz, expected, delta=1e-6)

    def test_thin_plate(self):
        # Infinitely wide plate: 0.01695 P L^2 / D (Timoshenko and Woinowsky-Krieger, article 36,
        # four digits).
        rigidity = 0.1 * 6 ** 3 / (12 * (1 - 0.45 ** 2))
        wide = theory.thin_plate_compliance(60, 6000, 6, 0.1, 0.45)
        self.assertAlmostEqual(wide * rigidity / 60 ** 2, 0.01695, delta=2e-5)
        # A narrow plate is a beam: L^3 / 48 EI. Anticlastic bending adds terms of the order (width / length)^2.
        narrow = theory.thin_plate_compliance(60, 0.6, 6, 0.1, 0.45)
        self.assertAlmostEqual(narrow * 48 * 0.1 * 0.6 * 6 ** 3 / 12 / 60 ** 3, 1, delta=2e-4)


class TestFiles(unittest.TestCase):
    def test_every_case_is_there(self):
        for name, case in cases.CASES.items():
            with self.subTest(name):
                deflections, forces = compare.read_curve(compare.DATA / (name + ".csv"))
                np.testing.assert_allclose(deflections, cases.deflections(case), rtol=1e-5)
                self.assertTrue(np.all(np.diff(forces, prepend=0) > 0))
                head = (compare.DATA / (name + ".csv")).read_text(encoding="utf-8")
                self.assertIn("# tool: {}:{:g}\n".format(case.tool.shape, case.tool.radius), head)
                self.assertIn("# origin: CalculiX ", head)

    def test_mesh_error(self):
        with open(compare.DATA / "mesh_error.csv", encoding="utf-8") as table:
            errors = dict(line.strip().split(",") for line in list(table)[1:])
        for name, case in cases.CASES.items():
            if case.material == "linear" and case.body.half_width == 0:
                self.assertLess(float(errors[name]), 2 * MESH, name)


class TestLocalBodies(unittest.TestCase):
    """The block that stands for a half-space (0.2 % stiffer: 2 |M0| a / (pi h) with a = 3.4, h = 2000 mm)
    and the layer bonded to a rigid base."""

    def test_flat_in_small_strain(self):
        # The contact area is given, so the problem is linear and identical to that of the theory.
        for body in (cases.BLOCK, cases.LAYER):
            _, _, ratio = ratio_to_theory(body, cases.FLAT, "linear")
            np.testing.assert_allclose(ratio, 1, atol=0.002)

    def test_spheres_at_small_contact(self):
        # At larger depths CalculiX's small strain differs from theory. Probably CalculiX uses displaced points for contact
        # and pressures along the sphere's normal, both unlike the theory.
        for body in (cases.BLOCK, cases.LAYER):
            for tool in (cases.LARGE, cases.SMALL):
                _, contact, ratio = ratio_to_theory(body, tool, "linear")
                self.assertGreater(np.count_nonzero(contact < 0.26), 1)
                np.testing.assert_allclose(ratio[contact < 0.26], 1, atol=MESH)

    def test_small_strain_depends_on_contact_over_radius_only(self):
        # A half-space has no length scale: the deviations of both spheres from theory form one
        # curve.
        _, large_contact, large = ratio_to_theory(cases.BLOCK, cases.LARGE, "linear")
        _, small_contact, small = ratio_to_theory(cases.BLOCK, cases.SMALL, "linear")
        np.testing.assert_allclose(np.interp(large_contact[2:], small_contact, small), large[2:], atol=MESH)
        self.assertLess(large[-1], 0.97)

    def test_finite_strain_follows_the_exact_law(self):
        # Neo-Hooke stays within 1.5 % of the small-strain law of the exact sphere up to a/R = 0.65
        # on the block, and within 3 % up to a depth of 0.3 layer thicknesses.
        for body, tool, allowed in ((cases.BLOCK, cases.LARGE, 0.015), (cases.BLOCK, cases.SMALL, 0.015),
                                    (cases.LAYER, cases.LARGE, 0.03), (cases.LAYER, cases.SMALL, 0.03)):
            _, _, ratio = ratio_to_theory(body, tool, "neohooke")
            np.testing.assert_allclose(ratio, 1, atol=allowed)

    def test_paraboloid_would_not(self):
        # The same data show the error of Hertz's parabola in place of the sphere.
        case, deflections, forces = curve(cases.BLOCK, cases.SMALL, "neohooke")
        modulus = compare.reduced_modulus(case.body)
        hertz = 4 / 3 * modulus * np.sqrt(case.tool.radius) * deflections ** 1.5
        self.assertGreater(hertz[-1] / forces[-1], 1.05)

    def test_flat_softens_in_finite_strain(self):
        for body in (cases.BLOCK, cases.LAYER):
            deflections, _, ratio = ratio_to_theory(body, cases.FLAT, "neohooke")
            np.testing.assert_allclose(ratio[0], 1, atol=MESH)
            self.assertTrue(np.all(np.diff(ratio) < 0))
            np.testing.assert_allclose(ratio[-1], 0.968, atol=MESH)

    def test_quarter_model_agrees_with_axisymmetric_one(self):
        axial, _, expected = ratio_to_theory(cases.LAYER, cases.LARGE, "linear")
        case, deflections, forces = curve(cases.QUARTER_LAYER, cases.LARGE, "linear")
        layer = theory.BondedLayer(case.body.thickness, case.body.poisson_ratio)
        modulus = compare.reduced_modulus(case.body)
        law = np.array([layer.force("sphere", case.tool.radius, modulus, d) for d in deflections])
        # The elements of the quarter model are more than three times as large.
        np.testing.assert_allclose(forces / law, np.interp(deflections, axial, expected), atol=2 * MESH)


class TestPlates(unittest.TestCase):
    TOOLS = (cases.FLAT, cases.LARGE, cases.SMALL)

    def forces(self, body, material):
        return np.array([curve(body, tool, material)[2] for tool in self.TOOLS])

    def compliance(self, body, tool, material="linear"):
        """Returns the compliance of the series model, times E*, at each depth, 1/mm."""
        return compare.compliance(*curve(body, tool, material)) * compare.reduced_modulus(body)

    def test_tools_approach_each_other(self):
        # The spread is (largest - smallest force) / mean at one depth. On a half-space it falls to 0.64 and rises again.
        for body, deepest in ((cases.CLAMPED, 0.18), (cases.EDGES, 0.11)):
            for material in ("linear", "neohooke"):
                forces = self.forces(body, material)
                spread = np.ptp(forces, axis=0) / forces.mean(axis=0)
                self.assertTrue(np.all(np.diff(spread[1:]) < 0), spread)
                self.assertLess(spread[-1], deepest)
        modulus = compare.reduced_modulus(cases.CLAMPED)
        for depth in compare.read_curve(compare.DATA / "plateclamped-flat1.6-linear.csv")[0][:8]:
            local = np.array([theory.half_space_force(tool.shape, tool.radius, modulus, depth)
                              for tool in self.TOOLS])
            self.assertGreater(np.ptp(local) / local.mean(), 0.6)

    def test_clamped_plate_compliance(self):
        # C_g E* = 3.4516 /mm is the regular part of the Green function of the same plate (b = 30, t
        # = 4, nu = 0.3), so it holds for a small contact: the large sphere at the first depth, a =
        # 0.4 mm. For a wide contact the value is smaller: the error of the series model is of order
        # (a/t)^3 of the local part.
        first = self.compliance(cases.CLAMPED, cases.LARGE)[0]
        self.assertAlmostEqual(first / 3.4516, 1, delta=0.003)
        for tool in self.TOOLS:
            # The error for the flat is 0.064 of the local part 1/(2a), times 1.5 to 3.
            np.testing.assert_allclose(self.compliance(cases.CLAMPED, tool) / 3.4516, 1, atol=0.02)

    def test_plate_on_edges_compliance(self):
        # Kirchhoff's plate ignores shear. For the clamped plate shear adds 2.8 % (3.4516 / 3.3572)
        # at thickness / radius 0.13; here the span is ten times the thickness.
        thin = theory.thin_plate_compliance(60, 40, 6, cases.YOUNGS_MODULUS, cases.EDGES.poisson_ratio)
        thin *= compare.reduced_modulus(cases.EDGES)
        for tool in self.TOOLS:
            # From the second depth on: at the first depth the contact of the small sphere covers
            # few elements.
            found = self.compliance(cases.EDGES, tool)[1:]
            self.assertTrue(np.all((found > thin) & (found < 1.03 * thin)), found / thin)

    def test_one_tool_predicts_the_others(self):
        # C_g comes from the first depth of the flat; then delta = delta_hs(F) + C_g F for the
        # spheres.
        for body in (cases.CLAMPED, cases.EDGES):
            identified = compare.compliance(*curve(body, cases.FLAT, "linear"))[0]
            for tool in (cases.LARGE, cases.SMALL):
                _, deflections, forces = curve(body, tool, "linear")
                model = [theory.series_force(tool.shape, tool.radius, compare.reduced_modulus(body),
                                             identified, depth) for depth in deflections]
                # 1.3 % at the first depth of the clamped plate, where the contact of the sphere is
                # far smaller than that of the flat (above), plus scatter of the contact search.
                np.testing.assert_allclose(model[1:], forces[1:], rtol=0.013)

    def test_finite_strain_stiffens_plates(self):
        # At a depth of half their thickness plates also carry by stretching, which C_g does not
        # include: 3 to 6 %.
        for body in (cases.CLAMPED, cases.EDGES):
            ratio = self.forces(body, "neohooke")[:, -1] / self.forces(body, "linear")[:, -1]
            self.assertTrue(np.all((ratio > 1.02) & (ratio < 1.07)), ratio)


class TestValidity(unittest.TestCase):
    """The depths up to which the exact small-strain law agrees with Neo-Hooke; the README has these numbers."""

    def test_half_space_by_contact_over_radius(self):
        _, contact, ratio = ratio_to_theory(cases.BLOCK, cases.LARGE, "neohooke", "-deep")
        self.assertGreater(contact[-1], 0.75)
        np.testing.assert_allclose(ratio, 1, atol=0.02)

    def test_layer_by_depth_over_thickness(self):
        deflections, _, ratio = ratio_to_theory(cases.LAYER, cases.HUGE, "neohooke", "-deep")
        five, ten = (compare.depth_of_error(deflections, ratio, error) / cases.LAYER.thickness
                     for error in (0.05, 0.1))
        # Two per cent of the force correspond to 0.05 of the thickness here.
        self.assertAlmostEqual(five, 0.25, delta=0.03)
        self.assertAlmostEqual(ten, 0.41, delta=0.03)


if __name__ == "__main__":
    unittest.main()
