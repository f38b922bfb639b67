# SPDX-License-Identifier: BSD-3-Clause
"""ParaView, Python, C++ and the program have the same defaults and the same words. Each is read from its own source:
the plugin's XML files, the signatures of the package, the getters of the classes, and the help and the summary of the
program.

Defaults that differ intentionally are excluded: the material of the built-in scenes, and whether the deflection of the
whole body is included.
"""
import inspect
import re
import unittest
import xml.etree.ElementTree
from pathlib import Path

import numpy
import palpate
from bodies import sphere, write
from palpate import _probe, _response, _words
from session import SessionCase, peak_force, run

SERVER_MANAGER = Path(__file__).resolve().parents[2] / "Plugin/ParaView/ServerManager"

# A setting of a response: property, argument of palpate.response, option of the program.
RESPONSE = (
    ("YoungsModulus", "young", None), ("PoissonRatio", "poisson", None), ("LayerThickness", "layer", None),
    ("MaximumDeflection", "maximum_deflection", "max-deflection"), ("NumberOfSamples", "samples", None),
    ("ErrorTolerance", "error_tolerance", "error-tolerance"), ("CurvatureCorrection", "curvature", "curvature"),
    ("EdgeCorrection", "edges", "edges"), ("MaximumTilt", "tilt", "tilt"), ("Coupling", "coupling", None),
    ("ComplianceExcludesLayer", "compliance_excludes_layer", None), ("ComplianceRelaxes", "compliance_relaxes", None),
    ("LayerBase", "base", None), ("StrainModel", "strain", "strain"), ("ResponseName", "name", None))
PROBE = (
    ("FrictionCoefficient", "friction", "friction"), ("FrictionModel", "friction_model", "friction-model"),
    ("TangentialStiffness", "tangential_stiffness", "tangential-stiffness"),
    ("FrictionBreakaway", "friction_breakaway", None), ("FrictionStickRadius", "friction_stick_radius", None),
    ("PoissonRatio", "poisson", None), ("ForceForm", "force_form", "force-form"),
    ("ContactSurface", "surface", "contact-surface"), ("RelaxationElements", "relaxation_elements", "relaxation-elements"),
    ("Indentation", "indentation", None), ("Coupled", "coupled", None), ("ResponseName", "name", None))
# Settings of other filters: property, getter of the class, option.
SKIN = (("ContourValue", "contour"), ("ClosingRadius", "closing"), ("Resolution", "resolution"))


def proxy(name):
    for file in SERVER_MANAGER.glob("*.xml"):
        for element in xml.etree.ElementTree.parse(file).iter():
            if element.tag in ("SourceProxy", "Proxy") and element.get("name") == name and element.get("class"):
                return element
    raise KeyError(name)


def property_of(name, setting):
    return next(each for each in proxy(name) if each.get("name") == setting)


def words_of(element):
    """Value -> word of an enumeration as the program writes it; empty for a number."""
    entries = element.findall("EnumerationDomain/Entry")
    words = {int(entry.get("value")): entry.get("text").lower().replace(" ", "-") for entry in entries}
    return ["small" if words[i] == "small-strain" else words[i] for i in range(len(words))]


def default_of(element):
    """The default in ParaView: a number, a word or a text."""
    text = element.get("default_values")
    words = words_of(element)
    if words:
        return words[int(text)]
    return text if element.tag == "StringVectorProperty" else float(text)


def argument(function, name):
    value = inspect.signature(function).parameters[name].default
    value = 0.0 if value is None else value             # no layer
    return value if isinstance(value, str) else float(value)


class Help:
    def __init__(self):
        self.text = run("--help").stdout

    def default(self, option):
        """The default of `--option KIND=DEFAULT`. A flag is off, or has its default in its text."""
        head = re.search(r"^  --%s[, ].*$(?:\n {10,}.*)?" % option, self.text, re.MULTILINE).group(0)
        found = re.search(r"--%s [^=\n]*=(\S+)" % option, head)
        if found:
            return found.group(1)
        return float("(default; --no-" in head)

    def words(self, option):
        return set(re.search(r"--%s \S*\{([^}]*)\}" % option, self.text).group(1).split(","))


class Defaults(SessionCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.help = Help()

    def compare(self, name, made, function, rows):
        for setting, keyword, option in rows:
            with self.subTest(setting=setting):
                element = property_of(name, setting)
                usual = default_of(element)
                self.assertEqual(argument(function, keyword), usual)
                given = getattr(made, "Get" + setting)()
                self.assertEqual(words_of(element)[given] if words_of(element) else given, usual)
                if option:
                    said = self.help.default(option)
                    self.assertEqual(said if isinstance(usual, str) else float(said), usual)

    def test_of_a_response(self):
        self.compare("ToolContactResponse", palpate.vtkToolContactResponse(), palpate.response, RESPONSE)

    def test_of_a_probe(self):
        self.compare("ToolContactProbe", palpate.vtkToolContactProbe(), palpate.probe, PROBE)

    def test_of_the_tool(self):
        shape = default_of(property_of("ContactTool", "Shape"))
        radius = default_of(property_of("ContactTool", "Radius"))
        usual = "%s:%g" % (shape, radius)
        self.assertEqual(palpate.vtkContactTool().GetSpecification(), usual)
        self.assertEqual(argument(palpate.response, "tool"), usual)
        self.assertEqual(argument(palpate.measured, "tool"), usual)
        self.assertIn("for BODY %s by default" % usual, self.help.text)

    def test_of_every_material(self):
        young = default_of(property_of("ToolContactResponse", "YoungsModulus"))
        poisson = default_of(property_of("ToolContactResponse", "PoissonRatio"))
        moduli = 0
        for file in SERVER_MANAGER.glob("*.xml"):
            for element in xml.etree.ElementTree.parse(file).iter("DoubleVectorProperty"):
                if element.get("name") == "YoungsModulus":
                    moduli += 1
                    self.assertEqual(default_of(element), young, file.name)
        self.assertGreater(moduli, 5)
        self.assertEqual(argument(palpate.regime, "young"), young)
        self.assertIn("MPa (for BODY %g by default)" % young, self.help.text)
        self.assertIn("(for BODY %g by default)" % poisson, self.help.text)

    def test_of_a_file_in_the_program(self):
        """The behaviour agrees with the help, also for the default depth of half of the range, which is Indentation 0
        in ParaView."""
        body = write(sphere(), self.folder / "body.vtp")
        result = run(body, "--no-pictures", "--output", self.output)
        self.assertEqual(result.returncode, 0, result.stderr)
        young = default_of(property_of("ToolContactResponse", "YoungsModulus"))
        poisson = default_of(property_of("ToolContactResponse", "PoissonRatio"))
        self.assertIn("E = %g MPa, nu = %g" % (young, poisson), result.stdout)
        self.assertRegex(result.stdout, r"tools +%s;?" % palpate.vtkContactTool().GetSpecification())
        depth = float(re.search(r"deflection ([\d.]+) mm", result.stdout).group(1))
        self.assertAlmostEqual(depth, 0.5 * float(self.help.default("max-deflection")), delta=0.01)

    def test_of_the_others(self):
        for setting, option in SKIN:
            usual = default_of(property_of("SkinSurface", setting))
            self.assertEqual(getattr(palpate.vtkSkinSurface(), "Get" + setting)(), usual)
            self.assertEqual(float(self.help.default(option)), usual)
        for name, setting, option in (("LayerThickness", "BaseValue", "base"), ("GradedBody", "FixedFaces", "fixed"),
                                      ("VoxelBody", "FixedFaces", "fixed"), ("MeasuredContactResponse", "Reach", "reach"),
                                      ("MeasuredContactResponse", "MaximumStrain", "max-strain"),
                                      ("ResponseChoice", "Tolerance", "tolerance"),
                                      ("ToolContactResponse", "TermTolerance", "tolerance")):
            with self.subTest(setting=setting):
                usual = default_of(property_of(name, setting))
                made = getattr(palpate, "vtk" + name)()
                self.assertEqual(getattr(made, "Get" + setting)(), usual)
                said = self.help.default(option)
                self.assertEqual(said if isinstance(usual, str) else float(said), usual)
        for keyword, setting in (("reach", "Reach"), ("maximum_strain", "MaximumStrain"), ("poisson", "PoissonRatio"),
                                 ("maximum_deflection", "MaximumDeflection"), ("samples", "NumberOfSamples")):
            self.assertEqual(argument(palpate.measured, keyword),
                             default_of(property_of("MeasuredContactResponse", setting)))


class Words(SessionCase):
    def test_are_the_same(self):
        said = Help()
        for setting, keyword, option in (("FrictionModel", "friction_model", "friction-model"),
                                         ("ForceForm", "force_form", "force-form"),
                                         ("ContactSurface", "surface", "contact-surface")):
            words = words_of(property_of("ToolContactProbe", setting))
            self.assertEqual(_probe.CHOICES[keyword], dict(zip(words, range(len(words)))))
            self.assertEqual(said.words(option), set(words))
        words = words_of(property_of("ToolContactResponse", "StrainModel"))
        self.assertEqual(_response.STRAINS, dict(zip(words, range(len(words)))))
        for word in words:
            self.assertIn(word, re.search(r"law of the body at large strain:.*", said.text).group(0))
        bases = words_of(property_of("ToolContactResponse", "LayerBase"))
        self.assertEqual(_response.BASES, {word: bases.index(word) for word in ("bonded", "slip")})

    def test_older_words_are_read(self):
        plate = (numpy.array([[x, y, 0.0] for x in (-20, 20) for y in (-20, 20)]), [[0, 2, 1], [1, 2, 3]])
        strained = [palpate.curves(palpate.response(plate, strain=word, compliance=None)).force
                    for word in ("neo-hooke", "neohooke")]
        numpy.testing.assert_array_equal(*strained)
        body, tips = palpate.response(plate, compliance=None), [[0, 0, 0], [0.1, 0, -0.5], [0.3, 0, -0.5]]
        for older, present in _words.OLDER.items():
            for keyword, choices in _probe.CHOICES.items():
                if present in choices:
                    forces = [palpate.probe(body, tips, path=True, friction=0.3, **{keyword: word}).forces
                              for word in (older, present)]
                    numpy.testing.assert_array_equal(*forces)
        file = write(sphere(), self.folder / "body.vtp")
        for option, older, present in (("--force-form", "energy", "energy-consistent"),
                                       ("--force-form", "normalized", "normalized-direction"),
                                       ("--friction-model", "shape", "shape-derived"),
                                       ("--strain", "neohooke", "neo-hooke")):
            with self.subTest(word=older):
                results = [run(file, option, word, "--friction", "0.3", "--no-pictures", "--output", self.output)
                           for word in (older, present)]
                for result in results:
                    self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(*map(peak_force, results))

    def test_a_wrong_word_is_answered_with_the_present_ones(self):
        self.refuse(self.folder / "none.vtp", "--force-form", "strong", words=("strong", "energy-consistent"))
        with self.assertRaisesRegex(ValueError, "force_form must be one of .*'energy-consistent', but is 'strong'"):
            palpate.probe(palpate.response(([[0, 0, 0], [9, 0, 0], [0, 9, 0]], [[0, 1, 2]]), compliance=None),
                          [0, 0, 0], force_form="strong")


if __name__ == "__main__":
    unittest.main()
