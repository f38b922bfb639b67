#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The kernels pass clang-tidy with the checks of .clang-tidy (clang-tidy 14, as in Debian 12).

    check_tidy.py BUILD_DIR [NAME ...]    with NAMEs: only files whose path contains one of them

Kernels: Filters/Mechanics, Filters/Contact, Interactors/Haptics. Each of their *.cxx is compiled with
the flags of BUILD_DIR/compile_commands.json; their headers are checked where they are included.

Exit code: 0 all is well, 1 something was found (or nothing to check), 77 clang-tidy is missing.
"""
import json
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

VERSION = 14
KERNELS = ("Filters/Mechanics", "Filters/Contact", "Interactors/Haptics")
PARALLEL = 2

# The flags are g++'s: clang need not know every warning, and its own warnings are not what is asked.
CLANG_FLAGS = ("--extra-arg=-Wno-unknown-warning-option", "--extra-arg=-Wno-error")


def find_tool():
    return shutil.which(f"clang-tidy-{VERSION}") or shutil.which("clang-tidy")


def compiled_files(build):
    """Every source file of compile_commands.json, made absolute."""
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    return {(Path(command["directory"]) / command["file"]).resolve() for command in commands}


def kernel_files(root, names):
    files = sorted(path for kernel in KERNELS for path in (root / kernel).rglob("*.cxx"))
    return [path for path in files if not names or any(name in str(path) for name in names)]


def tidy(tool, build, path):
    """(exit code, what clang-tidy says) about one file."""
    result = subprocess.run([tool, "--quiet", "-p", str(build), *CLANG_FLAGS, str(path)],
                            capture_output=True, text=True)
    return result.returncode, result.stdout + (result.stderr if result.returncode else "")


def check(tool, root, build, files):
    """The files in which something was found."""
    offenders = []
    with ThreadPoolExecutor(PARALLEL) as pool:
        for path, (code, report) in zip(files, pool.map(lambda file: tidy(tool, build, file), files)):
            print(f"{path.relative_to(root)}: {'FOUND SOMETHING' if code else 'ok'}", flush=True)
            if code:
                print(report)
                offenders.append(path)
    return offenders


def main(arguments):
    if not arguments or arguments[0].startswith("-"):
        print(__doc__)
        return 2
    root = Path(__file__).resolve().parents[2]
    build = Path(arguments[0]).resolve()
    tool = find_tool()
    if not tool:
        print("tidy: not checked, clang-tidy is not installed (Debian: apt install clang-tidy)")
        return 77
    if not (build / "compile_commands.json").is_file():
        print(f"tidy: {build} has no compile_commands.json (CMAKE_EXPORT_COMPILE_COMMANDS)")
        return 1
    compiled = compiled_files(build)
    wanted = kernel_files(root, arguments[1:])
    files = [path for path in wanted if path in compiled]
    if not files:
        print("tidy: no file of the kernels is compiled there")
        return 1
    offenders = check(tool, root, build, files)
    for path in wanted:
        if path not in compiled:
            print(f"{path.relative_to(root)}: NOT CHECKED, this build does not compile it")
    print(f"tidy: {len(files)} of {len(wanted)} files, something found in {len(offenders)}")
    return 1 if offenders else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
