# SPDX-License-Identifier: BSD-3-Clause
"""The compiled help contains a page for every proxy, every page of the plugin, and every file that these pages show or
link to. Its contents start with the six clicks and list each page once:
    help.py PALPATE.QCH SOURCE_OF_THE_PLUGIN PICTURES
"""
import re
import sqlite3
import sys
import xml.etree.ElementTree
from pathlib import Path

collection, plugin, pictures = (Path(argument) for argument in sys.argv[1:])
with sqlite3.connect(f"file:{collection}?mode=ro", uri=True) as compiled:
    held = {name for (name,) in compiled.execute("SELECT Name FROM FileNameTable")}
print(sorted(held))

proxies = 0
for file in (plugin / "ServerManager").glob("*.xml"):
    for group in xml.etree.ElementTree.parse(file).iter("ProxyGroup"):
        if group.get("name") not in ("sources", "filters"):
            continue
        for proxy in group.findall("SourceProxy"):
            page = f"{group.get('name')}.{proxy.get('name')}.html"
            assert page in held, page
            proxies += 1
assert proxies > 5, proxies

pages = list((plugin / "Help").glob("*.html"))
assert len(pages) >= 7, pages
shown = set()
for page in pages:
    assert page.name in held, page.name
    text = page.read_text(encoding="utf-8")
    assert re.search(r"<title>[^<]+</title>", text), page.name
    for target in re.findall(r'(?:src|href)="([^"]+)"', text):
        assert target in held, f"{page.name} wants {target}"
    shown.update(re.findall(r'<img src="([^"]+)"', text))
assert shown, "no page has a picture"
for picture in shown:
    assert (pictures / picture).read_bytes()[:4] == b"\x89PNG", picture

# The table of contents that the compiler of the help has read.
project = xml.etree.ElementTree.parse(collection.with_suffix(".qhp"))
sections = list(project.iter("section"))
listed = [section.get("ref") for section in sections]
assert listed[0] == "palpate.html" and "six clicks" in sections[0].get("title"), listed[0]
assert len(set(listed)) == len(listed), [page for page in listed if listed.count(page) > 1]
# Readers.html is an unused index of the readers
written = {name for name in held if name.endswith(".html") and name != "Readers.html"}
assert set(listed) == written, set(listed) ^ written
titles = [section.get("title") for section in sections]
assert len(set(titles)) == len(titles), titles
for page in pages:
    title = re.search(r"<title>([^<]+)</title>", page.read_text(encoding="utf-8")).group(1)
    assert titles[listed.index(page.name)] == title, page.name
