# SPDX-License-Identifier: BSD-3-Clause
"""The live window under real mouse and key events: press, slide, deeper, another tool, quit.

    test_live_window.py PALPATE_EXECUTABLE FOLDER [-k WORD]     (the tests with the word in their names)

Needs a separate display (it has only one pointer) and xdotool; exit code 77 without xdotool. The test
waits for the output of the program, and gives its window a limited time to follow the mouse.
"""
import csv
import math
import os
import re
import shutil
import subprocess
import sys
import time
import unittest

PROGRAM, FOLDER = sys.argv[1], sys.argv[2]
FOLLOW = 3.0  # s, time for a few frames, software-rendered on a busy machine


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True, timeout=300)


class LiveWindow(unittest.TestCase):
    def setUp(self):
        os.makedirs(FOLDER, exist_ok=True)
        self.open("live")

    def open(self, name, *arguments, ready="tool: ", scene=("--scene", "cylinder")):
        self.picture = os.path.join(FOLDER, name + ".png")
        self.log = os.path.join(FOLDER, name + ".txt")
        with open(self.log, "w", encoding="utf-8") as log:
            self.program = subprocess.Popen(
                [PROGRAM, "--window", *scene, "--screenshot", self.picture, *arguments],
                stdout=log, stderr=subprocess.STDOUT)
        while ready not in self.said():  # until the window is open and the session runs
            self.assertIsNone(self.program.poll(), "the program ended early: " + self.said())
            time.sleep(0.1)
        time.sleep(FOLLOW)

    def tearDown(self):
        self.program.kill()
        self.program.wait()
        xdotool("mouseup", 1)  # a button that is already down cannot be pressed in the next test

    def said(self):
        with open(self.log, encoding="utf-8") as log:
            return log.read()

    def quit(self):
        xdotool("key", "q")
        self.assertEqual(self.program.wait(timeout=300), 0, self.said())
        return self.said()

    def strongest_force(self, said):
        return float(re.search(r"strongest force (\S+) N", said).group(1))

    def test_pressing_sliding_and_switching_tools(self):
        xdotool("mousemove", 600, 330)
        xdotool("mousedown", 1)
        time.sleep(FOLLOW)
        xdotool("mousemove", 640, 340)
        time.sleep(FOLLOW)
        xdotool("key", "2")
        time.sleep(FOLLOW)
        xdotool("click", 4, "click", 4, "click", 4, "click", 4, "click", 4)  # 0.1 mm deeper each
        time.sleep(FOLLOW)
        said = self.quit()
        self.assertIn("tool: flat, radius 1.6 mm", said)
        self.assertIn("tool: sphere, radius 6.35 mm", said)
        ticks = int(re.search(r"(\d+) ticks", said).group(1))
        self.assertGreater(ticks, 1000)
        # Hertz: 4/3 E* sqrt(R) d^1.5 at d = 1.5 mm, less 2 % for the exact sphere. The hand presses
        # along interpolated normals of facets, so the depth is not exactly 1.5 mm.
        hertz = 4.0 / 3.0 * 3.45 * math.sqrt(6.35) * 1.5 ** 1.5
        self.assertAlmostEqual(self.strongest_force(said), 0.98 * hertz, delta=0.06 * hertz)
        self.assertTrue(self.shows_force_and_dent(), "see " + self.picture)
        # Tools were changed during contact without a restart, so one count contains all ticks.
        self.assertRegex(said, r"\b1 changes? of scene")
        for word in ("device: ", "wake-up", "worst", "0 disconnections"):
            self.assertIn(word, said)

    def test_the_panel_changes_what_is_felt_and_how_it_is_shown(self):
        """Sliders and buttons under the real pointer. Their positions are those in a window of 1280 x 960."""
        self.quit()
        folder = os.path.join(FOLDER, "panel-output")
        shutil.rmtree(folder, ignore_errors=True)
        self.open("panel", "--output", folder)
        xdotool("mousemove", 600, 330)
        time.sleep(FOLLOW)
        xdotool("click", "--repeat", 10, "--delay", 50, 4)  # the wheel alone presses, by 0.1 mm per notch
        time.sleep(FOLLOW)
        for key in ("k", "question", "p", "question", "p", "k"):
            xdotool("key", key)
            time.sleep(FOLLOW)
        with open(os.path.join(folder, "palpate-1.csv"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        rows = [line for line in lines if not line.startswith("#")]
        self.assertIn("# tool: flat:1.6", lines)
        self.assertIn("# material: E = 2.5875 MPa, nu = 0.5", lines)
        self.assertGreater(len(rows), 1000)
        self.assertAlmostEqual(float(rows[-1].split(",")[7]), 1.0, delta=0.05)
        helped, bare = (self.pixels(os.path.join(folder, f"palpate-{i}.png")) for i in (1, 2))
        self.assertGreater((abs(helped - bare).sum(axis=2) > 60).mean(), 0.05) # the key ? shows and hides this sheet
        xdotool("mousemove", 1228, 260, "mousedown", 1)  # Young's modulus, from 2.59 MPa to the end: 10 MPa
        xdotool("mousemove", 1250, 262)
        xdotool("mousemove", 1270, 264, "mouseup", 1)
        # First the frames of the slider are rendered in software. Then the responses are computed
        # in the background, which takes 2 to 3 s if nothing else runs.
        time.sleep(6 * FOLLOW)
        # Flat punch: 2 a E* d, 1 mm deep; normals are interpolated over facets, as above.
        flat = 2.0 * 1.6 * 10.0 / (1.0 - 0.25)
        self.assertAlmostEqual(self.strongest_force(self.quit()), flat, delta=0.06 * flat)

    def test_a_line_tells_of_the_wheel_until_it_has_pressed(self):
        self.quit()
        folder = os.path.join(FOLDER, "hint-output")
        shutil.rmtree(folder, ignore_errors=True)
        self.open("hint", "--output", folder)
        xdotool("mousemove", 600, 330)
        time.sleep(FOLLOW)
        for events in ((), ("mousedown", 1, "mouseup", 1), ("click", 5), ("click", 4)):
            if events:
                xdotool(*events)
                time.sleep(FOLLOW)
            xdotool("key", "p")
            time.sleep(FOLLOW)
        self.quit()
        told = [self.hint(os.path.join(folder, f"palpate-{i}.png")) for i in (1, 2, 3, 4)]
        self.assertGreater(told[0], 300, told)  # pixels of the strokes of about 45 letters
        self.assertEqual(told, [told[0], told[0], told[0], 0])

    def test_a_recorded_session_can_be_replayed(self):
        self.quit()
        record = os.path.join(FOLDER, "record.csv")
        self.open("record", "--record", record)
        xdotool("mousemove", 600, 330)
        xdotool("mousedown", 1)
        time.sleep(FOLLOW)
        said = self.quit()
        with open(record, encoding="utf-8") as file:
            rows = [line for line in file.read().splitlines() if not line.startswith("#")]
        ticks = int(re.search(r"(\d+) ticks", said).group(1))
        self.assertEqual(len(rows), ticks + 1)  # all ticks and the row of column names
        self.open("replay", "--device", "replay:" + record)
        time.sleep(float(rows[-1].split(",")[0]))
        again = self.strongest_force(self.quit())
        self.assertEqual(self.hint(self.picture), 0)  # a device with its own hand needs no hint
        felt = max(float(row.split(",")[12]) for row in rows[1:])
        self.assertAlmostEqual(again, felt, delta=1e-3 * felt)  # printed with four digits

    def test_a_blind_trial_shows_neither_tool_nor_force(self):
        self.quit()
        log = os.path.join(FOLDER, "trial.csv")
        if os.path.exists(log):
            os.remove(log)
        self.open("trial", "--trial", "flat:1.6,sphere:6.35", "--rounds", "2", "--log", log,
                  ready="window open")
        xdotool("mousemove", 600, 330)
        xdotool("mousedown", 1)
        time.sleep(FOLLOW)
        for key in ("space", "1", "2", "space", "space", "2"):
            xdotool("key", key)
            time.sleep(0.5)
        said = self.quit()  # before the fourth trial
        self.assertIn("gives no force to the hand", said)
        self.assertNotIn("tool: ", said)
        self.assertIn("ended before trial 4 of 4", said)
        with open(log, encoding="utf-8") as file:
            rows = [row.split(",") for row in file.read().splitlines() if row[0].isdigit()]
        self.assertEqual([row[3] for row in rows], ["X", "Y", "Y"])
        self.assertEqual([row[7] for row in rows], ["1", "0", "2"])
        self.assertFalse(self.shows_force_and_dent(), "see " + self.picture)

    def test_one_mouse_presses_both_bodies_of_a_comparison(self):
        self.quit()
        for name, x in (("compare-left", 230), ("compare-right", 870)):
            self.open(name, scene=("--compare",))
            xdotool("mousemove", x, 275)
            time.sleep(FOLLOW)
            xdotool("mousedown", 1)
            time.sleep(FOLLOW)
            xdotool("mouseup", 1)
            said = self.quit()
            felt = re.search(r"strongest force: strip (\S+) N, block (\S+) N", said)
            # The force at 1 mm in the summary is for the vertex next to the contact. Neighbouring
            # vertices differ by 1 %.
            told = re.findall(r"sphere:6.35\s+(\S+) N", said)
            for one, other in zip(felt.groups(), told):
                self.assertAlmostEqual(float(one), float(other), delta=0.03 * float(other), msg=said)
            self.assertTrue(self.shows_force_and_dent(), "see " + self.picture)

    def test_hovering_touches_nothing(self):
        xdotool("mousemove", 600, 330)
        time.sleep(FOLLOW)
        xdotool("mousemove", 640, 340)
        time.sleep(FOLLOW)
        self.assertEqual(self.strongest_force(self.quit()), 0.0)

    def test_a_pointer_that_jumps_presses_nothing_and_presses_no_deeper_than_set(self):
        self.quit()
        record = os.path.join(FOLDER, "jumps.csv")
        # The rubber is stiff: the force is far above the 10 N to which a device would be limited.
        self.open("jumps", "--young", "50", "--record", record)
        for x, y in ((420, 330), (760, 330), (450, 360), (780, 300), (600, 330)):
            xdotool("mousemove", x, y)
            time.sleep(0.3)
        time.sleep(FOLLOW)
        xdotool("click", "--repeat", 8, "--delay", 50, 4)  # 0.8 mm
        time.sleep(FOLLOW)
        xdotool("mousedown", 1)
        for x, y in ((460, 330), (740, 340), (480, 320), (600, 330)):
            xdotool("mousemove", x, y)
            time.sleep(0.3)
        time.sleep(FOLLOW)
        xdotool("mouseup", 1)
        self.quit()
        with open(record, encoding="utf-8") as file:
            ticks = [{name: float(number) for name, number in row.items()} for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        depths = [tick["deflection_mm"] for tick in ticks]
        first = next(index for index, depth in enumerate(depths) if depth > 0)
        travelled = {round(tick["tip_x_mm"] / 5) for tick in ticks[:first]} | {
            round(tick["tip_y_mm"] / 5) for tick in ticks[:first]}
        self.assertGreater(len(travelled), 4)  # the tool has moved over the body without contact
        self.assertLess(max(depths), 0.8 + 1e-4)  # the corners of the facets are stored as floats
        self.assertAlmostEqual(depths[-1], 0.8, delta=0.04)  # normals are interpolated over facets, as above
        self.assertGreater(max(tick["ideal_force_N"] for tick in ticks), 50.0)

    def test_one_finger_lifts_the_force_off_the_other(self):
        self.quit()
        record = os.path.join(FOLDER, "hands.csv")
        self.open("hands", "--hand", "simulated", "--record", record)
        xdotool("mousemove", 560, 330)
        time.sleep(FOLLOW)
        xdotool("click", "--repeat", 10, "--delay", 50, 4)  # 1 mm deep; the flat end stays at this depth
        time.sleep(FOLLOW)
        xdotool("key", "n")
        xdotool("mousemove", 600, 330)
        time.sleep(FOLLOW)
        xdotool("click", "--repeat", 10, "--delay", 50, 4)
        time.sleep(FOLLOW)
        said = self.quit()
        with open(record, encoding="utf-8") as file:
            ticks = [{name: float(number) for name, number in row.items()} for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        alone, together = max(ticks, key=lambda tick: tick["ideal_force_N"]), ticks[-1]
        # 2 a E* times the remaining depth; normals are interpolated over facets, as above
        for tick in (alone, together):
            flat = 2.0 * 1.6 * 3.45 * tick["deflection_mm"]
            self.assertAlmostEqual(tick["ideal_force_N"], flat, delta=0.06 * flat)
        # The tip has not moved, and the other tool has lowered the surface under it.
        for axis in "xyz":
            self.assertAlmostEqual(alone[f"tip_{axis}_mm"], together[f"tip_{axis}_mm"], delta=1e-3)
        self.assertAlmostEqual(alone["deflection_mm"], 1.0, delta=0.05)
        print("alone", alone["ideal_force_N"], "N, beside another", together["ideal_force_N"], "N")
        self.assertLess(together["ideal_force_N"], 0.95 * alone["ideal_force_N"])
        other = float(re.search(r"hand 2: strongest force (\S+) N", said).group(1))
        self.assertAlmostEqual(other, together["ideal_force_N"], delta=0.1 * other)
        self.assertTrue(self.shows_force_and_dent(), "see " + self.picture)

    def test_leaning_a_flat_end_by_five_degrees_halves_its_force(self):
        self.quit()
        record = os.path.join(FOLDER, "leaning.csv")
        self.open("leaning", "--tool", "flat:1.6", "--tilt", "15", "--record", record)
        xdotool("mousemove", 560, 330)
        time.sleep(FOLLOW)
        xdotool("click", "--repeat", 3, "--delay", 50, 4)  # 0.3 mm
        time.sleep(FOLLOW)
        # 2.5 degrees each; the tool's edge is deeper by a sin 5 degrees
        xdotool("key", "bracketright", "key", "bracketright")
        time.sleep(FOLLOW)
        xdotool("click", "--repeat", 2, "--delay", 1000, 5)  # upward, until the depth of the edge is below 0.3 mm
        time.sleep(FOLLOW)
        said = self.quit()
        with open(record, encoding="utf-8") as file:
            ticks = [{name: float(number) for name, number in row.items()} for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        axes = [tick["axis_x"] ** 2 + tick["axis_y"] ** 2 + tick["axis_z"] ** 2 for tick in ticks]
        upright = [tick for tick, axis in zip(ticks, axes) if axis == 0 and tick["ideal_force_N"] > 0][-1]
        deepest = max(index for index, tick in enumerate(ticks) if tick["deflection_mm"] > 0.335)
        leaning = ticks[deepest:]  # the tool was tilted long before; now it moves up
        same = min(leaning, key=lambda tick: abs(tick["deflection_mm"] - upright["deflection_mm"]))
        print("upright", upright["ideal_force_N"], "N at", upright["deflection_mm"], "mm, leaning",
              same["ideal_force_N"], "N at", same["deflection_mm"], "mm")
        self.assertAlmostEqual(upright["deflection_mm"], 0.3, delta=0.015)
        self.assertAlmostEqual(same["deflection_mm"], upright["deflection_mm"], delta=0.005)
        # The force is 0.555 of the upright force on a half-space, 0.1875 radii deep
        # (Data/Reference/tilt). The body is a cylinder. The tilt is relative to its interpolated
        # normals, which differ by a degree from facet to facet, and the curve is steep there.
        self.assertAlmostEqual(same["ideal_force_N"] / upright["ideal_force_N"], 0.555, delta=0.08, msg=said)
        torque = math.hypot(*(same[f"torque_{axis}_Nmm"] for axis in "xyz"))
        self.assertGreater(torque, 0.1 * same["ideal_force_N"])
        self.assertTrue(self.shows_force_and_dent(), "see " + self.picture)

    def test_dragging_beside_the_body_orbits(self):
        self.quit()
        before = self.pixels()
        self.open("orbit")
        xdotool("mousemove", 80, 150)
        xdotool("mousedown", 1)
        xdotool("mousemove", 200, 220)
        time.sleep(FOLLOW)
        xdotool("mouseup", 1)
        self.assertEqual(self.strongest_force(self.quit()), 0.0)
        moved = (abs(self.pixels() - before).sum(axis=2) > 60).mean()
        print("share of the picture that changed:", moved)
        self.assertGreater(moved, 0.05)

    def pixels(self, picture=None):
        """The last picture, or the given picture, as rows of (red, green, blue), without the legend."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOImage import vtkPNGReader
        reader = vtkPNGReader()
        reader.SetFileName(picture or self.picture)
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
        width = reader.GetOutput().GetDimensions()[0]
        return pixels.reshape(-1, width, pixels.shape[1])[:, : int(0.8 * width), :3]

    def hint(self, picture):
        """Number of pixels of the hint's blue letters in the upper left corner."""
        corner = self.pixels(picture)[-32:, :520]
        return int(((corner[..., 0] < 60) & (corner[..., 2] > 120)).sum())

    def shows_force_and_dent(self):
        """The picture shows the red force arrow and the violet dent."""
        pixels = self.pixels()
        red, green, blue = pixels[..., 0], pixels[..., 1], pixels[..., 2]
        force = ((red > 150) & (green < 80) & (blue < 60)).sum()
        dent = ((red - green > 40) & (blue - green > 15)).sum()
        print("pixels of force:", force, "of dent:", dent)
        return force > 50 and dent > 20


if __name__ == "__main__":
    if not shutil.which("xdotool"):
        print("xdotool is not installed: no real mouse events")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
