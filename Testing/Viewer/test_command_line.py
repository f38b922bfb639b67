# SPDX-License-Identifier: BSD-3-Clause
"""The help of the command line, and its messages for invalid arguments."""
import re
import unittest

from session import SessionCase, run

OPTIONS = ("--help", "--version", "--scene", "--scan", "--tool", "--young", "--poisson", "--depth",
           "--max-deflection", "--length-unit", "--resolution", "--contour", "--closing", "--site",
           "--slide-to", "--rate", "--output", "--save", "--export", "--window", "--screenshot",
           "--voxel", "--solid", "--tissue", "--fixed", "--layer", "--layers", "--base", "--measured", "--register", "--reach",
           "--max-strain",
           "--friction", "--friction-model", "--tangential-stiffness", "--force-form",
           "--contact-surface", "--device", "--hand", "--list-devices", "--record", "--scale", "--trial",
           "--rounds", "--seed", "--question", "--log", "--compare", "--map", "--auto", "--no-auto",
           "--pictures", "--no-pictures", "--no-whole-body", "--tolerance", "--strain", "--error-tolerance", "--curvature",
           "--no-curvature", "--edges", "--tilt", "--relax", "--relaxation-elements", "--verbose")
NUMBERS = ("--young", "--poisson", "--depth", "--max-deflection", "--length-unit", "--resolution",
           "--contour", "--closing", "--rate", "--voxel", "--layer", "--base", "--reach", "--max-strain",
           "--friction", "--tangential-stiffness", "--scale", "--tolerance", "--error-tolerance",
           "--relaxation-elements", "--tilt")


class CommandLine(SessionCase):
    def test_help_names_every_option_unit_and_example(self):
        result = run("--help")
        self.assertEqual(result.returncode, 0)
        for word in (*OPTIONS, "BODY", "Units: mm, N, MPa, s", "sphere:R", "flat:R", "cone:DEGREES",
                     "truncated:R,DEGREES", "blunted:R,DEGREES", "rounded:R,EDGE",
                     "power:EXPONENT,COEFFICIENT", "profile:FILE.csv",
                     ".vtp", ".stl", ".nii.gz", "Examples:", "palpate --scene cylinder",
                     "palpate --compare", "palpate --map",
                     "liver.stl --tool sphere:6.35 --young 0.05 --poisson 0.45",
                     "phantom.obj --length-unit m --site 0,0,1 --slide-to 0.3,0,1 --depth 1.5"):
            self.assertIn(word, result.stdout)

    def test_help_lists_no_option_unknown_to_this_test(self):
        self.assertEqual(set(re.findall(r"--[a-z-]+", run("--help").stdout)), set(OPTIONS))

    def test_version(self):
        result = run("--version")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"^\d+\.\d+\.\d+\n$")

    def test_help_and_version_need_no_display(self):
        for option in ("--help", "--version"):
            self.assertEqual(run(option, environment={"DISPLAY": None}).returncode, 0)

    def test_what_makes_no_sense_is_named(self):
        for arguments, word in (
                (("--tool", "spere:3"), "spere"),
                (("--tool", "sphere:-3"), "-3"),
                (("--tool", "sphere:0"), "sphere:0"),
                (("--tool", "sphere"), "sphere"),
                (("--tool", "sphere:3mm"), "3mm"),
                (("--tool", "cone:90"), "90"),
                (("--tool", "rounded:1,-2"), "edge radius"),
                (("--tool", "power:0.5,1"), "exponent"),
                (("--tool", "truncated:1"), "two numbers"),
                (("--tool", "profile:nowhere.csv"), "nowhere.csv"),
                (("--tool", "flat:nan"), "nan"),
                (("--young", "0"), "--young"),
                (("--young", "-1"), "--young"),
                (("--young", "soft"), "--young"),
                (("--poisson", "0.6"), "--poisson"),
                (("--poisson", "-0.1"), "--poisson"),
                (("--depth", "-1"), "--depth"),
                (("--max-deflection", "0"), "--max-deflection"),
                (("--length-unit", "furlong"), "furlong"),
                (("--length-unit", "0"), "--length-unit"),
                (("--length-unit", "-2.5"), "--length-unit"),
                (("--resolution", "-1"), "--resolution"),
                (("--closing", "-1"), "--closing"),
                (("--rate", "0"), "--rate"),
                (("--voxel", "0"), "--voxel"),
                (("--solid", "0"), "--solid"),
                (("--solid", "2mm"), "2mm"),
                (("--solid", "2", "--voxel", "2"), "--voxel"),
                (("--solid", "--layer", "5"), "--solid"),
                (("--strain", "finite"), "finite"),
                (("--strain", "ogden"), "exponent"),
                (("--strain", "ogden:0"), "Ogden's exponent"),
                (("--strain", "demiray:-1"), "Demiray's coefficient"),
                (("--strain", "neo-hooke:2"), "has no exponent"),
                (("--error-tolerance", "-0.1"), "-0.1"),
                (("--relax", ""), "no relaxation"),
                (("--relax", "0.5"), "'0.5' is not a relaxation"),
                (("--relax", "0.5:0.1,-0.3:2"), "the strength of relaxation 2"),
                (("--relax", "0.5:0"), "the time of relaxation 1"),
                (("--relax", "1:1,1:2,1:3,1:4,1:5"), "more than 4"),
                (("--relax", "0.5:0.1", "--measured", "x.csv"), "--measured"),
                (("--relaxation-elements", "33"), "--relaxation-elements"),
                (("--relaxation-elements", "-1"), "--relaxation-elements"),
                (("--layer", "0"), "--layer"),
                (("--layer", "-3"), "-3"),
                (("--layer", "5mm"), "5mm"),
                (("--layer", "thick"), "thick"),
                (("--layer", ""), "--layer"),
                (("--layer", "scan"), "no scan"),
                (("--layer", "5", "--voxel", "2"), "--voxel"),
                (("--layers", ""), "MM:MPA:NU"),
                (("--layers", "1.5:0.2"), "layer 1: '1.5:0.2' is not MM:MPA:NU"),
                (("--layers", "1:1:0.4,x:1:0.4"), "layer 2: 'x' is not a number"),
                (("--layers", "1:0:0.4"), "layer 1: 0 is not positive; a modulus"),
                (("--layers", "-1:1:0.4"), "layer 1: -1"),
                (("--layers", "1:1:0.4,2:1:0.6"), "layer 2: 0.6 does not lie between 0 and 0.5"),
                (("--layers", "1:1:nan"), "layer 1: nan is not finite"),
                (("--layers", "0:1:0.4,1:1:0.4"), "layer 1: only the last can be 0 mm thick"),
                (("--layers", "0:1:0.4"), "a half-space alone is not a stack"),
                (("--layers", "1:1:0.4:slip"), "layer 1: there is no layer above"),
                (("--layers", "1:1:0.4:glued"), "'1:1:0.4:glued' is not MM:MPA:NU"),
                (("--layers", "1:1:0.4,0:1:0.4,slip"), "slip at the end belongs to a rigid base"),
                (("--layers", "1:1:.4,1:1:.4,1:1:.4,1:1:.4,1:1:.4"), "5 layers are too many"),
                (("--layers", "scan:1:0.4,0:1:0.4"), "scan stands for the thickness of one of two"),
                (("--layers", "1:1:0.4", "--voxel", "2"), "--voxel"),
                (("--voxel", "2", "--fixed", "q+"), "q+"),
                (("--fixed", "z-"), "--voxel"),
                (("--friction", "-0.1"), "--friction"),
                (("--friction-model", "glue"), "glue"),
                (("--friction-model", "0"), "--friction-model"),
                (("--tangential-stiffness", "0"), "--tangential-stiffness"),
                (("--force-form", "strong"), "strong"),
                (("--contact-surface", "rough"), "rough"),
                (("--scale", "0"), "--scale"),
                (("--device", "joystick"), "joystick"),
                (("--scene", "moon"), "moon"),
                (("--site", "0,0"), "--site"),
                (("--no-auto=" + 40 * "4",), "no-auto"),
                (("--no-auto=maybe",), "no-auto"),
                (("--window=maybe",), "maybe"),
                (("--colour", "red"), "--colour"),
                (("one.stl", "two.stl"), "two.stl"),
                (("--young",), "--young")):
            with self.subTest(arguments=arguments):
                self.refuse("--scene", "cylinder", *arguments, words=(word,))

    def test_a_refused_number_is_told_in_one_readable_line(self):
        self.assertEqual(run("--young", "0").stderr.splitlines()[0],
                         "--young: 0 is not positive; a modulus in MPa, e.g. 0.05")
        for option in (*NUMBERS, "--site", "--slide-to", "--rounds", "--seed"):
            trial = ("--trial", "sphere:1,flat:1") if option in ("--rounds", "--seed") else ()
            three = ",0,1" if option in ("--site", "--slide-to") else ""
            for value in ("0", "-1", "1e400", "nan", "inf", "soft", "", "7" * 400):
                with self.subTest(option=option, value=value):
                    # A valid value is followed by an invalid word, so the error must name that
                    # word.
                    result = run("--scene", "cylinder", *trial, f"{option}={value}{three}", "--colour")
                    first = result.stderr.splitlines()[0]
                    self.assertGreater(result.returncode, 0)
                    self.assertLess(len(first), 140, first)
                    if value in ("1e400", "nan", "inf", "soft", "7" * 400):
                        self.assertTrue(first.startswith(option + ": "), first)
                    else:
                        self.assertRegex(first, "^(--[a-z-]+: |The following argument was not expected: --colour)")

    def test_a_number_in_a_trial_is_refused_likewise(self):
        for setting, words in (("young=0", "0 is not positive; a modulus in MPa"),
                               ("poisson=0.6", "0.6 does not lie between 0 and 0.5"),
                               ("layer=-1", "-1 is not positive; a thickness in mm"),
                               ("friction=soft", "'soft' is not a number"),
                               ("friction-model=glue", "'glue' is none of dahl"),
                               ("colour=red", "there is no such setting, but there are contact-surface")):
            with self.subTest(setting=setting):
                self.refuse("--scene", "cylinder", "--trial", "friction=0," + setting,
                            words=(f"--trial: {setting}: {words}",))


if __name__ == "__main__":
    unittest.main()
