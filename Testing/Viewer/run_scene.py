#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a scene of `palpate` into a folder, for the tests that check its output.

    run_scene.py PALPATE FOLDER CACHE [OPTIONS OF PALPATE]

The folder is emptied first. CACHE is the cache for skins of scans: "new" for a separate folder, FOLDER.cache, which is
emptied too, so that no skin of an older program is used; or the FOLDER of an earlier run, to use its cache. Exit code:
that of palpate; 77 if the scan of the head is not installed. The tests that need the folder then also end with 77:
skipped, with a message.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

SCAN = Path("/usr/share/mricron/templates/ch2.nii.gz")  # installed by Debian's mricron-data
SKIPPED = 77


def cache_of(folder):
    return f"{folder}.cache"


def main(arguments):
    program, folder, options = arguments[0], Path(arguments[1]), arguments[3:]
    cache = cache_of(folder if arguments[2] == "new" else arguments[2])
    shutil.rmtree(folder, ignore_errors=True)
    if arguments[2] == "new":
        shutil.rmtree(cache, ignore_errors=True)
    folder.mkdir(parents=True)
    if not {"--scene", "--compare"} & set(options) and not SCAN.exists():
        print(f"skipped: {SCAN} is not installed (Debian: apt install mricron-data)")
        return SKIPPED
    result = subprocess.run([program, *options, "--output", folder], check=False,
                            env={**os.environ, "XDG_CACHE_HOME": cache})
    return result.returncode if result.returncode >= 0 else 1


if __name__ == "__main__":
    if len(sys.argv) < 4:
        print(__doc__)
        sys.exit(2)
    sys.exit(main(sys.argv[1:]))
