# SPDX-License-Identifier: BSD-3-Clause
"""Runs a program with a separate file system in place of a folder: a full disk, or a read-only disk. Other programs do
not see it. Needs root, or a system that allows users to make name spaces.

    run(..., before=own_mount.over(folder, "size=64k", kept=other))
"""
import shutil
import subprocess

# $0: the folder, $1: options, $2: folder for a copy of the content at the end, "" for no copy.
SCRIPT = """mount -t tmpfs -o "$1" none "$0" || exit 77
kept=$2; folder=$0; shift 2
"$@"; code=$?
[ -z "$kept" ] || cp -a "$folder/." "$kept"
exit $code"""


def over(folder, options, kept=""):
    return ["unshare", "-rm", "sh", "-c", SCRIPT, str(folder), options, str(kept)]


def is_possible(folder):
    """Whether the machine permits it: in a read-only file system no file can be made."""
    if not shutil.which("unshare"):
        return False
    command = [*over(folder, "ro"), "sh", "-c", '! touch "$0/file" 2>/dev/null', str(folder)]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0
