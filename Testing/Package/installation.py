# SPDX-License-Identifier: BSD-3-Clause
"""The installation under test: components, installed into a scratch folder from the build."""

import os
import subprocess

BUILD = os.environ["PALPATE_BUILD"]
SOURCE = os.environ["PALPATE_SOURCE"]
VERSION = os.environ["PALPATE_VERSION"]
LIBDIR = os.environ["PALPATE_LIBDIR"]
KERNELS = ("Mechanics", "Contact", "Laws", "Strain", "Solids", "Identification", "Haptics", "Transports", "Trials")
LIBRARIES = KERNELS + ("Response", "SolidResponse", "MeasuredResponse", "Interaction", "Comparison")


def soversion():
    """What may change without a new soname is cut off: 0.1.7 is 0.1, 1.2.3 is 1."""
    major, minor, _ = VERSION.split(".")
    return f"{major}.{minor}" if major == "0" else major


def install(component, folder):
    """Installs a component below folder/usr; returns its files and links, relative to that."""
    subprocess.run([os.environ["PALPATE_CMAKE"], "--install", BUILD, "--component", component, "--prefix", "/usr"],
                   check=True, stdout=subprocess.DEVNULL, env={**os.environ, "DESTDIR": folder})
    return files_below(os.path.join(folder, "usr"))


def files_below(folder):
    found = []
    for path, folders, files in os.walk(folder):
        links = [name for name in folders if os.path.islink(os.path.join(path, name))]
        found += [os.path.relpath(os.path.join(path, name), folder) for name in files + links]
    return sorted(found)


def our_headers():
    """Names of all headers of the project; not of what a build may have unpacked below it."""
    return {name for room in ("Filters", "Interactors", "Plugin") for _, _, names in os.walk(os.path.join(SOURCE, room))
            for name in names if name.endswith(".h")}


def is_elf(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"
