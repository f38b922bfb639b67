#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of the plugin, from its XML files: menus, labels, help, the properties shown first, the names in saved
states, and the names of the properties in messages."""
import csv
import re
import unittest
import xml.etree.ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MENUS = {"Palpate", "Palpate Bodies", "Palpate Response", "Palpate Measure", "Palpate Show"}
SIX_CLICKS = {"ToolContactResponse", "ToolTouch"}       # the filters of the manual's six clicks
MOST_SHOWN = 9                                          # largest number of properties of a panel without Advanced
RESPONSE_SHOWN = {"LengthUnit", "Tool", "Material", "YoungsModulus", "PoissonRatio", "LayerThickness", "WholeBody",
                  "MaximumDeflection"}
OF_ONE_PANEL = {"Input", "Resolution", "Shape", "Reach"}  # these names mean different things on different panels
OLD_LABELS = {"Least Law That Keeps Forces", "Term Tolerance", "Conform", "Growth", "Labels", "Share", "Snap", "Coarser",
              "Store Without", "Base Value", "Memory", "Limit", "Granted"}


def proxies():
    """(group, element) of each proxy with a panel."""
    for file in sorted((ROOT / "Plugin/ParaView/ServerManager").glob("*.xml")):
        for group in xml.etree.ElementTree.parse(file).getroot():
            if group.get("name") != "representations":
                for proxy in group:
                    yield group.get("name"), proxy


def properties(proxy):
    return [each for each in proxy if each.tag.endswith("Property") and each.get("name")]


def label_of(element):
    return element.get("label") or re.sub("(?<=[a-z])(?=[A-Z])", " ", element.get("name"))


def words_of(element):
    """The label without its unit."""
    return re.sub(r" \([^)]*\)$", "", label_of(element))


def is_setting(element):
    return element.tag != "InputProperty" or element.get("panel_visibility")


def help_of(element):
    return " ".join((element.findtext("Documentation") or "").split())


class Menus(unittest.TestCase):
    def test_each_filter_is_in_one_of_the_submenus(self):
        found = {}
        for group, proxy in proxies():
            menus = [each.get("category") for each in proxy.iterfind("Hints/ShowInMenu")]
            if group == "filters":
                self.assertEqual(len(menus), 1, proxy.get("name"))
                found.setdefault(menus[0], set()).add(proxy.get("name"))
        self.assertEqual(found.keys(), MENUS)

        # ParaView sorts menus, and the filters in a menu, by name.
        self.assertEqual(min(found), "Palpate")
        self.assertEqual(found["Palpate"], SIX_CLICKS)
        self.assertLessEqual(max(map(len, found.values())), 8, found)


class Panels(unittest.TestCase):
    def test_a_panel_shows_few_properties(self):
        for _, proxy in proxies():
            if proxy.get("name") == "ContactTool":      # the panel shows only the properties of the chosen shape
                continue
            shown = [each.get("name") for each in properties(proxy)
                     if is_setting(each) and each.get("panel_visibility", "default") == "default"]
            self.assertLessEqual(len(shown), MOST_SHOWN, (proxy.get("name"), shown))
            if proxy.get("name") == "ToolContactResponse":
                self.assertEqual(set(shown), RESPONSE_SHOWN)

    def test_a_name_has_one_label(self):
        labels = {}
        for _, proxy in proxies():
            for each in properties(proxy):
                labels.setdefault(each.get("name"), set()).add(label_of(each))
        for name, found in labels.items():
            if name not in OF_ONE_PANEL:
                self.assertEqual(len(found), 1, (name, found))
        self.assertFalse(OLD_LABELS & set().union(*labels.values()))

    def test_the_dock_has_labels_that_explain_themselves(self):
        form = (ROOT / "Plugin/ParaView/Panel/LiveTouchForm.cxx").read_text(encoding="utf-8")
        labels = set(re.findall(r'addRow\("([^"]+)"', form))
        self.assertLess({"Force", "Largest force", "Real-time priority"}, labels)
        self.assertFalse(OLD_LABELS & labels)

    def test_the_help_says_what_a_default_of_zero_does(self):
        checked = 0
        for _, proxy in proxies():
            for each in properties(proxy):
                usual = each.get("default_values")
                if each.tag == "StringVectorProperty" or usual not in ("0", "-1") or \
                        each.find("BooleanDomain") is not None or each.find("EnumerationDomain") is not None:
                    continue
                checked += 1
                self.assertRegex(help_of(each), r"(^|[ (;])%s(:| for | with )" % re.escape(usual),
                                 (proxy.get("name"), each.get("name")))
        self.assertGreater(checked, 20)

    def test_the_help_names_no_property_by_an_old_label(self):
        for _, proxy in proxies():
            for each in proxy.iter("Documentation"):
                text = " ".join(each.text.split())
                for old in ("Least Law", "Term Tolerance", "Source Spacing", "Store Without"):
                    self.assertNotIn(old, text, proxy.get("name"))


class SavedStates(unittest.TestCase):
    """StateNames.csv lists the names with which states have been saved. A state with an unknown property loses this
    property."""

    def test_their_names_are_known(self):
        known = {(group, proxy.get("name"), each.get("name")) for group, proxy in proxies() for each in properties(proxy)}
        with open(ROOT / "Testing/ParaView/StateNames.csv", encoding="utf-8") as file:
            saved = {(row["group"], row["proxy"], row["property"]) for row in csv.DictReader(file)}
        self.assertGreater(len(saved), 250)
        self.assertFalse(saved - known)


class Messages(unittest.TestCase):
    """A message names a property by its label in the panel. The name in C++ may follow in brackets."""

    def test_messages_name_properties_in_words(self):
        names = {each.get("name") for _, proxy in proxies() for each in properties(proxy) if each.get("command")}
        names = {name for name in names if re.search("[a-z][A-Z]", name)}
        messages = 0
        for folder in ("Filters", "Plugin/ParaView/ServerManager"):
            for file in sorted((ROOT / folder).rglob("*.cxx")):
                for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                    if line.lstrip().startswith(("//", "*", "#include")) or "<< indent" in line:
                        continue
                    for text in re.findall(r'"((?:[^"\\]|\\.)*)"', line):
                        messages += " must " in text
                        bare = re.sub(r"\([A-Za-z]+\)", "", text)
                        self.assertNotRegex(text, r"\b(call|see) (Set|Add)[A-Z]", (file, number))
                        if text in names or re.fullmatch(r"\w+", text):
                            continue                        # the name of an array or of a property alone
                        for name in names:
                            self.assertNotRegex(bare, r"\b%s\b" % name, (file, number, text))
        self.assertGreater(messages, 50)

    def test_messages_name_filters_as_the_menus_do(self):
        classes = {proxy.get("class").replace("vtkPV", "vtk") for group, proxy in proxies() if group == "filters"}
        self.assertGreater(len(classes), 20)
        for file in sorted((ROOT / "Filters").rglob("*.cxx")):
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                if line.lstrip().startswith(("//", "*", "#include")):
                    continue
                for text in re.findall(r'"((?:[^"\\]|\\.)*)"', line):
                    bare = re.sub(r"\(vtk\w+\)", "", text)
                    self.assertFalse(classes & set(re.findall(r"\bvtk\w+", bare)), (file, number, text))

    def test_a_name_in_brackets_follows_its_label(self):
        labels = {}
        for _, proxy in proxies():
            for each in properties(proxy):
                labels.setdefault(each.get("name"), set()).add(words_of(each))
        checked = 0
        for file in sorted((ROOT / "Filters").rglob("*.cxx")):
            for label, name in re.findall(r'"([A-Z][A-Za-z\' ]+) \(([A-Z][A-Za-z]+)\)(?: must|")',
                                          file.read_text(encoding="utf-8")):
                if name in labels:
                    checked += 1
                    self.assertIn(label, labels[name], (file, name))
        self.assertGreater(checked, 8)


if __name__ == "__main__":
    unittest.main()
