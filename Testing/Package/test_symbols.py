#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The libraries export only the declarations of the installed headers; their C symbols are those of palpate.symbols."""

import glob
import os
import re
import subprocess
import tempfile
import unittest

from installation import KERNELS, LIBDIR, LIBRARIES, SOURCE, VERSION, install, our_headers

HAPTICS = os.path.join(SOURCE, "Interactors", "Haptics")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()

LINKER = ("__bss_start", "_edata", "_end", "_init", "_fini") # where VTK's libraries make it say so


class Symbols(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        install("runtime", cls.scratch.name)
        install("development", cls.scratch.name)
        include = os.path.join(cls.scratch.name, "usr", "include", "palpate")
        cls.sources = our_headers()
        cls.headers = "\n".join(read(path) for path in glob.glob(f"{include}/**/*.h", recursive=True))

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def exported(self, library):
        """(kind, demangled name) of each symbol; kind as nm has it."""
        path = os.path.join(self.scratch.name, "usr", LIBDIR, f"libpalpate{library}.so.{VERSION}")
        told = subprocess.run(["nm", "-DC", "--defined-only", path], check=True, capture_output=True, text=True).stdout
        symbols = [(line.split()[1], line.split(" ", 2)[2]) for line in told.splitlines()]
        return [symbol for symbol in symbols if symbol[1] not in LINKER]

    def listed(self):
        lines = read(os.path.join(HAPTICS, "palpate.symbols")).splitlines()
        return [line for line in lines if not line.startswith("#")]

    def test_only_what_installed_headers_declare(self):
        for library in LIBRARIES:
            symbols = self.exported(library)
            self.assertGreater(len(symbols), 10, library)
            for kind, name in symbols:
                scopes = re.split(r"[(<\[]", name)[0].split(" ")[-1].split("::")
                owner = scopes[1] if scopes[0] == "palpate" else scopes[0]
                if scopes == [f"palpate{library}Module"]: # by which the core loads it
                    continue
                if scopes[0].startswith("palpate") or f"{owner}.h" in self.sources:
                    self.assertTrue(re.search(rf"\b{owner}\b", self.headers), f"{library} exports {name}")
                else: # inline functions of VTK, templates of the standard library
                    self.assertIn(kind, "WVuw", f"{library} exports {name}")

    def test_private_classes_are_hidden(self):
        for library, name in (("Mechanics", "SphereTool"), ("Contact", "LeadingLaws"), ("Haptics", "TrajectoryTable")):
            self.assertIn(f"{name}.h", self.sources)
            self.assertNotIn(f"palpate::{name}", " ".join(symbol for _, symbol in self.exported(library)))

    def test_no_kernel_calls_itself_through_the_table_of_other_libraries_functions(self):
        for library in KERNELS:
            path = os.path.join(self.scratch.name, "usr", LIBDIR, f"libpalpate{library}.so.{VERSION}")
            told = subprocess.run(["readelf", "-rW", path], check=True, capture_output=True, text=True).stdout
            # offset, info, type, value, name; the value is 0 for a symbol that another library
            # defines
            called = [line.split() for line in told.splitlines() if "_JUMP_SL" in line]
            self.assertGreater(len(called), 10, library)
            self.assertEqual([entry[4] for entry in called if entry[3].strip("0")], [], library)

    def test_c_functions_are_those_listed(self):
        exported = sorted(name for _, name in self.exported("Haptics") if re.fullmatch(r"palpate_\w+", name))
        self.assertEqual(exported, [line.split()[0] for line in self.listed()])
        for library in set(KERNELS) - {"Haptics"}:
            self.assertFalse([name for _, name in self.exported(library) if re.fullmatch(r"palpate_\w+", name)])

    def test_the_list_is_that_of_the_header(self):
        header = read(os.path.join(HAPTICS, "palpate.h"))
        declared = re.findall(r"PALPATE_API [\w\s*]*?(palpate_\w+)\(", header)
        names = [line.split()[0] for line in self.listed()]
        self.assertEqual(names, sorted(set(names)))
        self.assertEqual(sorted(declared), names)
        self.assertEqual(len(re.findall(r"^  PALPATE_API", header, re.MULTILINE)), len(declared))
        newest = int(re.search(r"#define PALPATE_API_VERSION (\d+)", header).group(1))
        self.assertTrue(all(1 <= int(line.split()[1]) <= newest for line in self.listed()))


if __name__ == "__main__":
    unittest.main()
