# SPDX-License-Identifier: BSD-3-Clause
"""trajectory.csv and the summary: columns, one row per tick, consistent numbers."""
import re
import unittest

import numpy

import bodies
from session import SessionCase

COLUMNS = ("time_s,tip_x_mm,tip_y_mm,tip_z_mm,contact_x_mm,contact_y_mm,contact_z_mm,deflection_mm,"
           "normal_force_N,friction_x_N,friction_y_N,friction_z_N,ideal_force_N,state").split(",")
RADIUS = 25.0
FACETS = 0.05  # mm; largest depth of the facets below the sphere


def read(path):
    """Column name -> values. Every line must have all columns, and only numbers."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    rows = [[float(word) for word in line.split(",")] for line in lines[1:]]
    if any(len(row) != len(names) for row in rows):
        raise ValueError("a row with another number of columns")
    return names, dict(zip(names, numpy.array(rows).T))


def number(pattern, text):
    return float(re.search(pattern, text).group(1))


class Trajectory(SessionCase):
    def press(self, *arguments):
        path = bodies.write(bodies.sphere(RADIUS), self.folder / "body.vtp")
        result = self.succeed(path, "--tool", "sphere:3", "--young", "0.1", "--poisson", "0.45",
                              "--site", "0,0,1", "--slide-to", "0.5,0,1", *arguments)
        names, table = read(self.output / "trajectory.csv")
        self.assertEqual(names, COLUMNS)
        return result, table

    @staticmethod
    def points(table, name):
        return numpy.stack([table[f"{name}_{axis}_mm"] for axis in "xyz"], axis=1)

    def test_rows_are_ticks(self):
        for rate in (1000, 250):
            with self.subTest(rate=rate):
                result, table = self.press("--rate", rate)
                ticks = len(table["time_s"])
                self.assertEqual(number(r"session\s+(\d+) ticks", result.stdout), ticks)
                numpy.testing.assert_allclose(table["time_s"], numpy.arange(ticks) / rate, atol=1e-12)
                # Approach 5 mm and press 1 mm at 5 mm/s, slide of 0.46 rad at 40 mm/s, two rests of
                # 0.25 s.
                expected = 2 * 6.0 / 5.0 + numpy.arctan(0.5) * RADIUS / 40.0 + 0.5
                self.assertAlmostEqual(ticks / rate, expected, delta=0.01)

    def test_numbers_fit_together(self):
        result, table = self.press()
        tip, contact = self.points(table, "tip"), self.points(table, "contact")
        depth, force, state = table["deflection_mm"], table["normal_force_N"], table["state"]
        touching = state > 0
        self.assertEqual(set(state), {0.0, 2.0})
        self.assertEqual(number(r"(\d+) in contact", result.stdout), touching.sum())
        # There is contact if and only if the tip is inside. The deflection is the distance of the
        # tip from the contact point.
        outside = numpy.linalg.norm(tip, axis=1) > RADIUS
        self.assertFalse((touching & outside).any())
        self.assertTrue(touching[numpy.linalg.norm(tip, axis=1) < RADIUS - FACETS].all())
        numpy.testing.assert_allclose(
            numpy.linalg.norm(tip - contact, axis=1)[touching], depth[touching], atol=1e-12)
        self.assertTrue((depth[touching] > 0.0).all() and (force[touching] > 0.0).all())
        for name in COLUMNS[4:13]:
            self.assertTrue((table[name][~touching] == 0.0).all(), name)
        for axis in "xyz":
            self.assertTrue((table[f"friction_{axis}_N"] == 0.0).all())
        numpy.testing.assert_allclose(table["ideal_force_N"], force, rtol=1e-14)
        # The summary states the largest force and the deflection there, rounded to four digits.
        self.assertAlmostEqual(number(r"force ([\d.e+-]+) N", result.stdout), force.max(), delta=1e-3)
        self.assertAlmostEqual(number(r"deflection ([\d.e+-]+) mm", result.stdout), depth[force.argmax()],
                               delta=1e-3)
        self.assertAlmostEqual(depth.max(), 1.0, delta=FACETS)

    def test_force_is_the_tools_law(self):
        from palpate import vtkContactTool
        tool = vtkContactTool()
        tool.SetShapeToSphere()
        tool.SetRadius(3.0)
        _, table = self.press("--no-curvature")
        reduced = 0.1 / (1.0 - 0.45 ** 2)
        touching = table["state"] > 0
        for depth, force in zip(table["deflection_mm"][touching], table["normal_force_N"][touching]):
            self.assertAlmostEqual(force, tool.GetForce(depth, reduced), delta=2e-3 * force + 1e-9)

    def test_the_summary_tells_the_error_of_the_forces(self):
        said, _ = self.press()
        found = re.search(r"^  error +± ([\d.]+) %(?: typically, ± ([\d.]+) % at most)?, mainly due to [a-z ]+"
                          r"(?:; above ± 5 % in ([\d.]+) % of the contact)?$", said.stdout, re.MULTILINE)
        self.assertTrue(found, said.stdout)
        typical = float(found.group(1))
        # One number if all three are equal.
        largest, above = float(found.group(2) or typical), float(found.group(3) or 0)
        # The global deflection of a ball of 25 mm adds 0.46 a/R_b to its law: 3 % at 1 mm. Strain
        # adds 2 %.
        self.assertTrue(1 < typical <= largest < 10 and 0 <= above < 100, found.groups())
        self.assertEqual(above > 0, largest > 5, found.groups())
        plain, _ = self.press("--error-tolerance", "0")
        self.assertRegex(plain.stdout, r"(?m)^  error +not stored; the law is valid in [\d.]+ % of the contact")
        self.assertNotIn("±", plain.stdout)

    def test_friction_against_the_slide(self):
        coefficient = 0.4
        felt = []
        for arguments in (("elasto-plastic", "--force-form", "normalized",
                           "--contact-surface", "facets"),
                          ("dahl", "--force-form", "paper"),
                          ("shape", "--force-form", "energy", "--contact-surface", "smooth")):
            with self.subTest(arguments=arguments):
                result, table = self.press("--friction", coefficient, "--tangential-stiffness", "5",
                                           "--friction-model", *arguments)
                self.assertRegex(result.stdout, r"friction +mu = 0\.4, ")
                friction = numpy.stack([table[f"friction_{axis}_N"] for axis in "xyz"], axis=1)
                size, normal = numpy.linalg.norm(friction, axis=1), table["normal_force_N"]
                self.assertEqual(set(table["state"]), {0.0, 1.0, 2.0})
                self.assertAlmostEqual(number(r"friction .*; peak ([\d.e+-]+) N", result.stdout),
                                       size.max(), delta=1e-3 * size.max())
                # Coulomb's law, with the rounding error of a vector's length.
                self.assertTrue((size <= coefficient * normal * (1 + 1e-9)).all())
                # The resultant of normal force and friction, which are perpendicular.
                numpy.testing.assert_allclose(table["ideal_force_N"], numpy.hypot(normal, size),
                                              rtol=1e-9, atol=1e-12)
                # In the middle of the slide from +z towards +x: friction is at the limit, against
                # the motion.
                contact = self.points(table, "contact")
                middle = numpy.argmin(numpy.abs(contact[:, 0] - 0.2 * RADIUS) + (normal == 0) * RADIUS)
                motion = contact[middle + 5] - contact[middle - 5]
                self.assertAlmostEqual(size[middle], coefficient * normal[middle],
                                       delta=1e-3 * normal[middle])
                along = friction[middle] @ motion / (size[middle] * numpy.linalg.norm(motion))
                self.assertLess(along, -0.99)  # except for the tilt of the facets
                felt.append(size)
        for i, j in ((0, 1), (0, 2), (1, 2)):
            self.assertTrue((felt[i] != felt[j]).any())

    def test_deeper_than_the_response_reaches(self):
        _, table = self.press("--max-deflection", "0.5")
        deep = table["deflection_mm"] > 0.5
        self.assertTrue((table["state"][deep] == 3.0).all())
        self.assertEqual(set(table["state"][~deep]), {0.0, 2.0})


if __name__ == "__main__":
    unittest.main()
