# SPDX-License-Identifier: BSD-3-Clause
"""palpate --trial without a display: it asks blind questions, reads answers and writes a log to disk."""
import os
import re
import subprocess
import unittest

import bodies
from session import CACHE, PALPATE, TIME_OUT, SessionCase, run

FELT = re.compile(r"X pushed back with up to (\S+) N, Y with up to (\S+) N")


class Trial(SessionCase):
    def setUp(self):
        super().setUp()
        self.body = bodies.write(bodies.sphere(), self.folder / "body.vtp")

    def start(self, *arguments, young=0.1):
        # No X server: the trial draws nothing.
        settings = {**os.environ, "XDG_CACHE_HOME": CACHE.name}
        settings.pop("DISPLAY", None)
        return subprocess.Popen(
            [PALPATE, self.body, "--young", str(young), "--output", self.output, *map(str, arguments)],
            env=settings, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True)

    def ask(self, answers, *arguments):
        """Gives all answers immediately. Returns the output."""
        program = self.start(*arguments)
        out, err = program.communicate("".join(f"{answer}\n" for answer in answers), TIME_OUT)
        self.assertEqual(program.returncode, 0, err)
        return out

    def observe(self, answer, *arguments, **more):
        """Answers each trial by answer(x, y), where x and y are the printed forces on the simulated hand, N."""
        program = self.start(*arguments, **more)
        said = ""
        for line in program.stdout:
            said += line
            felt = FELT.search(line)
            if felt:
                program.stdin.write(f"{answer(float(felt[1]), float(felt[2]))}\n")
                program.stdin.flush()
        program.stdin.close()
        with program.stdout, program.stderr:
            self.assertEqual(program.wait(TIME_OUT), 0, program.stderr.read())
        return said

    def log(self, name=None):
        """The head of the log as a dictionary, and its rows as lists of words."""
        lines = (name or self.output / "trial.csv").read_text().splitlines()
        head = dict(re.match(r"# ([^:]*): (.*)", line).groups() for line in lines
                    if line.startswith("# ") and ":" in line)
        rows = [line.split(",") for line in lines if not line.startswith("#")]
        self.assertEqual(rows[0], "trial,x,y,answer,chosen,correct,seconds,switches".split(","))
        return head, rows[1:]

    def test_an_observer_who_feels_the_force_is_always_right(self):
        said = self.observe(lambda x, y: 1 if x > y else 2, "--trial", "sphere:3,flat:3,cone:60",
                            "--rounds", 2, "--seed", 5, "--no-curvature")
        head, rows = self.log()
        self.assertEqual(len(rows), 2 * 3 * 2)
        self.assertEqual({row[5] for row in rows}, {"1"})
        self.assertEqual([head[f"alternative {letter}"] for letter in "ABC"],
                         ["sphere:3", "flat:3", "cone:60"])
        # A flat punch of 3 mm has 2 E* a d at 1 mm. The tolerance of some per cent is for the
        # facets and the pole of the sphere.
        self.assertAlmostEqual(float(head["intensity B"]), 2 * 0.1 / (1 - 0.45 ** 2) * 3,
                               delta=0.05 * 0.75)
        self.assertEqual(len(re.findall("right in 4 of 4, 100 %", said)), 3)
        # Every pair in both orders, twice.
        self.assertEqual(sorted((row[1], row[2]) for row in rows),
                         sorted(2 * [(x, y) for x in "ABC" for y in "ABC" if x != y]))
        self.assertEqual({row[7] for row in rows}, {"1"})

    def test_nothing_tells_which_is_which(self):
        program = self.start("--trial", "sphere:3,flat:3", "--rounds", 1)
        said = ""
        for _ in range(2):
            while not said.endswith("2: Y\n"):
                said += program.stdout.readline()
            program.stdin.write("1\n")
            program.stdin.flush()
            for word in ("sphere", "flat", "Response"):
                self.assertNotIn(word, said)
            said += program.stdout.readline()
        program.communicate(timeout=TIME_OUT)
        self.assertEqual(program.returncode, 0)

    def test_the_seed_is_the_order_and_the_order_changes_without(self):
        orders = []
        for number, seed in enumerate((7, 7, 8)):
            log = self.folder / f"log{number}.csv"
            self.ask("1" * 12, "--trial", "sphere:3,flat:3,cone:60", "--rounds", 2, "--seed", seed,
                     "--log", log)  # two rounds of 6! orders each
            head, rows = self.log(log)
            self.assertEqual(head["seed"], str(seed))
            orders.append([row[1:3] for row in rows])
        self.assertEqual(orders[0], orders[1])
        self.assertNotEqual(orders[0], orders[2])
        seeds = set()
        for number in (3, 4):
            log = self.folder / f"log{number}.csv"
            self.ask("", "--trial", "sphere:3,flat:3", "--log", log)
            seeds.add(self.log(log)[0]["seed"])
        self.assertEqual(len(seeds), 2)  # the seeds are equal with a probability of 2^-32

    def test_other_lines_are_no_answers(self):
        said = self.ask(["3", "", "x", "2", " 1", "1"], "--trial", "sphere:3,flat:3", "--rounds", 1)
        self.assertEqual(said.count("is not an answer"), 4)
        self.assertEqual([row[3] for row in self.log()[1]], ["Y", "X"])

    def test_what_was_answered_before_the_end_is_kept(self):
        said = self.ask("121", "--trial", "sphere:3,flat:3", "--rounds", 5)
        self.assertIn("ended before trial 4 of 10", said)
        self.assertEqual(len(self.log()[1]), 3)
        # A log of answers is never overwritten.
        before = (self.output / "trial.csv").read_bytes()
        result = run(self.body, "--trial", "sphere:3,flat:3", "--output", self.output)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("trial.csv", result.stderr)
        self.assertEqual((self.output / "trial.csv").read_bytes(), before)

    def test_each_answer_is_in_the_file_at_once(self):
        program = self.start("--trial", "sphere:3,flat:3", "--rounds", 1)
        for line in program.stdout:
            if line.startswith("1: X"):
                program.stdin.write("1\n")
                program.stdin.flush()
                break
        while "trial 2" not in program.stdout.readline():
            pass
        self.assertEqual(len(self.log()[1]), 1)
        program.kill()  # like a power failure
        program.communicate()
        self.assertEqual(len(self.log()[1]), 1)

    def test_materials_and_friction_are_alternatives_too(self):
        # Twice the modulus gives twice the force. The limit of the device scales both forces by one
        # factor, so the ratio is unchanged.
        self.observe(lambda x, y: 1 if x > y else 2, "--tool", "sphere:3",
                     "--trial", "young=0.1,young=0.2", "--rounds", 1)
        head, rows = self.log()
        self.assertEqual({row[5] for row in rows}, {"1"})
        self.assertAlmostEqual(float(head["intensity B"]) / float(head["intensity A"]), 2.0, places=5)
        # Friction: both alternatives are equal in the property of the question, so no answer is
        # correct.
        log = self.folder / "friction.csv"
        ratios = []

        def choose(x, y):
            ratios.append(max(x, y) / min(x, y))
            return 1
        self.observe(choose, "--slide-to", "0.5,0,1", "--trial", "friction=0,friction=0.5",
                     "--rounds", 1, "--log", log)
        self.assertEqual({row[5] for row in self.log(log)[1]}, {""})
        # During sliding the total force is sqrt(1 + 0.5^2) times the normal force. Its maximum is
        # at the deepest place of a facet, within a few per cent.
        for ratio in ratios:
            self.assertAlmostEqual(ratio, 1.25 ** 0.5, delta=0.03)
        # A layer is compared with no layer, with a custom question.
        log = self.folder / "layer.csv"
        self.ask("11", "--trial", "sphere:3+layer=2,sphere:3+layer=none", "--rounds", 1, "--log", log,
                 "--question", "Which one is bonier?")
        head, rows = self.log(log)
        self.assertEqual(head["question"], "Which one is bonier?")
        self.assertEqual({row[5] for row in rows}, {""})
        self.assertGreater(float(head["intensity A"]), 1.5 * float(head["intensity B"]))
        # Two equal layers are compared with one layer.
        log = self.folder / "layers.csv"
        self.ask("11", "--trial", "sphere:3+layers=0.5:0.1:0.45,1.5:0.1:0.45,sphere:3+young=0.1+layer=2", "--rounds", 1,
                 "--log", log, "--no-curvature")
        head, _ = self.log(log)
        self.assertAlmostEqual(float(head["intensity A"]) / float(head["intensity B"]), 1.0, delta=1e-3)

    def test_ratios_survive_a_device_too_weak(self):
        # Stiff rubber has 400 N/mm, far above the 10 N of the simulated device. If each force were
        # clipped, both alternatives would have 10 N.
        forces = []

        def choose(x, y):
            forces.append(sorted((x, y)))
            return 1 if x > y else 2
        self.observe(choose, "--trial", "sphere:6.35,sphere:1.6", "--rounds", 1, young=50)
        head, _ = self.log()
        wanted = float(head["intensity A"]) / float(head["intensity B"])
        self.assertLess(float(head["force factor"]), 0.1)
        for weaker, stronger in forces:
            self.assertLess(stronger, 10.0)
            self.assertAlmostEqual(stronger / weaker, wanted, delta=0.03 * wanted)  # the largest force over the path

    def test_what_makes_no_sense_is_named(self):
        for arguments, word in (
                (("sphere:3",), "2 to 26"),
                (("sphere:3,spere:2",), "spere"),
                (("sphere:3,sphere:3",), "twice"),
                (("sphere:3,friction=-1",), "friction=-1"),
                (("sphere:3,sphere:3+young=0",), "young=0"),
                (("sphere:3,sphere:3+poisson=0.6",), "poisson=0.6"),
                (("sphere:3,sphere:3+colour=red",), "colour=red"),
                (("sphere:3,sphere:3+layer=-1",), "layer=-1"),
                (("sphere:3,sphere:3+layers=1:1",), "layer 1: '1:1' is not MM:MPA:NU"),
                (("sphere:3,sphere:3+layers=scan",), "scan can only be given by --layers"),
                (("sphere:3,sphere:3+young=1+layers=1:1:0.4",), "its own young and poisson"),
                (("sphere:3,friction=0.2",), "either all"),
                (("sphere:3,sphere:2+flat:1",), "two tools"),
                (("sphere:3,flat:2", "--tool", "cone:30"), "--tool"),
                (("sphere:3,flat:2", "--rounds", "0"), "--rounds"),
                (("sphere:3,flat:2", "--seed", "-1"), "--seed")):
            with self.subTest(arguments=arguments):
                self.refuse(self.body, "--trial", *arguments, words=(word,))
        self.refuse(self.body, "--rounds", "3", words=("--trial",))
        # Commas within tools do not separate tools.
        log = self.folder / "commas.csv"
        self.ask("11", "--trial", "blunted:1,30,truncated:1,45", "--rounds", 1, "--log", log)
        self.assertEqual(self.log(log)[0]["alternative A"], "blunted:1,30")


if __name__ == "__main__":
    unittest.main()
