#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks which folder ("room") may include which other folder, according to this drawing.

    Mechanics --> Contact --> Laws --> Response (VTK filters) --> Interaction (VTK) --> Plugin/*
                      '--------------> Haptics (devices, servo) ------'
    modules: Mechanics --> Strain --> Plugin/*
             Haptics --> Transports --> Plugin/*
             Laws --> Solids --> SolidResponse (VTK) --> Plugin/*
             Mechanics --> Identification --> MeasuredResponse (VTK) --> Plugin/*
             Response --> Pieces (VTK), which Response loads
             Mechanics --> Trials --> Plugin/*
             Interaction --> Comparison (VTK) --> Plugin/*

A room may include any room to its left along the arrows, never a room to its right or parallel to it:

    Filters/Mechanics         no other room
    Filters/Contact           Mechanics
    Filters/Laws              Mechanics, Contact
    Filters/Strain            Mechanics
    Filters/Solids            Mechanics, Contact, Laws
    Filters/Identification    Mechanics
    Filters/Response          Mechanics, Contact, Laws
    Filters/SolidResponse     Mechanics, Contact, Laws, Solids, Response
    Filters/MeasuredResponse  Mechanics, Contact, Laws, Identification, Response
    Filters/Pieces            Mechanics, Contact, Laws, Response
    Interactors/Haptics       Mechanics, Contact
    Interactors/Transports    Mechanics, Contact, Haptics
    Interactors/Trials        Mechanics
    Interactors/Interaction   Mechanics, Contact, Laws, Response, Haptics
    Interactors/Comparison    Mechanics, Contact, Laws, Response, Haptics, Interaction
    Plugin/NAME               all of the above, no other Plugin room

Mechanics, Contact, Laws, Strain, Solids, Identification, Haptics, Transports and Trials include no header of VTK, ParaView or
Qt: they build without them.
Only Plugin/ParaView includes headers of ParaView (pq*, vtkPV*, vtkSM*, ...).

The file name of an include determines its room, so no two rooms may have a header of the same name. A class of Filters
or Interactors that is not a vtkObject is included with its room and folder: "Contact/PackedMesh.h". Two more faults
are a folder with C++ code that is not a room, and a name at the top level that is not in the list.

    check_layering.py [SOURCE_DIR]    check the tree (default: the one this script is in)
    check_layering.py --self-test     break each rule in a made-up tree and check that it is noticed

Exit code: 0 the rules hold, 1 they do not, 2 wrong usage.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

CORE = {"Filters/Mechanics", "Filters/Contact", "Filters/Laws", "Interactors/Haptics"}
KERNEL_MODULES = {"Filters/Strain", "Filters/Solids", "Filters/Identification", "Interactors/Transports", "Interactors/Trials"}
MODULES = KERNEL_MODULES | {"Filters/SolidResponse", "Filters/MeasuredResponse", "Filters/Pieces", "Interactors/Comparison"}
KERNELS = CORE | KERNEL_MODULES

MAY_INCLUDE = {
    "Filters/Mechanics": set(),
    "Filters/Contact": {"Filters/Mechanics"},
    "Filters/Laws": {"Filters/Mechanics", "Filters/Contact"},
    "Filters/Strain": {"Filters/Mechanics"},
    "Filters/Solids": {"Filters/Mechanics", "Filters/Contact", "Filters/Laws"},
    "Filters/Identification": {"Filters/Mechanics"},
    "Filters/Response": {"Filters/Mechanics", "Filters/Contact", "Filters/Laws"},
    "Filters/SolidResponse": {"Filters/Mechanics", "Filters/Contact", "Filters/Laws", "Filters/Solids", "Filters/Response"},
    "Filters/MeasuredResponse": {"Filters/Mechanics", "Filters/Contact", "Filters/Laws", "Filters/Identification",
                                 "Filters/Response"},
    "Filters/Pieces": {"Filters/Mechanics", "Filters/Contact", "Filters/Laws", "Filters/Response"},
    "Interactors/Haptics": {"Filters/Mechanics", "Filters/Contact"},
    "Interactors/Transports": {"Filters/Mechanics", "Filters/Contact", "Interactors/Haptics"},
    "Interactors/Trials": {"Filters/Mechanics"},
    "Interactors/Interaction": CORE | {"Filters/Response"},
    "Interactors/Comparison": CORE | {"Filters/Response", "Interactors/Interaction"},
}
for plugin_room in ("Plugin/ParaView", "Plugin/Python", "Plugin/Viewer"):
    MAY_INCLUDE[plugin_room] = CORE | MODULES | {"Filters/Response", "Interactors/Interaction"}

WINGS = ("Filters", "Interactors", "Plugin")

TOP_LEVEL = {
    "CMakeLists.txt", "Plugin", "Filters", "Interactors", "Testing", "Data",
    "README.md", "LICENSE", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff", "SECURITY.md",
    "CMakePresets.json", "run",
    ".ci", ".clang-format", ".clang-tidy", ".gitignore",
}
# Files that a build leaves behind (as in .gitignore), for a tree without git.
TOP_LEVEL_UNTRACKED = {"build", "__pycache__", "CMakeUserPresets.json", "compile_commands.json"}

HEADERS = {".h", ".hpp", ".hxx", ".txx"}
SOURCES = HEADERS | {".c", ".cc", ".cpp", ".cxx"}

COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.MULTILINE)

# vtkSMPTools.h and related headers belong to VTK (symmetric multiprocessing), not to ParaView's
# server manager.
PARAVIEW = re.compile(
    r"pq[A-Z]|vtkPV[A-Z]|vtkSM(?!P(\.h|Tools|ThreadLocal))[A-Z]|vtkSI[A-Z]|vtkClientServer")
VTK = re.compile(r"vtk[A-Z_]|vtk/")
QT = re.compile(r"Q[A-Z][A-Za-z]*(\.h)?$|Qt[A-Z]\w*/")


def room_of(path):
    """The room of a path relative to the source folder: its first two folders; None for a path outside of all rooms."""
    return "/".join(path.parts[:2]) if len(path.parts) > 2 else None


def code_files(root):
    for wing in WINGS:
        for path in sorted((root / wing).rglob("*")):
            if path.suffix in SOURCES and path.is_file():
                yield path.relative_to(root)


def includes(text):
    """(line number, name) of every include directive outside of /* comments */."""
    text = COMMENT.sub(lambda comment: "\n" * comment.group().count("\n"), text)
    for match in INCLUDE.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, match.group(1)


def map_headers(files):
    """File name of a header -> its path; and the complaints about names used in two rooms."""
    owner, complaints = {}, []
    for path in files:
        if path.suffix not in HEADERS:
            continue
        first = room_of(owner.setdefault(path.name, path))
        if first != room_of(path):
            complaints.append(f"{path}: {first} has a header of that name too")
    return owner, complaints


def told_by_room(path):
    """The form in which a header is included: with room and folder, or only by its name, like headers of VTK, of C and
    of a plugin."""
    return "/".join(path.parts[1:]) if path.parts[0] != "Plugin" and path.name[0].isupper() else path.name


def judge(room, included, owner):
    """The fault if this room includes this header; None if it may."""
    name = included.rsplit("/", 1)[-1]
    header = owner.get(name)
    if header and room_of(header) != room and room_of(header) not in MAY_INCLUDE[room]:
        return f"{room} may not include {room_of(header)}"
    if header and name[0].isupper() and included != told_by_room(header):
        return f'it is "{told_by_room(header)}"'
    if header:
        return None
    if PARAVIEW.match(name) and room != "Plugin/ParaView":
        return "only Plugin/ParaView may include ParaView"
    if room in KERNELS and (VTK.match(included) or VTK.match(name)):
        return f"{room} may not include VTK"
    if room in KERNELS and QT.match(included):
        return f"{room} may not include Qt"
    return None


def check_rooms(root):
    files = list(code_files(root))
    owner, complaints = map_headers(files)
    for path in files:
        room = room_of(path)
        if room not in MAY_INCLUDE:
            complaints.append(f"{path}: not in a room of the house")
            continue
        text = (root / path).read_text(encoding="utf-8", errors="replace")
        for line, included in includes(text):
            complaint = judge(room, included, owner)
            if complaint:
                complaints.append(f"{path}:{line}: #include {included}: {complaint}")
    return complaints


def git_names(root, *options):
    """Top-level names of the files that git lists; None if the tree is not a git repository."""
    try:
        listing = subprocess.run(["git", "-C", str(root), "ls-files", "-z", *options],
                                 capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return None
    return {name.split("/", 1)[0] for name in listing.split("\0") if name}


def check_top_level(root):
    """Checks that only allowed names exist. Hidden files that are not under version control are ignored."""
    tracked = git_names(root)
    if tracked:
        names = git_names(root, "--cached", "--others", "--exclude-standard")
    else:
        tracked = set()
        names = {path.name for path in root.iterdir()} - TOP_LEVEL_UNTRACKED
    strangers = {name for name in names - TOP_LEVEL if not name.startswith(".") or name in tracked}
    return [f"{name}: does not belong at the top level" for name in sorted(strangers)]


def check(root):
    return check_rooms(root) + check_top_level(root)


# --- self-test ---

SOUND_TREE = {
    "CMakeLists.txt": "",
    "Filters/Mechanics/Hertz.h": "#include <Eigen/Core>\n#include <cmath>\n",
    "Filters/Contact/Tick.h": '#include "Mechanics/Hertz.h"\n/*\n#include "vtkObject.h"\n*/\n',
    "Filters/Laws/Law.h": '#include "Mechanics/Hertz.h"\n#include "Contact/Tick.h"\n',
    "Filters/Strain/Solver.h": '#include "Mechanics/Hertz.h"\n',
    "Filters/Solids/Element.h": '#include "Laws/Law.h"\n',
    "Filters/Identification/Fit.h": '#include "Mechanics/Hertz.h"\n',
    "Filters/SolidResponse/vtkSolid.h": '#include "vtkTool.h"\n#include "Solids/Element.h"\n',
    "Filters/MeasuredResponse/vtkReadings.h": '#include "vtkTool.h"\n#include "Identification/Fit.h"\n',
    "Filters/Response/vtkTool.h": '#include <vtkSMPTools.h>\n#include "Contact/Tick.h"\n',
    "Filters/Response/vtkTool.cxx": '#include "vtkTool.h"\n#include "Mechanics/Hertz.h"\n',
    "Filters/Pieces/Seam.h": '#include "vtkTool.h"\n#include "Contact/Tick.h"\n',
    "Interactors/Haptics/Device.h": '#include "Contact/Tick.h"\n#include "Mechanics/Hertz.h"\n#include <thread>\n',
    "Interactors/Transports/Socket.h": '#include "Haptics/Device.h"\n',
    "Interactors/Trials/Plan.h": '#include "Mechanics/Hertz.h"\n',
    "Interactors/Interaction/vtkSession.h": '#include "vtkTool.h"\n#include "Haptics/Device.h"\n',
    "Interactors/Comparison/vtkMap.h": '#include "vtkSession.h"\n#include "vtkTool.h"\n',
    "Plugin/Viewer/main.cxx": '#include "vtkSession.h"\n#include "Mechanics/Hertz.h"\n#include "Trials/Plan.h"\n',
    "Plugin/ParaView/pqPanel.h": '#include "pqView.h"\n#include <vtkSMProxy.h>\n',
}

# One file per case that breaks the valid tree; the complaint must name the file.
BREAKS = [
    ("Filters/Mechanics/Wrong.h", '#include "Contact/Tick.h"\n'),
    ("Filters/Mechanics/Wrong.cxx", "  #  include <vtkMath.h>\n"),
    ("Filters/Contact/Wrong.cxx", '#include "../Response/vtkTool.h"\n'),
    ("Filters/Contact/Wrong.h", '#include "Haptics/Device.h"\n'),
    ("Filters/Contact/Wrong.h", '#include "Hertz.h"\n'),
    ("Filters/Contact/Wrong.cxx", '#include "Contact/Hertz.h"\n'),
    ("Filters/Contact/Wrong.h", "#include <vtk/vtkMath.h>\n"),
    ("Filters/Contact/Wrong.h", "#include <QString>\n"),
    ("Filters/Contact/Wrong.h", '#include "Laws/Law.h"\n'),
    ("Filters/Laws/Wrong.h", '#include "vtkTool.h"\n'),
    ("Filters/Laws/Wrong.h", "#include <vtkMath.h>\n"),
    ("Filters/Laws/Wrong.h", '#include "Solids/Element.h"\n'),
    ("Filters/Mechanics/Wrong.h", '#include "Strain/Solver.h"\n'),
    ("Filters/Laws/Wrong.h", '#include "Strain/Solver.h"\n'),
    ("Filters/Strain/Wrong.h", '#include "Contact/Tick.h"\n'),
    ("Filters/Strain/Wrong.h", "#include <vtkMath.h>\n"),
    ("Filters/Solids/Wrong.h", '#include "Strain/Solver.h"\n'),
    ("Filters/Solids/Wrong.h", '#include "vtkTool.h"\n'),
    ("Filters/Solids/Wrong.h", '#include "Identification/Fit.h"\n'),
    ("Filters/Identification/Wrong.h", '#include "Contact/Tick.h"\n'),
    ("Filters/Response/Wrong.h", '#include "Solids/Element.h"\n'),
    ("Filters/Response/Wrong.h", '#include "vtkSolid.h"\n'),
    ("Filters/Response/Wrong.h", '#include "Identification/Fit.h"\n'),
    ("Filters/SolidResponse/Wrong.h", '#include "vtkReadings.h"\n'),
    ("Filters/MeasuredResponse/Wrong.h", '#include "Solids/Element.h"\n'),
    ("Interactors/Interaction/Wrong.h", '#include "vtkSolid.h"\n'),
    ("Interactors/Haptics/Wrong.h", '#include "Transports/Socket.h"\n'),
    ("Interactors/Transports/Wrong.h", '#include "Laws/Law.h"\n'),
    ("Interactors/Transports/Wrong.h", "#include <vtkMath.h>\n"),
    ("Interactors/Interaction/Wrong.h", '#include "Transports/Socket.h"\n'),
    ("Interactors/Haptics/Wrong.h", '#include "Laws/Law.h"\n'),
    ("Interactors/Haptics/Wrong.h", '#include "vtkTool.h"\n'),
    ("Interactors/Haptics/Wrong.h", "#include <vtkSmartPointer.h>\n"),
    ("Interactors/Haptics/Wrong.h", '#include "vtkSession.h"\n'),
    ("Interactors/Haptics/Wrong.h", '#include "Trials/Plan.h"\n'),
    ("Interactors/Trials/Wrong.h", '#include "Haptics/Device.h"\n'),
    ("Interactors/Trials/Wrong.h", "#include <vtkMath.h>\n"),
    ("Interactors/Interaction/Wrong.h", '#include "Trials/Plan.h"\n'),
    ("Interactors/Interaction/Wrong.h", '#include "vtkMap.h"\n'),
    ("Interactors/Comparison/Wrong.h", '#include "vtkSolid.h"\n'),
    ("Filters/SolidResponse/Wrong.h", '#include "vtkMap.h"\n'),
    ("Filters/Response/Wrong.h", '#include "Pieces/Seam.h"\n'),
    ("Filters/Pieces/Wrong.h", '#include "vtkSession.h"\n'),
    ("Filters/Response/Wrong.h", '#include "Haptics/Device.h"\n'),
    ("Filters/Response/Wrong.h", '#include "vtkSession.h"\n'),
    ("Filters/Response/Wrong.h", "#include <vtkSMProxy.h>\n"),
    ("Interactors/Interaction/Wrong.h", '#include "pqPanel.h"\n'),
    ("Interactors/Interaction/Wrong.h", '#include "pqActiveObjects.h"\n'),
    ("Plugin/Viewer/Wrong.cxx", '#include "pqPanel.h"\n'),
    ("Plugin/Viewer/Wrong.cxx", '#include "vtkPVConfig.h"\n'),
    ("Plugin/ParaView/Hertz.h", ""),
    ("Filters/Stranger/Wrong.h", ""),
    ("Filters/Wrong.h", ""),
    ("Source", ""),
]


def plant(root, tree):
    for name, text in tree.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def self_test():
    failures = 0
    for name, text in [(None, None)] + BREAKS:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            plant(root, SOUND_TREE)
            if name:
                plant(root, {name: text})
            complaints = check(root)
        if name is None and complaints:
            print("self-test: complaints about a sound tree:", *complaints, sep="\n  ")
            failures += 1
        elif name and not (len(complaints) == 1 and Path(name).name in complaints[0]):
            print(f"self-test: {name} with {text!r}: expected one complaint about it, got {complaints}")
            failures += 1
    print(f"self-test: {1 + len(BREAKS)} trees, {failures} failures")
    return 1 if failures else 0


def main(arguments, usage, what, checked, tested):
    """Runs the command line of a check: of the tree, by `checked`(root), which returns complaints, or its self-test."""
    if arguments == ["--self-test"]:
        return tested()
    if len(arguments) > 1 or any(argument.startswith("-") for argument in arguments):
        print(usage)
        return 2
    root = Path(arguments[0] if arguments else Path(__file__).parents[2]).resolve()
    if not (root / "Filters").is_dir():
        print(f"{root} is not the source folder of Palpate: it has no folder Filters")
        return 2
    complaints = checked(root)
    print(*complaints, sep="\n", end="\n" if complaints else "")
    print(f"{what}: {sum(1 for _ in code_files(root))} files, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], __doc__, "layering", check, self_test))
