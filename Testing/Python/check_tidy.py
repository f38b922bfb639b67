#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The kernels pass clang-tidy with the checks of .clang-tidy (clang-tidy 14, as in Debian 12).

    check_tidy.py BUILD_DIR [NAME ...]    with NAMEs: only files whose path contains one of them

Kernels: Filters/{Mechanics,Contact,Laws,Strain,Solids,Identification}, Interactors/{Haptics,Transports,Trials}. Their
*.cxx are compiled with the flags of BUILD_DIR/compile_commands.json. Several files are compiled together, because
nearly all the time is spent on the headers of Eigen and of the standard library. Their headers are checked where they
are included.

Exit code: 0 no fault, 1 a fault was found (or there was nothing to check), 77 clang-tidy is missing.
"""
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

VERSION = 14
KERNELS = ("Filters/Mechanics", "Filters/Contact", "Filters/Laws", "Filters/Strain", "Filters/Solids",
           "Filters/Identification", "Interactors/Haptics", "Interactors/Transports", "Interactors/Trials")
PARALLEL = 2
GROUP = 24 # files that are compiled together, which need 0.9 GB

# The flags are for g++: clang does not know every warning, and its own warnings are not wanted
# here.
CLANG_FLAGS = ("-Wno-unknown-warning-option", "-Wno-error")


def find_tool():
    """Finds clang-tidy of this version, because other versions have other checks."""
    for name in (f"clang-tidy-{VERSION}", "clang-tidy"):
        tool = shutil.which(name)
        if tool and f"version {VERSION}." in subprocess.run(
                [tool, "--version"], capture_output=True, text=True).stdout:
            return tool
    return None


def compile_flags(build):
    """The flags of every source file in compile_commands.json. Paths are made absolute."""
    flags = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        words = shlex.split(entry["command"])
        words = words[1 + next(i for i, word in enumerate(words) if not word.endswith("ccache")):]
        words = words[:words.index("-o")]
        file = (Path(entry["directory"]) / entry["file"]).resolve()
        for source in grouped_sources(file) or [file]:
            flags[source] = tuple(words)
    return flags


def grouped_sources(file):
    """The sources that CMake combines in this file; none if the file is a source itself."""
    if file.parent.name != "Unity":
        return []
    return [Path(name) for name in re.findall(r'^#include "(/.*)"', file.read_text(), re.MULTILINE)]


def kernel_files(root, names):
    files = sorted(path for kernel in KERNELS for path in (root / kernel).rglob("*.cxx"))
    return [path for path in files if not names or any(name in str(path) for name in names)]


def private_names(path):
    """The names that a file may define privately: names at the start of a line, or before '=' or '('."""
    text = path.read_text(encoding="utf-8")
    return set(re.findall(r"^(?:struct|class|enum class|enum|using) (\w+)", text, re.MULTILINE) +
               re.findall(r"^[a-z][^;=(]*?[ &*](\w+)(?: =|\(|{|\[)", text, re.MULTILINE))


def grouped(files):
    """Groups of files that can be compiled together: no two files of a group define the same private name."""
    groups = []
    for path in files:
        names = private_names(path)
        group = next((group for group in groups
                      if len(group[0]) < GROUP and not group[1] & names), None)
        if group is None:
            groups.append(([path], names))
        else:
            group[0].append(path)
            group[1].update(names)
    return [group for group, _ in groups]


def joined(files):
    """The files one after the other, each under its own name, without repeated includes."""
    lines, included = [], set()
    for path in files:
        own = path.read_text(encoding="utf-8").splitlines()
        lines.append(f'#line 1 "{path}"')
        lines += ["" if line in included else line for line in own]
        included.update(line for line in own if line.startswith("#include"))
    return "\n".join(lines) + "\n"


def tidy(tool, root, files, flags):
    """The exit code and the output of clang-tidy for files that are compiled with the same flags."""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "joined.cxx"
        source.write_text(joined(files), encoding="utf-8")
        result = subprocess.run([tool, "--quiet", f"--config-file={root / '.clang-tidy'}", str(source), "--",
                                 *flags, *CLANG_FLAGS], capture_output=True, text=True)
    return result.returncode, result.stdout + (result.stderr if result.returncode else "")


def check(tool, root, files, flags):
    """The files of one kernel that have a fault. Files that cannot be compiled together are compiled separately."""
    offenders = []
    work = grouped(files)
    with ThreadPoolExecutor(PARALLEL) as pool:
        while work:
            again = []
            for group, (code, report) in zip(work, pool.map(lambda some: tidy(tool, root, some, flags), work)):
                names = " ".join(str(path.relative_to(root)) for path in group)
                if len(group) > 1 and "clang-diagnostic-error" in report:
                    print(f"{names}: not to be read as one")
                    again += [[path] for path in group]
                    continue
                print(f"{names}: {'FOUND SOMETHING' if code else 'ok'}", flush=True)
                if code:
                    print(report)
                    offenders += group
            work = again
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
    flags = compile_flags(build)
    wanted = kernel_files(root, arguments[1:])
    files = [path for path in wanted if path in flags]
    if not files:
        print("tidy: no file of the kernels is compiled there")
        return 1
    offenders = []
    for same in sorted({flags[path] for path in files}):
        offenders += check(tool, root, [path for path in files if flags[path] == same], same)
    for path in wanted:
        if path not in flags:
            print(f"{path.relative_to(root)}: NOT CHECKED, this build does not compile it")
    print(f"tidy: {len(files)} of {len(wanted)} files, something found in {len(offenders)}")
    return 1 if offenders else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
