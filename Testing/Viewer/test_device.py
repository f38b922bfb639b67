# SPDX-License-Identifier: BSD-3-Clause
"""palpate --device, --list-devices, --record: the devices found, and the replay of a recorded hand."""
import re
import unittest

import bodies
from session import SessionCase, run
from test_trajectory import read


class Device(SessionCase):
    def test_a_recorded_hand_feels_the_same_again(self):
        record = self.folder / "record.csv"
        arguments = ("--site", "0,0,1", "--slide-to", "0.5,0,1")
        self.press(bodies.sphere(), "body.vtp", *arguments, "--record", record)
        first = (self.output / "trajectory.csv").read_bytes()
        self.assertEqual(record.read_bytes(), first)
        self.press(bodies.sphere(), "body.vtp", *arguments, "--device", f"replay:{record}")
        again = (self.output / "trajectory.csv").read_bytes()
        # The replay ends with the last recorded tick, one period earlier.
        self.assertEqual(first.splitlines()[:-1], again.splitlines())

    def test_a_record_names_tool_and_material_and_a_replay_compares_them(self):
        record = self.folder / "record.csv"
        self.press(bodies.sphere(), "body.vtp", "--friction", "0.3", "--record", record)
        lines = record.read_text().splitlines()
        self.assertEqual(lines[1:4], ["# body: body.vtp", "# tool: sphere:3", "# material: E = 0.1 MPa, nu = 0.45"])
        self.assertRegex(lines[4], r"^# model: half-space")
        self.assertEqual(lines[5], "# friction: mu = 0.3, elasto-plastic, 1 N/mm")
        same = self.press(bodies.sphere(), "body.vtp", "--friction", "0.3", "--device", f"replay:{record}")
        self.assertRegex(same.stdout, r"(?m)^  replay +recorded with body body.vtp, tool sphere:3, material E = 0.1 MPa")
        path = self.folder / "body.vtp"
        other = self.succeed(path, "--tool", "flat:2", "--young", "0.2", "--poisson", "0.45", "--friction", "0.3",
                             "--device", f"replay:{record}")
        self.assertRegex(other.stdout, r"(?m)^  replay +recorded with another setup: tool sphere:3 \(here flat:2\), "
                         r"material E = 0.1 MPa, nu = 0.45 \(here E = 0.2 MPa, nu = 0.45\)$")
        # A record without these lines, as of a former version, is replayed to the same numbers.
        old = self.folder / "old.csv"
        old.write_text("".join(line + "\n" for line in lines if not line.startswith("#")))
        told = self.press(bodies.sphere(), "body.vtp", "--friction", "0.3", "--device", f"replay:{old}")
        self.assertIn("the record names neither tool nor material", told.stdout)
        _, first = read(record)
        _, again = read(self.output / "trajectory.csv")
        self.assertEqual(list(first["ideal_force_N"][:-1]), list(again["ideal_force_N"]))

    def test_a_hand_of_a_script(self):
        script = self.folder / "hand.csv"
        script.write_text("time_s,tip_x_mm,tip_y_mm,tip_z_mm\n0,0.4,0.3,30\n1,0.4,0.3,24\n1.5,0.4,0.3,24\n")
        result = self.press(bodies.sphere(), "body.vtp", "--device", f"replay:{script}")
        self.assertIn(" 1500 ticks", result.stdout)
        _, table = read(self.output / "trajectory.csv")
        self.assertAlmostEqual(table["deflection_mm"].max(), 1.0, delta=0.05)  # facets of the sphere
        self.assertAlmostEqual(table["tip_z_mm"][500], 27.0, places=12)  # at half of the time

    def test_a_plant_yields_to_the_force(self):
        path = bodies.write(bodies.sphere(), self.folder / "body.vtp")
        depth = {}
        for device in ("simulated", "plant:stiffness=100", "plant:stiffness=1000,mass=0.05"):
            result = run(path, "--device", device, "--output", self.output)
            self.assertEqual(result.returncode, 0, result.stderr)
            depth[device] = read(self.output / "trajectory.csv")[1]["deflection_mm"].max()
        stiff, soft, firm = depth.values()
        self.assertLess(0, soft)
        self.assertLess(soft, firm)
        self.assertLess(firm, stiff)

    def test_list_devices_needs_no_display_and_no_body(self):
        result = run("--list-devices", environment={"DISPLAY": None})
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"\S")  # a list, or a message that there is no device
        self.assertNotIn("cannot be loaded", result.stdout)
        self.assertEqual(self.files(), {})

    def test_devices_that_are_not_there_are_named(self):
        path = bodies.write(bodies.sphere(), self.folder / "body.vtp")
        broken = self.folder / "broken.csv"
        broken.write_text("time_s,tip_x_mm,tip_y_mm,tip_z_mm\n0,0,0,soft\n")
        for device, word in (("mouse", "mouse"), ("", "hid:PATH"), ("hid:", "hid:PATH"),
                             ("hid:/dev/nowhere", "/dev/nowhere"), ("bridge:", "bridge:ADDRESS"),
                             ("bridge:nowhere", "nowhere"), ("replay:", "replay:FILE"),
                             ("replay:nowhere.csv", "nowhere.csv"),
                             ("plant:", "plant:SETTINGS"), ("plant:mass=0", "from 1e-06 to 1e+09 kg"),
                             (f"replay:{broken}", "broken.csv:2")):
            with self.subTest(device=device):
                self.refuse_after_drawing(path, device, word)

    def refuse_after_drawing(self, path, device, word):
        result = run(path, "--device", device, "--output", self.output)
        self.assertTrue(0 < result.returncode < 128, result.stderr)
        self.assertIn(word, result.stderr)
        self.assertNotIn("cannot be loaded", result.stderr)
        self.assertFalse([name for name in self.files() if re.search("png|csv", name)])


if __name__ == "__main__":
    unittest.main()
