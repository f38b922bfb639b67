#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Comments are plain English: at most 1 of 100 comment lines of a folder has a phrase that CONTRIBUTING.md rules out.

The phrases are hints: a hit may be fine, and a comment without one may still be hard to read. --sample draws comments
for a reader to judge.

    check_words.py [SOURCE_DIR]        check the tree (default: the one this script is in)
    check_words.py --hits              print each comment line with such a phrase
    check_words.py --pages             the same share for the sentences of each page of Markdown, in percent
    check_words.py --sample N [SEED]   N comments of the product, drawn at random
    check_words.py --self-test         insert phrases and check that they are noticed

Exit code: 0 no fault, 1 a fault, 2 wrong usage.
"""
import random
import re
import sys
from collections import defaultdict
from pathlib import Path

from check_layering import SOURCES, code_files, main

ODD = re.compile("|".join((
    r"\b(?:is|are|was|were) told\b|\btells\b|\btold\b",
    r"\b[Ww]hat (?:of|is|was|it|they|the|a|no|has|comes|lies|may|must|would)\b",
    r"^\s*(?:///<?|//|\*)\s+Of (?:a|the|all|each|its|that|those|one|what)\b",
    r"\bwhere there (?:is|are) (?:none|no)\b",
    r"\bbut for\b|\bbut of\b|\bnone but\b|\banew\b|\bbeside\b|\bto and fro\b|\bat hand\b|\blets? go\b|\bnobody\b|\bsomebody\b")))
MOST = 0.01                # allowed share of the lines of a folder
FEW_LINES = 40             # a folder with fewer lines may have one odd line
TRAILING = re.compile(r"[;,{})]\s*(///?<?\s.*)$")
SOURCE = Path(__file__).resolve().parents[2]


def comment_blocks(text):
    """(line number, lines) of each comment of a C or C++ source."""
    lines, i = text.split("\n"), 0
    while i < len(lines):
        first, start = lines[i].strip(), i
        if first.startswith("/*"):
            while i < len(lines) - 1 and "*/" not in lines[i]:
                i += 1
            yield start + 1, [line.strip() for line in lines[start:i + 1]]
        elif first.startswith("//"):
            while i < len(lines) - 1 and lines[i + 1].strip().startswith("//"):
                i += 1
            yield start + 1, [line.strip() for line in lines[start:i + 1]]
        elif (found := TRAILING.search(lines[i])) and "http" not in lines[i]:
            yield i + 1, [found.group(1)]
        i += 1


def comment_lines(text):
    """(line number, line) of each comment line that contains text."""
    for start, block in comment_blocks(text):
        for number, line in enumerate(block, start):
            if re.search(r"\w", line) and "SPDX" not in line:
                yield number, line


def check(files, read, seen=lambda hit: None):
    folders = defaultdict(lambda: [0, 0])
    for path in files:
        count = folders[path.parent]
        for number, line in comment_lines(read(path)):
            count[0] += 1
            if ODD.search(line):
                count[1] += 1
                seen(f"{path}:{number}: {line}")
    return [f"{folder}: {odd} of {lines} comment lines have a phrase that CONTRIBUTING.md rules out (--hits shows them)"
            for folder, (lines, odd) in sorted(folders.items()) if odd > max(1, MOST * max(lines, FEW_LINES))]


def read_from(root):
    return lambda path: (root / path).read_text(encoding="utf-8", errors="replace")


def all_sources(root):
    yield from code_files(root)
    for path in sorted((root / "Testing").rglob("*")):
        if path.suffix in SOURCES and path.is_file():
            yield path.relative_to(root)


def check_tree(root):
    return check(all_sources(root), read_from(root))


def print_pages():
    for page in sorted(SOURCE.rglob("*.md")):
        if "build" in page.relative_to(SOURCE).parts:
            continue
        sentences = [s for s in re.split(r"(?<=[.;:])\s+", page.read_text(encoding="utf-8")) if len(s) >= 15]
        odd = sum(1 for sentence in sentences if ODD.search(sentence))
        if odd:
            print(f"{100 * odd / len(sentences):5.1f} % of {len(sentences):4d} sentences  {page.relative_to(SOURCE)}")
    return 0


def print_sample(count, seed):
    blocks = []
    for path in code_files(SOURCE):
        blocks += [(path, line, block) for line, block in comment_blocks(read_from(SOURCE)(path))
                   if sum(map(len, block)) >= 60 and "SPDX" not in block[0]]
    random.seed(seed)
    for path, line, block in random.sample(blocks, count):
        print(f"---- {path}:{line}", *block, sep="\n")
    return 0


def self_test():
    plain = "// The part along the normal is kept separate.\nint x; // mm\n/* Two\n * lines. */\n"
    trees = [({"A/a.h": plain * 30}, 0), ({"A/a.h": plain * 30 + "// What of it is told.\n"}, 0),
             ({"A/a.h": plain * 30 + "/// Of the last press:\nint y; // but for one\n"}, 1),
             ({"A/a.h": "int told = tells(); // one\n" * 90 + 'auto s = "nobody";\n'}, 0),
             ({"A/a.h": "// anew\n", "A/b.h": "// nobody\n", "B/c.h": plain}, 1)]
    failures = 0
    for tree, expected in trees:
        found = check([Path(path) for path in tree], lambda path, tree=tree: tree[str(path)])
        if len(found) != expected:
            print(f"self-test: expected {expected} complaints, got {found}")
            failures += 1
    print(f"self-test: {len(trees)} trees, {failures} failures")
    return 1 if failures else 0


def run(arguments):
    if arguments == ["--hits"]:
        check(all_sources(SOURCE), read_from(SOURCE), print)
        return 0
    if arguments == ["--pages"]:
        return print_pages()
    if arguments[:1] == ["--sample"] and len(arguments) in (2, 3) and all(a.isdigit() for a in arguments[1:]):
        return print_sample(int(arguments[1]), int(arguments[2]) if len(arguments) == 3 else 1)
    return main(arguments, __doc__, "words", check_tree, self_test)


if __name__ == "__main__":
    sys.exit(run(sys.argv[1:]))
