#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Doxygen makes the HTML of ./run docs without a warning, every link in it has a target, and every public header,
class, struct and enumeration has a comment.

    check_warnings.py FOLDER       FOLDER: the output folder

Exit code: 0 no fault, 1 a fault, 77 Doxygen is not installed.
"""
import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree
from html import unescape
from pathlib import Path
from urllib.parse import unquote

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Plugin/Manual/Doxygen"))
import make  # noqa: E402


def dead_links(output):
    """Local files that the HTML names and that are not there. (Search and tree are written by scripts.)"""
    for page in sorted(output.glob("*.html")):
        text = page.read_text(encoding="utf-8", errors="replace")
        for target in set(re.findall(r'(?:href|src)="([^"#?]+)[^"]*"', text)):
            if not re.match(r"[a-z]+:", target) and not (output / unquote(unescape(target))).exists():
                yield "%s: there is no %s" % (page.name, target)


def says_something(element):
    return any("".join(element.find(part).itertext()).strip()
               for part in ("briefdescription", "detaileddescription") if element.find(part) is not None)


def undocumented(output):
    """Public headers, classes, structs and enumerations without a comment, from Doxygen's XML."""
    documented, headers = set(), set()
    for file in sorted((output / "xml").glob("*.xml")):
        if file.name in ("index.xml", "Doxyfile.xml"):
            continue
        compound = ElementTree.parse(file).getroot().find("compounddef")
        if compound is None or compound.get("kind") in ("dir", "page"):
            continue
        name, place = compound.findtext("compoundname"), compound.find("location")
        if place is None or not place.get("file").startswith(("Filters/", "Interactors/")):
            continue
        if compound.get("kind") == "file":
            headers.add(place.get("file"))
        if says_something(compound):
            documented.add(place.get("file"))
        elif compound.get("kind") in ("class", "struct", "union") and compound.get("prot") == "public":
            yield "%s:%s: %s %s has no comment" % (place.get("file"), place.get("line"), compound.get("kind"), name)
        for member in compound.iter("memberdef"):
            where = member.find("location")
            if says_something(member):
                documented.add(where.get("file"))
            elif member.get("kind") == "enum" and member.get("prot") == "public" and \
                    not any(says_something(value) for value in member.findall("enumvalue")):
                yield "%s:%s: enumeration %s has no comment" % (where.get("file"), where.get("line"), member.findtext("name"))
    for header in sorted(headers - documented):
        if header.endswith(".h"):
            yield "%s: nothing in it has a comment" % header


def main(output):
    if not shutil.which("doxygen"):
        print("doxygen is not installed")
        return 77
    shutil.rmtree(output, ignore_errors=True)
    # Without diagrams: Graphviz takes most of the time.
    if make.main(["--no-examples", "--output", str(output)],
                 "HAVE_DOT = NO\nGENERATE_XML = YES\nXML_PROGRAMLISTING = NO\nXML_OUTPUT = xml") != 0:
        return 1
    complaints = [*dead_links(output), *undocumented(output)]
    print(*complaints, sep="\n", end="\n" if complaints else "")
    print("docs: %d pages of HTML, %d complaints" % (len(list(output.glob("*.html"))), len(complaints)))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main((Path(sys.argv[1]) / "docs").resolve()))
