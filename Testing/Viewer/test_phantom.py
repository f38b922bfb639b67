# SPDX-License-Identifier: BSD-3-Clause
"""palpate --scene phantom: nodules change the force as computed by another code; a map; blind trials with lump and
none."""
import csv
import os
import re
import subprocess
import unittest
from pathlib import Path

from session import CACHE, PALPATE, PICTURES, SessionCase, peak_force, run

TABLE = Path(os.environ["PALPATE_DATA"]) / "Reference" / "shape" / "nodule_forces.csv"
SOLVED = 800                                                # s, for one solution on a busy machine
DEPTH = 0.8                                                 # mm, the largest depth in the table for this tool
FELT = re.compile(r"X pushed back with up to (\S+) N, Y with up to (\S+) N")
ROWS = re.compile(r"([\d.]+) mm, (\d) mm deep: ([+-][\d.]+) %")


def expected(radius, top):
    """Relative change of the force on a sphere of 1.6 mm, DEPTH deep, by a nodule that is ten times as hard."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        found = [float(row["dF_%"]) / 100 for row in csv.DictReader(file) if row["tool"] == "sphere1.6" and
                 (float(row["R_nodule"]), float(row["top_depth"]), float(row["E_ratio"]), float(row["delta"])) ==
                 (radius, top, 10.0, DEPTH)]
    return found[0]


class Phantom(SessionCase):
    @classmethod
    def setUpClass(cls):
        # The phantom is solved once for all tests, in the cache of the tests.
        with subprocess.Popen([PALPATE, "--scene", "phantom", "--no-pictures", "--output", CACHE.name],
                              env={**os.environ, "XDG_CACHE_HOME": CACHE.name}, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as program:
            out, cls.solved = program.communicate(timeout=SOLVED)
        assert program.returncode == 0, cls.solved
        assert "nine nodules" in out, out

    def press(self, x, y, *arguments):
        """Force on a press at x, y. The middle of the scene is 20 mm below the skin, which is at z = 0."""
        return peak_force(self.succeed("--scene", "phantom", "--site", f"{x},{y},20", *arguments))

    def test_a_nodule_changes_the_force_as_the_table_says(self):
        plain = self.press(-17.5, 23) # 8 mm from the centre of the nearest nodule, which has a radius of 1.5 mm
        change = self.press(-2, 0) / plain - 1
        self.assertAlmostEqual(expected(3.0, 2.0), 0.24, delta=0.005)
        self.assertAlmostEqual(change, expected(3.0, 2.0), delta=0.02)
        # The same press without the choice of the smallest form.
        exact = self.press(-2, 0, "--no-auto") / self.press(-17.5, 23, "--no-auto") - 1
        self.assertAlmostEqual(exact, expected(3.0, 2.0), delta=0.02)
        # Plain tissue gives the same force elsewhere, except for distant nodules and walls.
        self.assertAlmostEqual(self.press(-17.5, -23) / plain, 1.0, delta=0.02)

    def test_it_is_solved_once(self):
        self.assertIn("phantom solved for", self.solved)
        self.assertIn("taken from the cache", self.succeed("--scene", "phantom").stderr)

    def test_the_overview_shows_the_nodules(self):
        """Nine circles of black lines on the skin, of radii 1.5, 3 and 5 mm."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOImage import vtkPNGReader
        self.succeed("--scene", "phantom", pictures=PICTURES)
        reader = vtkPNGReader()
        reader.SetFileName(str(self.output / "overview.png"))
        reader.Update()
        image = reader.GetOutput()
        wide, high, _ = image.GetDimensions()
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(high, wide, -1)[..., :3].astype(int)
        skin = pixels[high // 3:, : 3 * wide // 4]  # without caption, dark front face and legends
        # Lines of two pixels, at least 5 pixels per mm in a picture of a block of 95 mm that fills half of 1280 pixels:
        # 2 pi (1.5 + 3 + 5) 3 mm is 179 mm, most of it at an angle.
        self.assertGreater((skin.max(axis=2) < 60).sum(), 179 * 5)

    def test_a_map_of_what_is_felt(self):
        result = run("--scene", "phantom", "--map", "--output", self.output)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater((self.output / "map.png").stat().st_size, 10000)
        rows = {(float(radius), float(top)): float(change) / 100 for radius, top, change in ROWS.findall(result.stdout)}
        self.assertEqual(len(rows), 9)
        for (radius, top), change in rows.items():
            # Tolerance relative to the force: 2 % for mixed cells if the top of the nodule is two
            # or more cells deep, 5 % for one cell. Over all depths, the change is largest at DEPTH,
            # except for the nodule of 1.5 mm at 1 mm, which slightly exceeds the values of the
            # table.
            tolerance = (0.05 if top == 1 else 0.02) * (1 + expected(radius, top))
            self.assertAlmostEqual(change, expected(radius, top), delta=tolerance, msg=(radius, top))
        self.assertEqual(len(re.findall("not felt", result.stdout)), 2)

    def observe(self, *arguments):
        """Answers each trial with the stronger alternative. Returns the output and the log."""
        settings = {**os.environ, "XDG_CACHE_HOME": CACHE.name}
        settings.pop("DISPLAY", None)                       # a trial draws nothing
        said = ""
        with subprocess.Popen([PALPATE, "--scene", "phantom", "--output", self.output, *arguments], env=settings,
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as program:
            for line in program.stdout:
                said += line
                felt = FELT.search(line)
                if felt:
                    program.stdin.write("1\n" if float(felt[1]) > float(felt[2]) else "2\n")
                    program.stdin.flush()
            error = program.stderr.read()
        self.assertEqual(program.returncode, 0, error)
        return said, (self.output / "trial.csv").read_text()

    def test_lump_or_none(self):
        said, log = self.observe("--trial", "lump,none", "--rounds", "2", "--seed", "3")
        self.assertIn("Under which one is the lump?", said)
        self.assertIn("right in 4 of 4, 100 %", said)
        lump, none = map(float, re.findall(r"# intensity \w: (\S+)", log))
        self.assertAlmostEqual(lump / none - 1, expected(3.0, 2.0), delta=0.02)  # at the first place, at DEPTH
        for line in said.split("100 %")[0].splitlines()[:3]:
            self.assertNotIn("none", line)

    def test_what_makes_no_sense_is_named(self):
        self.refuse("--scene", "phantom", "--voxel", "2", words=("--voxel", "phantom"))
        self.refuse("--scene", "phantom", "--layer", "3", words=("--layer", "phantom"))
        self.refuse("--scene", "phantom", "--strain", "neo-hooke", words=("--strain", "phantom"))
        self.refuse("--scene", "phantom", "--poisson", "0.5", words=("Poisson's Ratio", "0.5"))
        self.refuse("--scene", "cylinder", "--trial", "lump,none", words=("lump", "--scene phantom"))
        self.refuse("--scene", "phantom", "--trial", "lump,lump+none", words=("twice",))


if __name__ == "__main__":
    unittest.main()
