# SPDX-License-Identifier: BSD-3-Clause
"""By default the compliance of a closed body as a whole is included. The body is held on the side on which it
stands."""
import re
import unittest

import bodies
from session import SessionCase, peak_force

HELD = r"the forces include the deflection of the whole body, held at (\S+) "


class WholeBody(SessionCase):
    def press_ball(self, *arguments, **more):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        return self.succeed(path, "--tool", "sphere:3", "--young", "0.1", "--poisson", "0.45", *arguments,
                            environment={"PALPATE_CACHE": str(self.folder / "cache")}, **more)

    def solutions(self):
        """File in the cache -> time of writing."""
        return {file: file.stat().st_mtime_ns for file in (self.folder / "cache").rglob("compliance-*")}

    def test_a_ball_is_softer_than_a_half_space(self):
        local = self.press_ball()
        self.assertNotRegex(local.stderr, HELD)
        whole = self.press_ball(whole_body=True)
        solved = self.solutions()
        self.assertEqual(len(solved), 1)
        side = re.search(HELD, whole.stderr).group(1)
        # On a ball of diameter d, a cap of height h has a projected area of pi h (d - h),
        # which is a quarter of the square at h = 0.09 d. Only whole rings of triangles are held, so
        # the next step of 3 % is used: 12 % of 50 mm.
        self.assertEqual(side, "z-:6")
        self.assertIn("in series with the compliance of the whole body", whole.stdout)
        self.assertLess(peak_force(whole), peak_force(local))
        again = self.press_ball(whole_body=True)
        self.assertEqual(peak_force(again), peak_force(whole))
        self.assertEqual(self.solutions(), solved)
        held = self.press_ball("--fixed", "z-:25", whole_body=True)
        self.assertEqual(re.search(HELD, held.stderr).group(1), "z-:25")
        self.assertGreater(peak_force(held), peak_force(whole))

    def test_it_is_left_out_with_a_layer_and_on_large_triangles(self):
        self.assertNotRegex(self.press_ball("--layer", "5", whole_body=True).stderr, HELD)
        cube = bodies.write(bodies.cube(), self.folder / "cube.vtp")
        result = self.succeed(cube, "--tool", "sphere:1", "--depth", "0.2", whole_body=True)
        self.assertNotRegex(result.stderr, HELD)
        self.assertIn("triangles of the surface are too large", result.stderr)

    def test_a_side_needs_a_body_that_yields(self):
        path = bodies.write(bodies.sphere(), self.folder / "ball.vtp")
        self.refuse(path, "--fixed", "z-", "--no-whole-body", words=["--fixed", "--no-whole-body"])


if __name__ == "__main__":
    unittest.main()
