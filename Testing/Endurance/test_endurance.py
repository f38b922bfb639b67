# SPDX-License-Identifier: BSD-3-Clause
"""A part that fails, crashes or is missing is never reported as passed."""
import json
import pathlib
import sys
import tempfile
import unittest

import endurance
import fuzz

WRITE = "import json, sys; json.dump({}, open(sys.argv[-1], 'w')); sys.exit({})"
GOOD = {"part": "x", "passed": True, "figures": {"ticks": 12345678, "worst": 0.25, "left out": ["one", "another"],
                                                 "A": {"runs": 3}, "B": {"peak": 7}}}


def part(written, code=0, name="x"):
    return endurance.Part(name, "what it does", [sys.executable, "-c", WRITE.format(written, code)])


class Endurance(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def run_part(self, one):
        one.run(self.folder)
        return one.result(self.folder)

    def test_a_part_passes_only_if_file_and_exit_code_say_so(self):
        self.assertTrue(self.run_part(part(GOOD))["passed"])
        self.assertEqual(self.run_part(part(GOOD, code=3))["fault"], "exit code 3")
        self.assertFalse(self.run_part(part(GOOD, code=3))["passed"])
        self.assertFalse(self.run_part(part({"passed": False, "figures": {}}))["passed"])
        self.assertFalse(self.run_part(part({"passed": "yes", "figures": {}}))["passed"])
        self.assertIn("figures", self.run_part(part({"passed": True}))["fault"])

    def test_the_result_of_an_earlier_run_does_not_count(self):
        self.assertTrue(self.run_part(part(GOOD))["passed"])
        silent = self.run_part(endurance.Part("x", "", [sys.executable, "-c", "print('nothing')"]))
        self.assertFalse(silent["passed"])
        self.assertIn("no result", silent["fault"])

    def test_a_program_that_is_not_there_is_named(self):
        missing = self.run_part(endurance.Part("x", "", [self.folder / "palpateNothing"]))
        self.assertFalse(missing["passed"])
        self.assertIn("palpateNothing", missing["fault"])

    def test_all_parts_are_run_and_reported_even_if_one_fails(self):
        bad, soak, good = part(GOOD, 1, "bad"), part(GOOD, name="soak"), part(GOOD, name="good")
        endurance.run_parts([bad], soak, [good], self.folder)
        report = endurance.write_report([soak, bad, good, part(GOOD, name="later")], self.folder, [("memory", "4 GB")])
        self.assertIn("| later | NO: not run |", report)
        self.assertIn("| bad | NO: exit code 1 |", report)
        self.assertIn("| good | yes |", report)
        self.assertIn("- memory: 4 GB", report)
        self.assertIn("- ticks: 12 345 678", report)
        self.assertIn("- left out:\n  - one\n  - another\n", report)
        self.assertIn("| | runs | peak |", report)
        self.assertIn("| A | 3 |  |", report)

    def test_a_fuzzer_that_is_run_again_takes_the_place_of_its_finding(self):
        sound, broken = {"complete": True, "finding": "none"}, {"complete": False, "finding": "a force pushes out"}
        first = {**fuzz.merge({}, {"A": broken, "B": sound}), "date": "then"}
        self.assertFalse(first["passed"])
        self.assertEqual(fuzz.merge(first, {"A": sound}),
                         {"part": "fuzzing", "passed": True, "date": "then", "fault": "",
                          "figures": {"A": sound, "B": sound}})
        self.assertFalse(fuzz.merge(first, {"B": sound})["passed"])

    def test_what_fuzzers_left_alone_can_be_reported(self):
        fuzzing = part(GOOD, name="fuzzing")
        broken = {"complete": False, "finding": "a force pushes out"}
        fuzzing.file(self.folder).write_text(json.dumps(fuzz.merge({}, {"A": broken})), encoding="utf-8")
        report = endurance.write_report([fuzzing], self.folder, [])
        self.assertIn("| fuzzing | NO: see finding |", report)
        self.assertIn("a force pushes out", report)

    def test_parts_are_chosen_all_some_or_none(self):
        self.assertEqual(len(endurance.parse([])[-1]), 5)
        self.assertEqual(endurance.parse(["--only", "soak", "limits"])[-1], {"soak", "limits"})
        self.assertEqual(endurance.parse(["--only"])[-1], set())

    def test_a_part_nobody_knows_is_refused(self):
        with self.assertRaises(SystemExit) as refused:
            endurance.parse(["--only", "nonsense"])
        self.assertEqual(refused.exception.code, 2)

    def test_the_machine_is_named(self):
        for name, value in endurance.machine():
            self.assertTrue(name and value)


if __name__ == "__main__":
    unittest.main()
