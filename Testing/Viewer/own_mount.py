# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program with a separate file system in place of a folder, which no other program sees: a full disk,
or a read-only disk. Needs root, or a system that gives users name spaces.

    run(..., before=own_mount.over(folder, "size=64k", kept=other))
"""
import shutil
import subprocess

# $0: the folder, $1: options, $2: folder for a copy of the content at the end, "" for none.
SCRIPT = """mount -t tmpfs -o "$1" none "$0" || exit 77
kept=$2; folder=$0; shift 2
"$@"; code=$?
[ -z "$kept" ] || cp -a "$folder/." "$kept"
exit $code"""


def over(folder, options, kept=""):
    return ["unshare", "-rm", "sh", "-c", SCRIPT, str(folder), options, str(kept)]


def is_possible(folder):
    """Whether the machine lets us: a file cannot be made in a file system that may only be read."""
    if not shutil.which("unshare"):
        return False
    command = [*over(folder, "ro"), "sh", "-c", '! touch "$0/file" 2>/dev/null', str(folder)]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0
