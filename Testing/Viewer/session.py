# SPDX-License-Identifier: BSD-3-Clause
"""Runs the executable `palpate` as a user would; base class for the tests of the viewer.

PALPATE names the executable. Without a separate X server for the tests, the programs use DISPLAY.
"""
import os
import re
import resource
import subprocess
import tempfile
import unittest
from pathlib import Path

import bodies

PALPATE = os.environ.get("PALPATE", "palpate")
TIME_OUT = 800  # s; stops a program that hangs; slightly less than palpate_time_limit of Testing/CMakeLists.txt
PICTURES = ("overview", "deflection", "curves")
CACHE = tempfile.TemporaryDirectory(prefix="palpate cache ")  # a separate cache, not the user's cache


def run(*arguments, environment=None, room=None, before=(), answers=None, whole_body=False):
    """Runs palpate. Returns the finished process, with its output as text. `environment`: name -> value, None to unset;
    `room`: the largest size of a file, bytes, as on a full disk; `before`: a command that runs the program; `answers`:
    its standard input; `whole_body`: with the compliance of the whole body, which takes about ten seconds
    (test_whole_body.py).
    """
    if not whole_body and not {"--help", "--version", "--fixed"} & set(map(str, arguments)):
        arguments += ("--no-whole-body",)
    settings = {**os.environ, "XDG_CACHE_HOME": CACHE.name}
    for name, value in (environment or {}).items():
        settings.pop(name, None)
        if value is not None:
            settings[name] = value

    def limit():
        if room is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

    return subprocess.run([*before, PALPATE, *map(str, arguments)], env=settings, preexec_fn=limit,
                          capture_output=True, input=answers, text=True, errors="replace",
                          timeout=TIME_OUT, check=False)


def vertices(result):
    """Number of vertices of the body in the summary."""
    return int(re.search(r"body\s+(\d+) vertices", result.stdout).group(1))


def peak_force(result):
    """Largest force in the summary, N."""
    return float(re.search(r"peak\s+force ([\d.e+-]+) N", result.stdout).group(1))


class SessionCase(unittest.TestCase):
    """Each test has its own folder, which is deleted afterwards."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="palpate test ")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.output = self.folder / "out"

    def files(self):
        """File name -> time of writing, in the output folder."""
        paths = self.output.iterdir() if self.output.is_dir() else ()
        return {path.name: path.stat().st_mtime_ns for path in paths}

    def succeed(self, *arguments, pictures=(), **more):
        """Runs into self.output. All expected files must exist, and no other file may be made or changed. The default
        is without pictures, because they take most of the time."""
        before = self.files()
        result = run(*arguments, *(() if pictures else ("--no-pictures",)), "--output", self.output, **more)
        self.assertEqual(result.returncode, 0, result.stderr)
        files = {f"{picture}.png" for picture in pictures} | {"trajectory.csv"}
        after = self.files()
        self.assertLessEqual(files, set(after))
        self.assertEqual({name: time for name, time in after.items() if name not in files},
                         {name: time for name, time in before.items() if name not in files})
        return result

    def press(self, data, name, *arguments, pictures=(), **settings):
        """Writes the body into a file and presses a sphere of 3 mm on it, E = 0.1 MPa."""
        path = bodies.write(data, self.folder / name, **settings)
        return self.succeed(path, "--tool", "sphere:3", "--young", "0.1", "--poisson", "0.45",
                            *arguments, pictures=pictures)

    def refuse(self, *arguments, words=(), **more):
        """The program must end with an error that contains all the words, not by a signal, and leave no file."""
        before = self.files()
        result = run(*arguments, "--output", self.output, **more)
        self.assertGreater(result.returncode, 0, f"ended by a signal: {result.stderr}")
        self.assertLess(result.returncode, 128, f"ended by a signal: {result.stderr}")
        for word in words:
            self.assertIn(str(word), result.stderr + result.stdout)
        self.assertEqual(self.files(), before, "files of a run that failed")
        return result
