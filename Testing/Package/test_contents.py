#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each component contains its files and nothing else: no test or benchmark, no private header, no path of the
machine on which it was built."""

import os
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

from installation import BUILD, LIBDIR, LIBRARIES, SOURCE, VERSION, install, is_elf, our_headers, soversion

# All files that a component may contain. Every file must match a pattern, and every pattern a file.
ALLOWED = {
    "runtime": [
        r"bin/palpate",
        *(rf"{LIBDIR}/libpalpate{name}\.so\.({re.escape(VERSION)}|{re.escape(soversion())})" for name in LIBRARIES),
        rf"{LIBDIR}/libpalpateMesher\.so",
        rf"{LIBDIR}/libpalpatePieces\.so",
        rf"{LIBDIR}/libpalpateViewer(Solids|Identification|Comparison|Trials)\.so",
        r"lib/udev/rules\.d/70-palpate\.rules",
        r"share/applications/palpate\.desktop",
        r"share/bash-completion/completions/palpate",
        r"share/icons/hicolor/scalable/apps/palpate\.svg",
        r"share/man/man1/palpate\.1\.gz",
    ],
    "python": [
        r"lib.*/palpate/__init__\.py",
        r"lib.*/palpate/\w+\.pyi?",
        r"lib.*/palpate/py\.typed",
        r"lib.*/palpate/palpate((|Solid|Measured)Response|Interaction|Comparison)(\.[\w-]+)?\.so",
    ],
    "plugin": [
        rf"{LIBDIR}/paraview-[\d.]+/plugins/Palpate/Palpate\.so",
        rf"{LIBDIR}/paraview-[\d.]+/plugins/Palpate/libpalpateServerManager\.so",
        rf"{LIBDIR}/paraview-[\d.]+/plugins/palpate\.plugins\.xml",
    ],
    "development": [
        r"include/palpate/(\w+/)*\w+\.h",
        *(rf"{LIBDIR}/libpalpate{name}\.so" for name in LIBRARIES),
        rf"{LIBDIR}/cmake/palpate/[\w.-]+\.cmake",
        rf"{LIBDIR}/vtk/hierarchy/Palpate/\w+-hierarchy\.txt",
        r"share/palpate/device/[\w.]+",
        rf"{LIBDIR}/libpalpate\w+CS\.a", # by ParaView's own function; not packed
    ],
}
OPTIONAL = re.compile(r".*(CS\\.a|pyi\?|libpalpateMesher\\.so)$") # the last one where CGAL is


class Contents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.root = {name: os.path.join(cls.scratch.name, name) for name in ALLOWED}
        cls.files = {name: install(name, cls.root[name]) for name in ALLOWED}

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def full(self, component, file):
        return os.path.join(self.root[component], "usr", file)

    def every_file(self):
        return [self.full(component, file) for component, files in self.files.items() for file in files]

    def test_each_component_holds_what_it_should(self):
        with_paraview = os.path.exists(os.path.join(BUILD, "Plugin", "ParaView"))
        for component, allowed in ALLOWED.items():
            if component == "plugin" and not with_paraview:
                continue
            for file in self.files[component]:
                self.assertTrue(any(re.fullmatch(pattern, file) for pattern in allowed), f"{component}: {file}")
            for pattern in allowed:
                if OPTIONAL.fullmatch(pattern):
                    continue
                self.assertTrue(any(re.fullmatch(pattern, file) for file in self.files[component]),
                                f"{component} has nothing like {pattern}")

    def test_nothing_is_outside_the_components(self):
        self.assertEqual(install("Unspecified", os.path.join(self.scratch.name, "unspecified")), [])

    def test_libraries_are_versioned(self):
        for name in LIBRARIES:
            library = f"{LIBDIR}/libpalpate{name}.so"
            told = subprocess.run(["readelf", "-d", self.full("runtime", f"{library}.{VERSION}")],
                                  check=True, capture_output=True, text=True).stdout
            self.assertIn(f"soname: [libpalpate{name}.so.{soversion()}]", told)
            self.assertEqual(os.readlink(self.full("runtime", f"{library}.{soversion()}")),
                             f"libpalpate{name}.so.{VERSION}")
            self.assertTrue(os.path.islink(self.full("development", library)))

    def test_headers_find_one_another(self):
        headers = [file[len("include/palpate/"):] for file in self.files["development"]
                   if file.startswith("include/")]
        names = {os.path.basename(header) for header in headers}
        ours = our_headers()
        for header in headers:
            with open(self.full("development", f"include/palpate/{header}"), encoding="utf-8") as file:
                included = re.findall(r'^#include [<"]([^">]+)[">]', file.read(), re.MULTILINE)
            ours_included = {name for name in included if os.path.basename(name) in ours}
            self.assertLessEqual(ours_included, set(headers), f"{header} includes what is not installed")
        self.assertLessEqual({"ToolContact.h", "palpate.h", "vtkContactTool.h"}, names)

    def test_run_paths_lead_into_the_installation(self):
        for path in self.every_file():
            if os.path.islink(path) or not is_elf(path):
                continue
            told = subprocess.run(["readelf", "-d", path], check=True, capture_output=True, text=True).stdout
            for paths in re.findall(r"R(?:UN)?PATH\)\s+Library r(?:un)?path: \[([^\]]*)\]", told):
                for place in paths.split(":"):
                    self.assertTrue(place.startswith("$ORIGIN"), f"{path}: {place}")

    def test_no_path_of_this_machine_in_texts(self):
        for path in self.every_file():
            if path.endswith((".cmake", ".h", ".txt", ".xml", ".py", ".pyi", ".desktop")):
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                self.assertNotIn(SOURCE, text, path)
                self.assertNotIn(BUILD, text, path)

    def test_the_plugin_loads_by_itself(self):
        for file in self.files["plugin"]:
            if file.endswith(".xml"):
                plugins = xml.etree.ElementTree.parse(self.full("plugin", file)).getroot()
                self.assertEqual([(plugin.get("name"), plugin.get("auto_load")) for plugin in plugins],
                                 [("Palpate", "1")])


if __name__ == "__main__":
    unittest.main()
