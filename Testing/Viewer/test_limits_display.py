# SPDX-License-Identifier: BSD-3-Clause
"""If the display disappears while the hand is pressed against the body, the force on the hand is released
first, and the process ends with a message and exit code 1. The recording can be played again."""
import contextlib
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import bodies
from bridge_peer import BridgePeer
from own_display import OwnDisplay
from session import CACHE, PALPATE, TIME_OUT, SessionCase, run

LOWEST = 0.025  # m below the initial position, which is 10 mm above the body
GONE = "the X server of DISPLAY='{}' is gone"


@unittest.skipUnless(OwnDisplay.is_there(), "Xvfb is not installed")
class DisplayLoss(SessionCase):
    def setUp(self):
        super().setUp()
        self.body = bodies.write(bodies.sphere(), self.folder / "body.vtp")
        self.display = OwnDisplay()
        self.addCleanup(self.display.kill)

    def open(self, *arguments):
        """Starts the program in a window. Returns when the window is open."""
        settings = {**os.environ, "XDG_CACHE_HOME": CACHE.name, "DISPLAY": self.display.name}
        self.log = self.folder / "said.txt"
        with open(self.log, "w", encoding="utf-8") as log:
            program = subprocess.Popen(
                [PALPATE, self.body, "--young", "0.1", "--poisson", "0.45", "--window",
                 "--output", self.output, *map(str, arguments)],
                env=settings, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT)
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        return program

    def said(self):
        return self.log.read_text(errors="replace")

    def wait_until(self, condition, program, what):
        end = time.monotonic() + TIME_OUT
        while not condition():
            self.assertIsNone(program.poll(), f"ended before {what}: {self.said()}")
            self.assertLess(time.monotonic(), end, f"not {what}: {self.said()}")
            time.sleep(0.01)

    def lose_display(self, program):
        self.display.kill()
        self.assertEqual(program.wait(timeout=TIME_OUT), 1, self.said())
        self.assertIn(GONE.format(self.display.name), self.said())

    def socket_path(self):
        """A short path, because the length of a socket's path is limited."""
        folder = tempfile.mkdtemp(prefix="palpate")
        self.addCleanup(shutil.rmtree, folder)
        return Path(folder) / "device"

    def press(self, program, peer):
        """Moves the hand until the body exerts a force. After a late reading there is no force until the hand has been
        outside; then the hand lifts off and presses again."""
        begin = time.monotonic()

        def pushes():
            if peer.is_pushing():
                return True
            # The device's z axis points out of the screen, which is turned by 25 to 75 degrees from
            # the normal.
            part = (time.monotonic() - begin) % 2.0 / 1.5
            peer.position = (0.0, 0.0, -LOWEST * part if part < 1.0 else 0.0)
            return False

        self.wait_until(pushes, program, "the body pushes back")

    @contextlib.contextmanager
    def pressed(self, record):
        """The program in its window with a hand that presses. The force on the hand must be zero at the end. Everything
        is recorded."""
        path = self.socket_path()
        with BridgePeer(path) as peer:
            program = self.open("--tool", "sphere:3", "--site", "1,0,0", "--record", record,
                                "--device", f"bridge:unix:{path}")
            self.wait_until(lambda: "tool: " in self.said(), program, "the window is open")
            self.press(program, peer)
            yield program, peer
            time.sleep(0.1)  # time for the datagrams that are still in the socket
        self.assertEqual(peer.forces[-1][2:], (0.0, 0.0, 0.0), "the last force")

    def test_the_hand_is_let_go_of_and_the_record_is_saved(self):
        record = self.folder / "record.csv"
        with self.pressed(record) as (program, peer):
            begin = len(peer.forces)
            self.wait_until(lambda: len(peer.forces) > begin + 200, program, "it pressed a while")
            self.press(program, peer)
            self.lose_display(program)
        ticks = int(re.search(r"(\d+) ticks", self.said()).group(1))
        self.check_record(record, ticks)

    def check_record(self, record, ticks):
        """Every tick is in it, to the one that pressed, and the same hand feels the same again."""
        lines = [line for line in record.read_text().splitlines() if not line.startswith("#")]
        self.assertEqual(len(lines), ticks + 1)
        forces = [float(line.split(",")[8]) for line in lines[1:]]
        self.assertGreater(forces[-1], 0.0)
        result = run(self.body, "--tool", "sphere:3", "--young", "0.1", "--poisson", "0.45",
                     "--no-auto", "--site", "1,0,0", "--device", f"replay:{record}",
                     "--output", self.output, whole_body=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        # The live session limits its force to the device; the ideal force is not limited. The
        # replay uses the times of the ticks, and a recorded tick may have been late: 5 %.
        peak = float(re.search(r"peak\s+force ([\d.e+-]+) N", result.stdout).group(1))
        self.assertAlmostEqual(peak, max(forces), delta=0.05 * peak)

    def test_a_signal_ends_it_as_by_hand(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            record = self.folder / "signal.csv"
            with self.pressed(record) as (program, _):
                program.send_signal(number)
                self.assertEqual(program.wait(timeout=TIME_OUT), 0, self.said())
            self.assertGreater(len(record.read_text().splitlines()), 100)

    def test_a_trial_keeps_its_answers(self):
        program = self.open("--trial", "sphere:3,flat:3")
        self.wait_until(lambda: "window open" in self.said(), program, "the window is open")
        self.lose_display(program)
        self.assertIn("trial,x,y,answer", (self.output / "trial.csv").read_text())

    def test_a_map_ends_too(self):
        program = self.open("--map")
        self.wait_until(lambda: "window open" in self.said(), program, "the window is open")
        self.lose_display(program)

    def test_a_display_that_does_not_answer(self):
        for display in (":987", ""):
            with self.subTest(display=display):
                self.refuse(self.body, "--window", words=("DISPLAY", "xvfb-run"),
                            environment={"DISPLAY": display})


if __name__ == "__main__":
    unittest.main()
