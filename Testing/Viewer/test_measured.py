# SPDX-License-Identifier: BSD-3-Clause
"""--measured and --register: a body is pressed with a tool that was not used for the measurement."""
import os
import re
import unittest
from pathlib import Path

import bodies
from session import SessionCase, peak_force
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

EXAMPLE = Path(os.environ["PALPATE_DATA"]) / "Examples" / "cylinder_sphere_curves.csv"
SITES = {"left": (3.45, 0.03), "top": (3.45, 0.04), "right": (3.45, 0.05)}  # E* (MPa), C_g (mm/N)
MODULUS, RADIUS = 0.05, 25.0  # of the ball below


def interval(symbol, line):
    value, low, high = re.search(symbol + r" = ([\d.e+-]+) \S+ \(([\d.e+-]+) to ([\d.e+-]+)\)", line).groups()
    return float(low), float(value), float(high)


class Measured(SessionCase):
    def ball(self, *sites, tool="paraboloid:3"):
        """(body, curves): Hertz's curves of a paraboloid of 3 mm, on a ball that is treated as a half-space."""
        body = bodies.write(bodies.sphere(RADIUS), self.folder / "ball.vtp")
        curves = self.folder / "curves.csv"
        lines = [f"# tool: {tool}", "site,x_mm,y_mm,z_mm,deflection_mm,force_N"]
        for name, x, y, z in sites:
            lines += [f"{name},{x},{y},{z},{0.5 + i / 50},{4 / 3 * MODULUS * 3 ** 0.5 * max(i, 0) ** 1.5 / 50 ** 1.5:.9g}"
                      for i in range(-5, 51)]
        curves.write_text("\n".join(lines) + "\n")
        return body, curves

    def check_flat(self, result):
        """The force on a flat of 1 mm is 2 a E* δ at the reached depth; both are printed with four digits."""
        depth = float(re.search(r"peak\s+force \S+ N, deflection (\S+) mm", result.stdout).group(1))
        self.assertAlmostEqual(depth, 0.5, delta=0.01)  # the site is on a facet
        self.assertAlmostEqual(peak_force(result), 2 * 1 * MODULUS * depth, delta=2e-4 * 0.05)

    def test_example_of_the_cylinder(self):
        saved = self.folder / "saved.vtp"
        result = self.succeed("--scene", "cylinder", "--measured", EXAMPLE, "--tool", "sphere:1.6",
                              "--tool", "flat:1.6", "--save", saved,
                              pictures=("overview", "deflection", "curves", "tools"))
        for name, truth in SITES.items():
            line = re.search(f"Site '{name}': .*", result.stderr).group(0)
            for symbol, value in zip((r"E\*", "C_g"), truth):
                low, _, high = interval(symbol, line)
                self.assertTrue(low < value < high, line)
            self.assertIn("hysteresis", line)
        self.assertRegex(result.stdout, "model .*identified from synthetic curves of sphere:6.35 at 3 sites")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(saved))
        reader.Update()
        field = reader.GetOutput().GetFieldData()
        for name in ("ResponseModel", "Response2Model"):
            self.assertIn("synthetic", field.GetAbstractArray(name).GetValue(0))

    def test_other_tool_is_felt(self):
        body, curves = self.ball(("pole", 0, 0, RADIUS))
        result = self.succeed(body, "--measured", curves, "--tool", "flat:1", "--depth", "0.5")
        self.check_flat(result)
        self.assertIn("identified from measured curves", result.stdout)
        self.assertNotIn("synthetic", result.stdout)

    def test_registration(self):
        body, curves = self.ball(("pole", RADIUS + 10, 0, 0))  # x of the curves is the body's z, shifted by 10 mm
        self.refuse(body, "--measured", curves, words=("'pole': lies 10", "mm from the surface"))
        matrix = self.folder / "matrix.txt"
        matrix.write_text("0 1 0 0\n0 0 1 0\n1 0 0 -10\n0 0 0 1\n")
        result = self.succeed(body, "--measured", curves, "--register", matrix, "--tool", "flat:1",
                              "--depth", "0.5")
        self.assertIn("Registration: sites lie", result.stderr)
        self.check_flat(result)

    def test_sites_that_cannot_be_used_are_named(self):
        body, curves = self.ball(("pole", 0, 0, RADIUS), ("astray", 0, 0, 60))
        result = self.succeed(body, "--measured", curves)
        self.assertIn("1 of 2 sites are not used: site 'astray': lies 35 mm", result.stderr)
        body, curves = self.ball(("pole", 0, 0, RADIUS), tool="flat:3")
        self.refuse(body, "--measured", curves, words=("'pole'",))

    def test_the_largest_strain_is_an_option_and_named(self):
        body, curves = self.ball(("pole", 0, 0, RADIUS))
        # The strain of a paraboloid is √(δ/R): 0.4 at 0.48 mm. The readings are 0.02 mm apart, up
        # to 1 mm; 26 of them are deeper and one is at this depth.
        result = self.succeed(body, "--measured", curves)
        self.assertRegex(result.stderr, "2[67] of 56 readings are not used: they lie deeper than the largest strain of 0.4 allows")
        result = self.succeed(body, "--measured", curves, "--max-strain", "0.6")  # up to 1.08 mm
        self.assertNotIn("readings are not used", result.stderr)
        self.refuse(body, "--measured", curves, "--max-strain", "0.1",  # up to 0.03 mm
                    words=("the largest strain of 0.1 leaves 7 of 56 readings; 8 are needed",))
        self.refuse(body, "--max-strain", "0.1", words=("--measured",))
        self.refuse(body, "--measured", curves, "--max-strain", "0", words=("--max-strain",))

    def test_signs_and_units_are_asked(self):
        body, curves = self.ball(("pole", 0, 0, RADIUS))
        head, *rows = curves.read_text().splitlines()[1:]
        rows = [row.split(",") for row in rows]

        def write(name, deflection, force, *more):
            lines = ["# tool: paraboloid:3", *more, head]
            lines += [",".join((*row[:4], f"{float(row[4]) * deflection:.9g}", f"{float(row[5]) * force:.9g}"))
                      for row in rows]
            path = self.folder / name
            path.write_text("\n".join(lines) + "\n")
            return path
        self.refuse(body, "--measured", write("down.csv", 1, -1),
                    words=("'pole': forces fall from 0 to -0.1", "is compression negative here?"))
        self.refuse(body, "--measured", write("um.csv", 1000, 1), words=("'pole': the deflection goes", "is it in um?"))
        result = self.succeed(body, "--measured", write("turned.csv", 1, -1, "# negative: force"), "--tool", "flat:1",
                              "--depth", "0.5")
        self.check_flat(result)
        semicolons = self.folder / "semicolons.csv"
        semicolons.write_text("# tool: paraboloid:3;;;;\n" + head.replace("site,", "").replace("_N", "_mN").replace(",", ";")
                              + "\n" + "".join(";".join((*row[1:5], f"{1000 * float(row[5]):.9g}")).replace(".", ",") + "\n"
                                               for row in rows))
        result = self.succeed(body, "--measured", semicolons, "--tool", "flat:1", "--depth", "0.5")
        self.assertIn("Site '(0, 0, 25)': half-space", result.stderr)
        self.check_flat(result)

    def test_wrong_calls(self):
        body, curves = self.ball(("pole", 0, 0, RADIUS))
        self.refuse(body, "--measured", curves, "--young", "0.1", words=("--young",))
        self.refuse(body, "--register", curves, words=("--measured",))
        self.refuse(body, "--measured", curves, "--reach", "0", words=("--reach",))
        self.refuse(body, "--measured", self.folder / "none.csv", words=("none.csv", "cannot be opened"))
        curves.write_text(curves.read_text().replace("deflection_mm", "depth_mm"))
        self.refuse(body, "--measured", curves, words=("curves.csv:2", "deflection_mm"))


if __name__ == "__main__":
    unittest.main()
