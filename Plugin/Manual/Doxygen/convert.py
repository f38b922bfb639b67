# SPDX-License-Identifier: BSD-3-Clause
"""Converts a Markdown page to a page of Doxygen. Links to pages, headings, files and pictures become links of Doxygen,
class names become links, and $formulas$ and blocks of ```math become formulas of Doxygen. Pictures and files are
expected in the folder files/ next to the HTML, to which make.py copies them.
"""
import re
from pathlib import Path

from pages import (CODE_SPAN, EXTERNAL, FORMULA, HEADING, LINK, MATH_FENCE, TOP, anchor, lines_of, page_name,
                   split_target)

# Pages whose links form the table of contents. The linked pages are placed below these pages.
CONTENTS = {"manual", "reference_house"}
ROOMS = [TOP / wing for wing in ("Filters/Mechanics", "Filters/Contact", "Filters/Laws", "Filters/Solids",
                                 "Filters/Strain", "Filters/Identification", "Filters/Response", "Filters/SolidResponse",
                                 "Filters/MeasuredResponse",
                                 "Interactors/Haptics", "Interactors/Transports", "Interactors/Trials", "Interactors/Interaction",
                                 "Interactors/Comparison")]


def private_headers():
    """Returns the headers that the CMakeLists.txt of a folder declares as private."""
    for room in ROOMS:
        text = re.sub(r"#.*", "", (room / "CMakeLists.txt").read_text(encoding="utf-8"))
        private = False
        for word in re.findall(r"[^\s()]+|\)", text):
            if word == ")" or re.fullmatch(r"[A-Z_]{4,}", word): # the end of a list, or the name of the next list
                private = word in ("PRIVATE_CLASSES", "PRIVATE_HEADERS")
            elif private:
                yield room / (word if word.endswith(".h") else word + ".h")


def public_classes():
    """Returns a dictionary from the name to the full name of each class that has a public header."""
    found, private = {}, set(private_headers())
    for header in (path for room in ROOMS for path in room.rglob("*.h") if path not in private):
        text = header.read_text(encoding="utf-8")
        if re.search(r"^(class|struct)( \w+)? %s\b[^;]*$" % header.stem, text, re.MULTILINE):
            found[header.stem] = header.stem if header.stem.startswith("vtk") else "palpate::" + header.stem
    return found


class Page:
    def __init__(self, path, inserted):
        """`inserted` maps the text of a comment to the text that replaces the line of this comment."""
        self.path = path.resolve()
        self.name = page_name(self.path.relative_to(TOP))
        self.inserted = inserted
        self.classes = public_classes()

    def label(self, name, heading):
        return "%s_%s" % (name, re.sub(r"\W", "_", heading)) if heading else name

    def title(self, text):
        return "\\mainpage " + text if self.name == "index" else "# %s {#%s}" % (text, self.name)

    def heading(self, line):
        level, text = HEADING.match(line).groups()
        if level == "#":
            return self.title(text)
        if self.name == "index":
            level = level[1:] # Doxygen's main page has sections where other pages have subsections
        return "%s %s {#%s}" % (level, text, self.label(self.name, anchor(text)))

    def link(self, match):
        picture, text, target = match.groups()
        if EXTERNAL.match(target):
            return match.group()
        file, heading = split_target(self.path, target)
        if picture:
            return '<img src="files/%s" alt="%s"/>' % (file, text.replace('"', "&quot;"))
        if (TOP / file).is_dir():
            file = file / "README.md"
        text = CODE_SPAN.sub(r"\2", text) # the text of a link of Doxygen is not code
        if file.suffix == ".md":
            if self.name in CONTENTS and not heading:
                return '\\subpage %s "%s"' % (page_name(file), text)
            return "[%s](@ref %s)" % (text, self.label(page_name(file), heading))
        return '<a href="files/%s">%s</a>' % (file, text)

    def name_classes(self, line):
        """Makes `vtkContactTool` a link to the page of the class, except inside an existing link."""
        def name(span):
            full = self.classes.get(span.group(2))
            return "[%s](@ref %s)" % (span.group(2), full) if full else span.group()
        pieces = re.split(r"(\[[^\]]*\]\([^)]*\)|<a .*?</a>)", line)
        return "".join(piece if i % 2 else CODE_SPAN.sub(name, piece) for i, piece in enumerate(pieces))

    @staticmethod
    def name_formulas(line):
        """Replaces $x$ by \\f$x\\f$, the form of Doxygen, except in code."""
        pieces = re.split(r"(`+.+?`+)", line)
        return "".join(piece if i % 2 else FORMULA.sub(lambda formula: r"\f$%s\f$" % formula.group(1), piece)
                       for i, piece in enumerate(pieces))

    def lines(self, text):
        in_formula = False
        if not any(line.startswith("# ") for _, line, code in lines_of(text) if not code):
            yield self.title(self.path.stem.replace("-", " ").capitalize()) # a table without a heading
        for _, line, code in lines_of(text):
            comment = re.fullmatch(r"<!-- (\w+) -->", line)
            if code and (in_formula or MATH_FENCE.match(line)):
                ends = in_formula and line.strip() == "```"
                yield r"\f]" if ends else line if in_formula else r"\f["
                in_formula = not ends
            elif code:
                yield line
            elif HEADING.match(line):
                yield self.heading(line)
            elif comment:
                yield from self.inserted.get(comment.group(1), "").split("\n")
            else:
                yield self.name_formulas(self.name_classes(LINK.sub(self.link, line)))

    def converted(self):
        return "\n".join(self.lines(self.path.read_text(encoding="utf-8"))) + "\n"
