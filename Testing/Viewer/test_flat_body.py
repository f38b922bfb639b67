# SPDX-License-Identifier: BSD-3-Clause
"""--export: a flat body file, which the viewer reads back without change; damaged files are refused."""
import unittest

import bodies
from session import SessionCase, peak_force, vertices


class FlatBody(SessionCase):
    def export(self):
        path = self.folder / "body.palpate"
        first = self.press(bodies.sphere(), "body.stl", "--export", path)
        return path, first

    def numbers(self):
        """The lines of the trajectory without those that name body and material, which another file may not know."""
        text = (self.output / "trajectory.csv").read_text(encoding="utf-8")
        return [line for line in text.splitlines() if not line.startswith("#")]

    def test_the_exported_body_is_felt_as_it_was(self):
        path, first = self.export()
        trajectory = self.numbers()
        again = self.succeed(path)
        self.assertEqual(vertices(again), vertices(first))
        self.assertEqual(peak_force(again), peak_force(first))
        self.assertIn("sphere:3", again.stdout)
        self.assertIn("as stored in the file", again.stdout)
        self.assertEqual(self.numbers(), trajectory)

    def test_another_tool_or_material_replaces_the_stored_response(self):
        path, first = self.export()
        stiffer = self.succeed(path, "--tool", "sphere:3", "--young", "0.2", "--poisson", "0.45")
        # F is proportional to E; the summary prints four digits.
        self.assertAlmostEqual(
            peak_force(stiffer), 2.0 * peak_force(first), delta=2e-3 * peak_force(first))

    def test_what_is_not_whole_and_ours_is_refused(self):
        path, _ = self.export()
        whole = path.read_bytes()
        for content, word in ((whole[: len(whole) // 2], "truncated"), (b"x" * 4096, "not a Palpate"),
                              (whole[:8] + b"\x63" + whole[9:], "newer"), (b"", "too short"),
                              (whole[:-1] + bytes([whole[-1] ^ 1]), "checksum")):
            path.write_bytes(content)
            self.refuse(path, words=(path.name, word))


if __name__ == "__main__":
    unittest.main()
