# SPDX-License-Identifier: BSD-3-Clause
"""A session of one minute while the window draws as fast as it can, and the report of the servo thread.

    test_long_session.py PALPATE_EXECUTABLE FOLDER [SECONDS]

Needs a separate display and xdotool; exit code 77 without xdotool. The software renderer uses all processors. The
timing of the thread is printed but not checked, because it depends on the machine.
"""
import math
import os
import re
import shutil
import subprocess
import sys
import time

PROGRAM, FOLDER = sys.argv[1], sys.argv[2]
SECONDS = float(sys.argv[3]) if len(sys.argv) > 3 else 60.0
RATE = 1000  # the viewer's default


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True, timeout=300)


def wait_for(path, words, program):
    while True:
        with open(path, encoding="utf-8") as file:
            if words in file.read():
                return
        assert program.poll() is None, "the program ended early"
        time.sleep(0.1)


def main():
    if not shutil.which("xdotool"):
        print("no xdotool")
        return 77
    os.makedirs(FOLDER, exist_ok=True)
    log = os.path.join(FOLDER, "long.txt")
    with open(log, "w", encoding="utf-8") as file:
        program = subprocess.Popen([PROGRAM, "--window", "--scene", "cylinder"],
                                   stdout=file, stderr=subprocess.STDOUT)
    try:
        wait_for(log, "tool: ", program)
        begin = time.monotonic()
        xdotool("mousemove", 600, 330)
        time.sleep(3.0)
        xdotool("mousedown", 1)
        keys = 0
        while time.monotonic() - begin < SECONDS:
            phase = time.monotonic() - begin
            xdotool("mousemove", int(600 + 60 * math.sin(phase)), int(340 + 30 * math.cos(1.7 * phase)))
            time.sleep(0.02)
            if phase > 5.0 * (keys + 1):
                keys += 1
                xdotool("key", 1 + keys % 3)  # changes the tool during contact
        xdotool("mouseup", 1)
        xdotool("key", "q")
        lasted = time.monotonic() - begin
        code = program.wait(timeout=300)
    finally:
        program.kill()
        program.wait()
    with open(log, encoding="utf-8") as file:
        said = file.read()
    print(said)
    assert code == 0, code
    ticks = int(re.search(r"(\d+) ticks", said).group(1))
    missed = int(re.search(r"(\d+) missed", said).group(1))
    # Ticks and missed ticks add up to the duration, except for the time to open and close the
    # window.
    assert abs((ticks + missed) / RATE - lasted) < 0.1 * lasted + 5.0, (ticks, missed, lasted)
    assert float(re.search(r"strongest force (\S+) N", said).group(1)) > 1.0
    assert int(re.search(r"(\d+) changes of scene", said).group(1)) >= keys - 1
    for word in ("device: ", "wake-up", "tick", "worst", "0 disconnections"):
        assert word in said, word
    return 0


if __name__ == "__main__":
    sys.exit(main())
