#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""vtkContactSettings in Python, and the properties in ParaView against its table."""
import glob
import inspect
import math
import os
import re
import unittest
import xml.etree.ElementTree

import palpate
from palpate import vtkContactSettings, vtkHapticSession, vtkToolContactProbe, vtkToolTouch
from vtkmodules.vtkCommonDataModel import vtkTable

SERVER_MANAGER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin", "ParaView",
                              "ServerManager")


def table():
    """One dictionary per setting."""
    filled = vtkTable()
    vtkContactSettings.GetTable(filled)
    names = [filled.GetColumnName(i) for i in range(filled.GetNumberOfColumns())]
    return [{name: filled.GetColumnByName(name).GetValue(row) for name in names}
            for row in range(filled.GetNumberOfRows())]


def is_whole(row):
    return isinstance(getattr(vtkContactSettings(), "Get" + row["Name"])(), int)


def in_words(name):
    return "Poisson's Ratio" if name == "PoissonRatio" else re.sub("(?<=[a-z])(?=[A-Z])", " ", name)


class Settings(unittest.TestCase):
    def test_defaults_are_those_of_the_table(self):
        settings = vtkContactSettings()
        self.assertEqual(settings.GetFault(), "")
        self.assertEqual(len(table()), 9)
        for row in table():
            self.assertEqual(getattr(settings, "Get" + row["Name"])(), row["Default"], row["Name"])

    def test_each_setting_is_a_property_of_whoever_feels(self):
        for kind in (vtkContactSettings, vtkToolContactProbe):
            for row in table():
                felt = kind()
                value = 0 if row["Values"] else row["Default"] + (1 if is_whole(row) else 0.125)
                value = int(value) if is_whole(row) else value
                getattr(felt, "Set" + row["Name"])(value)
                self.assertEqual(getattr(felt, "Get" + row["Name"])(), value, (kind, row["Name"]))

    def test_what_is_out_of_range_is_told_in_words(self):
        for row in table():
            name, least, most = row["Name"], row["Minimum"], row["Maximum"]
            number = int if is_whole(row) else float
            for value in [least - 1] + [most + 1] * math.isfinite(most) + [least] * (not row["IncludesMinimum"]):
                settings = vtkContactSettings()
                getattr(settings, "Set" + name)(number(value))
                self.assertRegex(settings.GetFault(), "^" + in_words(name) + " must .*, but is %g$" % value)

    def test_help_gives_the_range(self):
        for row in table():
            if not row["Values"]:
                least, most = row["Minimum"], row["Maximum"]
                said = "%g to %g" % (least, most) if math.isfinite(most) else \
                    ("at least %g" if row["IncludesMinimum"] else "above %g") % least
                self.assertIn(said, row["Help"], row["Name"])
                self.assertIn(row["Unit"], row["Help"], row["Name"])

    def test_several_share_one(self):
        probe, session, touch = vtkToolContactProbe(), vtkHapticSession(), vtkToolTouch()
        session.SetSettings(probe.GetSettings())
        touch.SetSettings(probe.GetSettings())
        before = session.GetMTime(), touch.GetMTime()
        session.GetSettings().SetFrictionCoefficient(0.3)
        self.assertEqual(probe.GetFrictionCoefficient(), 0.3)
        self.assertEqual(touch.GetSettings().GetFrictionCoefficient(), 0.3)
        self.assertGreater(session.GetMTime(), before[0])
        self.assertGreater(touch.GetMTime(), before[1])
        self.assertIs(touch.GetSettings(), probe.GetSettings())


class ParaView(unittest.TestCase):
    """ParaView's properties are written by hand. Their data of a setting must agree with the table."""

    def setUp(self):
        tree = xml.etree.ElementTree.parse(os.path.join(SERVER_MANAGER, "Probe.xml"))
        proxy = tree.find(".//SourceProxy[@name='ToolContactProbe']")
        self.properties = {each.get("name"): each for each in proxy if each.get("command")}

    def test_names_units_and_defaults(self):
        for row in table():
            with self.subTest(setting=row["Name"]):
                shown = self.properties[row["Name"]]
                self.assertEqual(shown.get("command"), "Set" + row["Name"])
                self.assertEqual(float(shown.get("default_values")), row["Default"])
                label = shown.get("label").replace("'s", "").replace(" ", "")
                self.assertEqual(label, row["Name"] + ("(%s)" % row["Unit"] if row["Unit"] else ""))

    def test_ranges(self):
        for row in table():
            with self.subTest(setting=row["Name"]):
                shown = self.properties[row["Name"]]
                if row["Values"]:
                    entries = {int(entry.get("value")): entry.get("text") for entry in shown.find("EnumerationDomain")}
                    said = [entries[i].replace("-", "").replace(" ", "").lower() for i in range(len(entries))]
                    self.assertEqual(said, row["Values"].lower().split())
                else:
                    domain = shown.find("IntRangeDomain" if is_whole(row) else "DoubleRangeDomain")
                    self.assertEqual(float(domain.get("min")), row["Minimum"])
                    self.assertEqual(float(domain.get("max", "inf")), row["Maximum"])

    def test_help(self):
        for row in table():
            with self.subTest(setting=row["Name"]):
                said = " ".join(self.properties[row["Name"]].find("Documentation").text.split())
                begins = row["Help"][0].upper() + row["Help"][1:] + "."
                self.assertEqual(said[:len(begins)], begins)


class Responses(unittest.TestCase):
    """Settings of the response filters are the same in all filters that have them, in Python and in ParaView."""

    # The property, and the keyword of palpate.response if its value is a number or a switch.
    SHARED = {"YoungsModulus": "young", "PoissonRatio": "poisson", "LayerThickness": None, "LayerBase": None,
              "ComplianceExcludesLayer": "compliance_excludes_layer", "BaseYoungsModulus": None,
              "BasePoissonRatio": None, "CurvatureCorrection": "curvature", "EdgeCorrection": "edges",
              "MaximumTilt": "tilt", "Coupling": "coupling", "ComplianceRelaxes": "compliance_relaxes",
              "StrainModel": None, "OgdenExponent": None, "DemirayExponent": None, "ErrorTolerance": "error_tolerance",
              "StoreError": None, "AutomaticTerms": None, "TermTolerance": None, "MaximumDeflection": "maximum_deflection",
              "NumberOfSamples": "samples", "ResponseName": "name"}
    # A build may lack the modules of solids and of measured curves.
    KINDS = [getattr(palpate, "vtk" + name) for name in
             ("ToolContactResponse", "ElasticContactResponse", "DirectContactResponse", "MeasuredContactResponse",
              "ContactRegime", "ContactSetup") if hasattr(palpate, "vtk" + name)]

    @staticmethod
    def has(kind, name):
        # vtkContactSetup has one response name per tool
        return hasattr(kind, "Get" + name) and (kind, name) != (palpate.vtkContactSetup, "ResponseName")

    def test_defaults_of_filters_and_setup(self):
        for name in self.SHARED:
            values = {kind.__name__: getattr(kind(), "Get" + name)() for kind in self.KINDS if self.has(kind, name)}
            self.assertIn("vtkToolContactResponse", values, name)
            self.assertEqual(len(set(values.values())), 1, (name, values))

    def test_each_is_set_and_changes_the_modification_time(self):
        for kind in self.KINDS:
            for name in self.SHARED:
                if self.has(kind, name):
                    changed = kind()
                    value, before = getattr(changed, "Get" + name)(), changed.GetMTime()
                    value = "Other" if isinstance(value, str) else type(value)(value + 1) if not isinstance(value, bool) else not value
                    getattr(changed, "Set" + name)(value)
                    self.assertEqual(getattr(changed, "Get" + name)(), value, (kind, name))
                    self.assertGreater(changed.GetMTime(), before, (kind, name))
                    self.assertIn("%s: %s" % (name, "%g" % value if not isinstance(value, str) else value), str(changed))

    def test_keywords_of_python(self):
        usual = palpate.vtkToolContactResponse()
        keywords = inspect.signature(palpate.response).parameters
        for name, keyword in self.SHARED.items():
            if keyword:
                self.assertEqual(keywords[keyword].default, getattr(usual, "Get" + name)(), name)
        for function in (palpate.regime, palpate.measured):
            for keyword, given in inspect.signature(function).parameters.items():
                if keyword in self.SHARED.values():
                    self.assertEqual(given.default, keywords[keyword].default, (function, keyword))

    def test_properties_of_paraview(self):
        found = set()
        for path in glob.glob(os.path.join(SERVER_MANAGER, "*.xml")):
            for proxy in xml.etree.ElementTree.parse(path).iter("SourceProxy"):
                kind = getattr(palpate, (proxy.get("class") or "").replace("vtkPV", "vtk"), None)
                if kind not in self.KINDS:
                    continue
                for shown in proxy:
                    name = (shown.get("command") or "").removeprefix("Set")
                    if name in self.SHARED and shown.get("default_values") is not None:
                        found.add((kind, name))
                        usual = getattr(kind(), "Get" + name)()
                        text = shown.get("default_values")
                        self.assertEqual(text if isinstance(usual, str) else float(text), usual, (proxy.get("name"), name))
        for kind in set(self.KINDS) - {palpate.vtkContactSetup}:
            for name in self.SHARED:
                self.assertTrue(not self.has(kind, name) or (kind, name) in found, (kind, name))


if __name__ == "__main__":
    unittest.main()
