#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The README and the pages of the manual can be read: short pages, short cells of tables, plain sentences.

- A page has at most MOST_WORDS words, a cell of a table at most MOST_CELL.
- The first sentence below the title states what the reader can do with the page: "you can".
- At most 1 of 100 sentences of a page has a phrase that CONTRIBUTING.md rules out.
- A page of HowTo has numbered steps and a picture. A table is not in a step: Doxygen would end the list there.
- A formula in a line is whole, and has no backslash before punctuation: code-hosting sites remove it.
- Plugin/Manual/README.md leads to every page.
- The reference is complete: every option of the program, every array of a response, every public filter.

    check_pages.py [FOLDER]        check the tree (FOLDER is not used)
    check_pages.py --words         the words of each page
    check_pages.py --self-test     break a page in each way and check that it is noticed

Exit code: 0 no fault, 1 a fault.
"""
import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
MANUAL = TOP / "Plugin/Manual"
sys.path[:0] = [str(MANUAL / "Doxygen"), str(TOP / "Testing/Python")]
import pages as tree  # noqa: E402
from check_links import viewer_options  # noqa: E402
from check_words import ODD  # noqa: E402

MOST_WORDS = 1800
MOST_CELL = 25
MOST_FIRST = 35            # words of the first sentence
ODD_SHARE = 0.01           # of the sentences of a page
SENTENCE = re.compile(r"(?<=[.;:!?])\s+")


def plain(text):
    """Text without the targets of links; a formula counts as one word."""
    return tree.FORMULA.sub("formula", tree.LINK.sub(r"\2", text))


def words(text):
    return [word for word in plain(text).split() if re.search(r"\w", word)]


def cells(text):
    """(line number, cell) of each cell of each table."""
    for number, line, code in tree.lines_of(text):
        if not code and line.lstrip().startswith("|") and set(line.strip()) - set("|-: "):
            # A bar in code, or after a backslash, does not end a cell.
            row = tree.CODE_SPAN.sub(lambda span: span.group().replace("|", "/"), line.strip()).replace("\\|", "/")
            for cell in row.strip("|").split("|"):
                yield number, cell


def prose(text):
    """The sentences outside of code."""
    lines = [line for _, line, code in tree.lines_of(text) if not code]
    return [sentence for sentence in SENTENCE.split("\n".join(lines)) if len(sentence) >= 15]


def first_sentence(text):
    after_title = re.sub(r"\A# [^\n]*\n+", "", text)
    return " ".join(SENTENCE.split(after_title.split("\n\n")[0])[0].split())


def formula_faults(text):
    for number, line, code in tree.lines_of(text):
        outside = "" if code else tree.CODE_SPAN.sub("", line)
        if "$" in tree.FORMULA.sub("", outside):
            yield number, "a formula is not whole: $x$, without spaces next to the dollar signs"
        elif any(re.search(r"\\[^a-zA-Z]", formula) for formula in tree.FORMULA.findall(outside)):
            yield number, "a formula in a line has a backslash before punctuation"


def check_text(text, has_steps):
    """(line number, complaint) about a page. `has_steps`: it is a page of HowTo."""
    count = len(text.split())
    if count > MOST_WORDS:
        yield 1, "%d words; a page has at most %d: split it" % (count, MOST_WORDS)
    for number, cell in cells(text):
        if len(words(cell)) > MOST_CELL:
            yield number, "%d words in a cell; at most %d: '%s...'" % (len(words(cell)), MOST_CELL, cell.strip()[:40])
    first = first_sentence(text)
    if not text.startswith("# ") or "you can " not in first or len(words(first)) > MOST_FIRST:
        yield 3, "the first sentence does not state what the reader can do ('With this page you can ...'): '%s'" % first[:60]
    sentences = prose(text)
    odd = [sentence for sentence in sentences if ODD.search(sentence)]
    if len(odd) > ODD_SHARE * len(sentences):
        yield 1, "%d of %d sentences are odd: '%s'" % (len(odd), len(sentences), " ".join(odd[0].split())[:80])
    yield from formula_faults(text)
    for number, line, code in tree.lines_of(text):
        if not code and re.match(r" +\|", line):
            yield number, "a table in a list: place it below the list"
            break
    if has_steps and not re.search(r"^1\. ", text, re.MULTILINE):
        yield 1, "a page of HowTo has numbered steps"
    if has_steps and not any(picture for _, picture, _ in tree.links(text)):
        yield 1, "a page of HowTo has a picture"


def manual_pages():
    yield TOP / "README.md"
    yield from sorted(MANUAL.rglob("*.md"))


def check_index(linked, existing):
    for page in sorted(existing - linked):
        yield "Plugin/Manual/README.md: does not lead to %s" % page


def missing(page, text, names):
    for name in sorted(names):
        if not re.search(r"(?<![\w-])%s(?![\w-])" % re.escape(name), text):
            yield "%s: %s is missing" % (page, name)


def response_arrays():
    contract = (TOP / "Filters/Contact/ResponseContract.h").read_text(encoding="utf-8")
    return {"Response" + name for name in re.findall(r"^  PALPATE_ARRAY\((\w+),", contract, re.MULTILINE)}


def public_filters():
    rooms = ("Filters/Response", "Filters/SolidResponse", "Filters/MeasuredResponse", "Interactors/Interaction",
             "Interactors/Comparison")
    return {header.stem for room in rooms for header in (TOP / room).glob("vtk*.h")}


def option_names():
    """Without those that switch a flag off: the page names the flag."""
    return {name for name in viewer_options() if not name.startswith("--no-")}


REFERENCE = (("options.md", option_names), ("arrays.md", response_arrays), ("filters.md", public_filters))


def check_tree():
    complaints = []
    for page in manual_pages():
        text = page.read_text(encoding="utf-8")
        complaints += ["%s:%d: %s" % (page.relative_to(TOP), line, complaint)
                       for line, complaint in check_text(text, page.parent.name == "HowTo")]
    index = MANUAL / "README.md"
    linked = {tree.split_target(index, target)[0] for _, _, target in tree.links(index.read_text(encoding="utf-8"))}
    complaints += check_index({str(path) for path in linked},
                              {str(page.relative_to(TOP)) for page in MANUAL.rglob("*.md") if page != index})
    for name, names in REFERENCE:
        complaints += missing("Plugin/Manual/Reference/" + name,
                              (MANUAL / "Reference" / name).read_text(encoding="utf-8"), names())
    print(*complaints, sep="\n", end="\n" if complaints else "")
    print("pages: %d pages, %d complaints" % (len(list(manual_pages())), len(complaints)))
    return 1 if complaints else 0


def print_words():
    for page in manual_pages():
        print("%5d  %s" % (len(page.read_text(encoding="utf-8").split()), page.relative_to(TOP)))
    return 0


SOUND = """# How to press

With this page you can press a tool.

![picture](a.png)

1. Press. The force is $a b c$.

| a | b |
|---|---|
| `x|y` | one word |
"""
BROKEN = (SOUND + "word " * MOST_WORDS, SOUND + "| " + "word " * (MOST_CELL + 1) + "| b |\n",
          SOUND.replace("With this page you can press a tool.", "A tool is pressed."),
          SOUND.replace("press a tool.", "press " + "a tool " * 20 + "."),
          SOUND + "What of it is told is odd.\n", SOUND.replace("1. Press.", "Press."), SOUND.replace("![", "["),
          SOUND + "A $broken formula.\n", SOUND + "A formula $a\\,b$ with a space.\n",
          SOUND + "\n1. Press.\n\n   | a |\n   |---|\n")


def self_test():
    failures = 0
    for text in (SOUND, *BROKEN):
        found = list(check_text(text, True))
        if len(found) != (text != SOUND):
            print("self-test: %r: %s" % (text[-60:], found))
            failures += 1
    failures += len(list(check_index({"a.md"}, {"a.md", "b.md"}))) != 1
    failures += len(list(missing("page", "`--layers`, `--map`", {"--layers", "--layer", "--map"}))) != 1
    print("self-test: %d pages, %d failures" % (3 + len(BROKEN), failures))
    return failures


if __name__ == "__main__":
    if sys.argv[1:] == ["--words"]:
        sys.exit(print_words())
    sys.exit(1 if self_test() or (sys.argv[1:] != ["--self-test"] and check_tree()) else 0)
