# SPDX-License-Identifier: BSD-3-Clause
"""A separate X server for a test, which the test may stop."""
import os
import shutil
import subprocess


class OwnDisplay:
    """`name` is the DISPLAY of the server; `size` in pixels. `name` is None if Xvfb is not installed; see
    is_there()."""

    def __init__(self, size="1280x1024"):
        reading, writing = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{size}x24", "-noreset",
             "-nolisten", "tcp"], pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as said:
            self.name = f":{said.readline().strip()}"

    @staticmethod
    def is_there():
        return shutil.which("Xvfb") is not None

    def kill(self):
        self._server.terminate()  # the server removes its lock
        self._server.wait()
