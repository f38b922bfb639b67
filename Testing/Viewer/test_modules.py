# SPDX-License-Identifier: BSD-3-Clause
"""An option whose module is missing, damaged or from another version is refused with a message. Everything else
works."""
import os
import shutil
import unittest
from pathlib import Path

import bodies
import numpy
from session import SessionCase, run

MECHANICS = Path(os.environ.get("PALPATE_MECHANICS", ""))  # the library that loads modules from its folder
COMPARISON = Path(os.environ.get("PALPATE_COMPARISON", ""))  # the viewer's module Comparison
CURVES = Path(os.environ.get("PALPATE_DATA", "")) / "Examples" / "cylinder_sphere_curves.csv"


class Modules(SessionCase):
    def setUp(self):
        super().setUp()
        self.libraries = self.folder / "lib"
        self.libraries.mkdir()
        shutil.copy(MECHANICS, self.libraries / self.soname())
        self.environment = {"LD_LIBRARY_PATH": f"{self.libraries}:{os.environ.get('LD_LIBRARY_PATH', '')}"}
        self.ball = bodies.write(bodies.sphere(), self.folder / "ball.vtp")

    @staticmethod
    def soname():
        """The soname of the library, libpalpateMechanics.so.0.1 for libpalpateMechanics.so.0.1.0."""
        return MECHANICS.name.rsplit(".", 1)[0]

    def test_an_option_without_its_module_is_refused(self):
        for arguments in (("--solid", "5"), ("--voxel", "5"), ("--tissue", "1:0.1:0.4")):
            self.refuse(self.ball, *arguments, environment=self.environment,
                        words=(arguments[0], "module Solids", "libpalpateViewerSolids.so", "./run build"))
        self.refuse("--scene", "phantom", environment=self.environment, words=("--scene phantom", "module Solids"))
        for arguments in (("--compare",), (self.ball, "--map")):
            self.refuse(*arguments, environment=self.environment,
                        words=(arguments[-1], "module Comparison", "libpalpateViewerComparison.so"))
        self.refuse("--scene", "cylinder", "--measured", CURVES, environment=self.environment,
                    words=("--measured", "module Identification", "libpalpateViewerIdentification.so"))
        self.refuse(self.ball, "--trial", "sphere:3,flat:1", environment=self.environment,
                    words=("--trial", "module Trials", "libpalpateViewerTrials.so"))

    def test_a_module_that_needs_another_names_it(self):
        shutil.copy(COMPARISON, self.libraries)
        self.refuse("--compare", environment=self.environment, words=("--compare", "module Solids"))

    def test_tissues_need_the_mesher(self):
        shutil.copy(COMPARISON.parent / "libpalpateViewerSolids.so", self.libraries)
        labels = bodies.write(bodies.image(numpy.ones((4, 4, 4))), self.folder / "labels.vti")
        self.refuse(labels, "--tissue", "1:0.1:0.4", environment=self.environment,
                    words=("No tissue can be filled", "module Mesher", "libpalpateMesher.so"))

    def test_a_device_is_reached_by_its_module_alone(self):
        for device in ("hid:/dev/hidraw0", "bridge:udp:50000"):
            self.refuse(self.ball, "--device", device, environment=self.environment,
                        words=(device, "module Transports", "libpalpateTransports.so", "./run build"))
        listed = run("--list-devices", environment=self.environment)
        self.assertEqual(listed.returncode, 0, listed.stderr)
        self.assertIn("module Transports", listed.stdout)

    def test_finite_strain_is_solved_for_by_its_module_alone(self):
        stored = (self.ball, "--tool", "sphere:3", "--strain", "neo-hooke")
        self.succeed(*stored, environment=self.environment)
        self.refuse(self.ball, "--tool", "sphere:3", "--strain", "ogden:9", environment={**self.environment, "PALPATE_CACHE": ""},
                    words=("Ogden, alpha = 9", "sphere:3", "module Strain", "libpalpateStrain.so", "./run build"))

    def test_all_else_works_without_modules(self):
        self.succeed(self.ball, "--tool", "sphere:3", environment=self.environment)

    def test_a_file_that_is_no_module_is_refused(self):
        module = self.libraries / "libpalpateViewerSolids.so"
        module.write_text("not a library")
        self.refuse(self.ball, "--solid", "5", environment=self.environment, words=("module Solids", module.name))
        shutil.copy(MECHANICS, module)
        self.refuse(self.ball, "--solid", "5", environment=self.environment,
                    words=(module.name, "is not a module of Palpate", "palpateViewerSolidsModule"))


if __name__ == "__main__":
    unittest.main()
