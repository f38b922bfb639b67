#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every C++ file is formatted by .clang-format (clang-format 14, as in Debian 12).

    check_format.py [SOURCE_DIR]    default: the tree this script is in

Checks the *.h and *.cxx that git tracks or would track; without git, all files except those under build/.
Other versions of clang-format may format some lines differently, so only version 14 is used.

To fix a file: clang-format -i FILE

Exit code: 0 no fault, 1 the listed files are not formatted, 77 clang-format is missing (nothing was checked).
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

VERSION = 14
SUFFIXES = (".h", ".cxx")


def find_tool():
    """Finds clang-format of this version, because other versions format some lines differently."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        tool = shutil.which(name)
        if tool and f"version {VERSION}." in subprocess.run(
                [tool, "--version"], capture_output=True, text=True).stdout:
            return tool
    return None


def listed_by_git(root):
    """Tracked and new files; None if git is missing or the tree is not a git repository."""
    try:
        listing = subprocess.run(
            ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return None
    return [root / name for name in listing.split("\0") if name]


def found_by_walking(root):
    for folder, subfolders, names in os.walk(root):
        if Path(folder) == root and "build" in subfolders:
            subfolders.remove("build")
        subfolders[:] = [name for name in subfolders if not name.startswith(".")]
        yield from (Path(folder) / name for name in names)


def code_files(root):
    listed = listed_by_git(root) or found_by_walking(root)
    return sorted(path for path in listed if path.suffix in SUFFIXES and path.is_file())


def misformatted(tool, root, files):
    """The files that clang-format would change. Prints its first complaint about each. All files are passed in one
    call, because starting takes longer than checking a hundred files."""
    result = subprocess.run([tool, "--dry-run", "--Werror", "--style=file", *files], cwd=root,
                            capture_output=True, text=True)
    complaints = {}
    for line in result.stderr.splitlines():
        match = re.match(r"(.+):\d+:\d+: ", line)
        if match:
            complaints.setdefault(match.group(1), line)
    print(*complaints.values(), sep="\n", end="\n" if complaints else "")
    if result.returncode and not complaints:
        print(result.stderr)
        return files
    return [path for path in files if str(path) in complaints]


def main(arguments):
    if len(arguments) > 1 or any(argument.startswith("-") for argument in arguments):
        print(__doc__)
        return 2
    root = Path(arguments[0] if arguments else Path(__file__).parents[2]).resolve()
    tool = find_tool()
    if not tool:
        print("format: not checked, clang-format is not installed (Debian: apt install clang-format)")
        return 77
    files = code_files(root)
    if not files:
        print(f"format: no C++ file under {root}")
        return 1
    offenders = misformatted(tool, root, files)
    print(f"format: {len(files)} files, {len(offenders)} not formatted")
    if offenders:
        print("to mend them: clang-format -i", *(path.relative_to(root) for path in offenders))
    return 1 if offenders else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
