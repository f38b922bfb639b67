# SPDX-License-Identifier: BSD-3-Clause
"""Finds headings, links and code in the Markdown pages of this tree, for the filter of Doxygen, make.py and the tests of
the documentation.

Pages are written for a code-hosting site: links to files are relative, and `#heading` is a link to a heading.
"""
import re
from pathlib import Path

TOP = Path(__file__).resolve().parents[3]

FENCE = re.compile(r"^ *```")
MATH_FENCE = re.compile(r"^ *```math$")
HEADING = re.compile(r"^(#{1,6}) +(.*?) *$")
CODE_SPAN = re.compile(r"(`+)(.+?)\1")
# A formula in a line, as on code-hosting sites: no space inside next to a dollar sign, no letter or digit outside.
FORMULA = re.compile(r"(?<![\w$\\])\$(?=\S)([^$]+?)(?<=\S)\$(?![\w$])")
# The groups are "!", text and target. The text may contain code and one pair of brackets.
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")
EXTERNAL = re.compile(r"[a-z]+:")


def lines_of(text):
    """Yields (line number, line, whether the line is code) for each line."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        fence = bool(FENCE.match(line))
        yield number, line, fenced or fence
        fenced ^= fence


def anchor(heading):
    """Returns the anchor that code-hosting sites make from a heading."""
    plain = re.sub(r"[`*]", "", LINK.sub(r"\2", heading)).lower()
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


def headings(text):
    """Returns the anchors of a page."""
    for _, line, code in lines_of(text):
        match = not code and HEADING.match(line)
        if match:
            yield anchor(match.group(2))


def links(text):
    """Yields (line number, whether it is a picture, target) for each link that is not to another site."""
    for number, line, code in lines_of(text):
        if not code:
            # Text in a code span is not a link. The text of a link may be code, which does not affect its target.
            plain = CODE_SPAN.sub(lambda span: "`" * len(span.group()), line)
            for picture, _, target in LINK.findall(plain):
                if not EXTERNAL.match(target):
                    yield number, bool(picture), target


def split_target(page, target):
    """Returns file (relative to the top) and anchor of a link's target in `page`; None for a file outside the tree."""
    path, _, heading = target.partition("#")
    file = (page.parent / path).resolve() if path else page.resolve()
    try:
        return file.relative_to(TOP), heading
    except ValueError:
        return None, heading


def pages():
    """Returns all Markdown pages except those that the build makes."""
    for entry in sorted(TOP.iterdir()):
        if entry.suffix == ".md":
            yield entry
        elif entry.is_dir() and entry.name in ("Plugin", "Filters", "Interactors", "Testing", "Data"):
            yield from sorted(entry.rglob("*.md"))


def page_name(path):
    """Returns the HTML name of a page given relative to the top: Plugin/Manual/HowTo/mesh.md is howto_mesh.html."""
    if path == Path("README.md"):
        return "index"
    if path == Path("Plugin/Manual/README.md"):
        return "manual"
    if path.parent.parent == Path("Plugin/Manual"):
        return re.sub(r"\W", "_", "%s_%s" % (path.parent.name, path.stem)).lower()
    parts = [*path.parent.parts, *([] if path.stem == "README" and path.parent.parts else [path.stem])]
    return re.sub(r"\W", "_", "_".join(parts)).lower()
