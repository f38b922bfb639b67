# SPDX-License-Identifier: BSD-3-Clause
"""--compare and --map: the results agree with beam theory, half-space and layer."""
import math
import re
import unittest

from session import SessionCase, run

MODULUS = 3.45  # E*, MPa
POISSON = 0.45
YOUNG = MODULUS * (1 - POISSON ** 2)
# Span of the strip between its rollers, width, thickness of the strip, height of the block, mm.
SPAN, WIDTH, THICKNESS, HEIGHT = 56.0, 20.0, 3.0, 20.0
FLAT = 1.6  # radius of the flat tool


def tools(printed, title):
    """Tool -> (force, lambda, sensitivity) from the lines below a title."""
    part = printed.split(title)[1].split("\n\n")[0]
    found = re.findall(r"^  (\S+)\s+(\S+) N, lambda (\S+), sensitivity (\S+)$", part, re.M)
    return {name: tuple(map(float, numbers)) for name, *numbers in found}


def in_series(compliance, depth, law):
    """Force of a tool with law(depth) on a half-space, in series with a compliance."""
    low, high = 0.0, depth
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if middle + compliance * law(middle) < depth else (low, middle)
    return law(low)


def paraboloid(radius):
    return lambda depth: 4 / 3 * MODULUS * math.sqrt(radius) * depth ** 1.5


class Comparison(SessionCase):
    def compare(self, *arguments):
        result = run("--compare", *arguments, "--output", self.output)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(set(self.files()), {"comparison.png", "regime.png", "strip.csv",
                                             "block.csv"})
        return result.stdout

    def test_global_curves_coincide_and_local_ones_do_not(self):
        said = self.compare("--tool", "flat:1.6", "--tool", "paraboloid:6.35", "--tool", "paraboloid:1.6")
        strip, block = tools(said, "Strip"), tools(said, "Block")
        self.assertEqual(len(strip), 3)
        spread = {}
        for name, body in (("strip", strip), ("block", block)):
            forces = [force for force, _, _ in body.values()]
            spread[name] = (max(forces) - min(forces)) / (sum(forces) / 3)
        self.assertLess(spread["strip"], 0.05)
        self.assertGreater(spread["block"], 0.5)
        self.assertRegex(said, r"Strip.*\nA point force suffices")
        self.assertRegex(said, r"Block.*\nThe shape of the tool matters\.")

        # The law of the flat is linear, so its force gives the compliance. The strip is a beam on
        # two supports, L^3/48EI. Shear makes it softer (2 %: 6/5 F L/4GA). If it cannot bend across
        # its width, it is stiffer, at most like a plate, for which E is replaced by E/(1 - nu^2).
        force = strip["flat:1.6"][0]
        compliance = 1.0 / force - 1.0 / (2 * MODULUS * FLAT)
        inertia = WIDTH * THICKNESS ** 3 / 12
        beam = SPAN ** 3 / (48 * YOUNG * inertia)
        self.assertGreater(compliance, (1 - POISSON ** 2) * beam)
        self.assertLess(compliance, 1.02 * beam)
        # The other tools in series with this compliance. Eight samples store their curves to 0.5 %.
        for name, radius in (("paraboloid:6.35", 6.35), ("paraboloid:1.6", 1.6)):
            force, index, sensitivity = strip[name]
            expected = in_series(compliance, 1.0, paraboloid(radius))
            self.assertAlmostEqual(force, expected, delta=0.01 * expected)
            self.assertAlmostEqual(index, compliance * expected, delta=0.002)
            self.assertAlmostEqual(sensitivity, (1 - index) / (2 + index), delta=0.001)  # printed digits

        # The block is stiffer than a half-space, but less stiff than an infinite bonded layer: 1 -
        # delta_hs/delta = M0 2a/(pi h) to first order, M0 = -1.63 (layer_bonded_moments.csv, nu
        # 0.45).
        force, index, _ = block["flat:1.6"]
        self.assertGreater(force, 2 * MODULUS * FLAT)
        self.assertLess(index, 0.0)
        self.assertGreater(index, -1.63 * 2 * FLAT / (math.pi * HEIGHT))

    def test_one_material_for_both(self):
        said = self.compare("--young", "0.1", "--poisson", "0.3", "--tool", "flat:2", "--depth", "0.5")
        self.assertIn("E = 0.1 MPa, nu = 0.3 (given on the command line)", said)
        self.assertIn("At 0.50 mm", said)
        force, index, _ = tools(said, "Block")["flat:2"]
        # The result is close to a half-space, because the block adds less than a tenth.
        self.assertAlmostEqual(force, 2 * 0.1 / (1 - 0.3 ** 2) * 2 * 0.5, delta=0.02)
        self.assertAlmostEqual(index, 0.0, delta=0.1)

    def test_what_has_no_meaning_beside_it_is_refused(self):
        for arguments, word in (
                (("body.stl",), "--compare"),
                (("--voxel", "2"), "--voxel"),
                (("--layer", "5"), "--layer"),
                (("--layers", "1:1:0.4"), "--layers"),
                (("--device", "replay:x.csv"), "--device"),
                (("--map",), "--map"),
                (("--trial", "sphere:3,flat:1"), "--trial"),
                (("--poisson", "0.5"), "Poisson's Ratio")):
            with self.subTest(arguments=arguments):
                self.refuse("--compare", *arguments, words=(word,))


class Map(SessionCase):
    def map(self, *arguments):
        result = run("--map", *arguments, "--output", self.output)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(set(self.files()), {"map.png"})
        return result.stdout

    def test_a_half_space_needs_the_shape_everywhere(self):
        said = self.map("--scene", "cylinder", "--tool", "paraboloid:3", "--depth", "0.5")
        self.assertIn("The shape of the tool matters on 100.0 % of the surface", said)
        self.assertIn("Tool sensitivity: 0.50 to 0.50", said)  # 1/2: F is proportional to the square root of R
        self.assertRegex(said, r"Regime index .lambda.: -?0.00 to -?0.00")

    def test_a_layer_stiffens(self):
        said = self.map("--scene", "cylinder", "--tool", "sphere:6.35", "--layer", "5", "--depth", "1")
        low, high = map(float, re.search(r"Regime index .lambda.: (\S+) to (\S+)", said).groups())
        self.assertLess(high, -0.2)
        self.assertEqual(low, high)  # the same layer everywhere
        stack = self.map("--scene", "cylinder", "--tool", "sphere:6.35", "--layers", "2:0.1:0.45,3:0.1:0.45", "--depth", "1")
        index = float(re.search(r"Regime index .lambda.: (\S+) to", stack).group(1))
        one = self.map("--scene", "cylinder", "--tool", "sphere:6.35", "--layer", "5", "--poisson", "0.45", "--depth", "1")
        self.assertAlmostEqual(index, float(re.search(r"Regime index .lambda.: (\S+) to", one).group(1)), delta=0.011)

    def test_a_response_without_material_has_no_map(self):
        saved = self.folder / "saved.vtp"
        result = run("--scene", "cylinder", "--save", saved, "--no-pictures", "--output", self.folder / "first")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.refuse("--map", saved, words=("material",))


if __name__ == "__main__":
    unittest.main()
