#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Everything that the Markdown pages name exists: files, pictures, headings, commands of ./run, options of the viewer,
tools of the build. The README is not too long. Tables in the comments of headers are complete.

    check_links.py [FOLDER]        check the tree (FOLDER is not used)
    check_links.py --self-test     break a page in each way and check that it is noticed

Exit code: 0 everything exists, 1 something does not.
"""
import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "Plugin/Manual/Doxygen"))
import pages as tree  # noqa: E402

README_WORDS = 700
# Written by hand for readers. Reports are excluded, since they quote the past.
MANUAL = ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "Plugin/Manual/")
# A row of a table in a comment. A formula that begins with | has no space after it.
TABLE_ROW = re.compile(r"^\s*(?:\*|//+) ?(\|[ :-].*)$")
# Options of other programs that appear in lines with palpate.
FOREIGN = {"--preset", "--prefix", "--install", "--build", "--dr"}


def run_commands():
    """The commands in the output of `./run help`, the head comment of run."""
    script = (TOP / "run").read_text(encoding="utf-8")
    return set(re.findall(r"^# +\./run ([a-z]+)", script, re.MULTILINE)) | {"help"}


def study_names():
    match = re.search(r"^readonly studies=\((.*?)\)", (TOP / "Plugin/Run/measure.sh").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    return set(match.group(1).split())


def viewer_options():
    """The names in the strings of what reads the command line, those of the contact's settings, and CLI11's own."""
    sources = sorted((TOP / "Plugin/Viewer/CommandLine").glob("*.cxx"))
    source = "\n".join(file.read_text(encoding="utf-8") for file in sources)
    table = (TOP / "Filters/Contact/SettingTable.h").read_text(encoding="utf-8")
    settings = {"--" + name for name in re.findall(r'\{ "[A-Z]\w+", "([a-z-]+)", "[^"]*",', table)}
    return set(re.findall(r"--[a-z][a-z-]+", source)) | settings | {"--help"}


def check_targets(page, text):
    for line, picture, target in tree.links(text):
        file, heading = tree.split_target(page, target)
        if file is None:
            yield line, "'%s' leaves the tree" % target
        elif not (TOP / file).exists():
            yield line, "there is no %s '%s'" % ("picture" if picture else "file", target)
        elif heading:
            there = (TOP / file).read_text(encoding="utf-8")
            if heading not in tree.headings(there):
                yield line, "'%s' has no heading '#%s'" % (file, heading)


def commands(text):
    """(line number, text) of each command: lines of code, and code spans. A backslash goes on."""
    pending = None
    for number, line, code in tree.lines_of(text):
        if code and pending:
            number, line, pending = pending[0], pending[1] + " " + line, None
        if code and line.endswith("\\"):
            pending = (number, line[:-1])
        elif code:
            yield number, line
        else:
            for _, span in tree.CODE_SPAN.findall(line):
                yield number, span


def check_commands(text):
    known, studies, options = run_commands(), study_names(), viewer_options()
    for line, command in commands(text):
        for job, argument in re.findall(r"\./run ([a-z]+)(?: ([a-z-]+))?", command):
            if job not in known:
                yield line, "'./run %s' is no command of run" % job
            elif job == "study" and argument and argument not in studies:
                yield line, "there is no study '%s'" % argument
        calls = re.search(r"(?:^|[\s/])palpate (?P<rest>[^#]*)|\./run demo(?P<demo>[^#]*)", command)
        alone = re.fullmatch(r"--[a-z][a-z-]+( .*)?", command)
        if calls or alone:
            for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", command if alone else calls.group("rest") or calls.group("demo") or ""):
                if option not in options | FOREIGN | {"--all", "--offscreen"}:
                    yield line, "'%s' is no option of palpate" % option


def check_page(page, text):
    yield from check_targets(page, text)
    if str(page.relative_to(TOP)).startswith(MANUAL):
        yield from check_commands(text)
    if page == TOP / "README.md" and len(text.split()) > README_WORDS:
        yield 1, "%d words; it is to have %d at most" % (len(text.split()), README_WORDS)


def check_version():
    """The version stands in three places."""
    version = re.search(r"project\(.*?VERSION (\S+)", (TOP / "CMakeLists.txt").read_text(encoding="utf-8"), re.DOTALL).group(1)
    if "\nversion: %s\n" % version not in (TOP / "CITATION.cff").read_text(encoding="utf-8"):
        yield "CITATION.cff: not of version %s" % version
    if "\n## [%s]" % version not in (TOP / "CHANGELOG.md").read_text(encoding="utf-8"):
        yield "CHANGELOG.md: nothing of version %s" % version


def check_examples():
    page = TOP / "Plugin/Manual/Reference/python.md"
    manual = page.read_text(encoding="utf-8")
    for example in sorted((TOP / "Plugin/Python/examples").glob("*.py")):
        if example.name not in manual:
            yield "%s: the example %s is missing" % (page.relative_to(TOP), example.name)


def torn_rows(text):
    """Rows of tables that have no end, another number of cells than the first, or no line of dashes below that."""
    rows = []
    for number, line in enumerate(text.splitlines() + [""], 1):
        row = TABLE_ROW.match(line)
        if row:
            rows.append(row.group(1).rstrip())
            if not rows[-1].endswith("|") or rows[-1].count("|") != rows[0].count("|"):
                yield number, "a row of the table is torn"
        elif rows:
            if len(rows) < 2 or set(rows[1]) - set("|-: "):
                yield number, "the head of the table is torn"
            rows = []


def check_tables():
    for header in sorted(file for room in ("Filters", "Interactors", "Plugin") for file in (TOP / room).glob("**/*.h")):
        for line, complaint in torn_rows(header.read_text(encoding="utf-8")):
            yield "%s:%d: %s" % (header.relative_to(TOP), line, complaint)


def check_tree():
    complaints = 0
    for complaint in (*check_version(), *check_examples(), *check_tables()):
        print(complaint)
        complaints += 1
    for page in tree.pages():
        for line, complaint in check_page(page, page.read_text(encoding="utf-8")):
            print("%s:%d: %s" % (page.relative_to(TOP), line, complaint))
            complaints += 1
    print("links: %d pages, %d complaints" % (len(list(tree.pages())), complaints))
    return 1 if complaints else 0


SOUND = """# Page
[a page](LICENSE), [a heading](README.md), ![a picture](Data/Pictures/overview.png), [other](https://example.org/x)
`./run help`, `palpate --tool sphere:6.35`
```
./run study paper --quick
palpate x.stl \\
  --young 0.05      # --no-such-option
[no link](nowhere)
```
"""
BROKEN = ("[gone](nowhere.md)", "![gone](Data/Pictures/nowhere.png)", "[gone](README.md#nowhere)", "[out](../x)",
          "`./run nothing`", "`./run study nothing`", "`palpate --nothing`", "```\npalpate \\\n --nothing\n```",
          "`--nothing`", "word " * 900)
TABLE = " * | Shape | force |\n * |---|---|\n * | Flat  | 2 a E* δ |\n * |F| is no row.\n"
TORN = (TABLE.replace("2 a E* δ |", "2 a\n * E* δ |"), TABLE.replace(" | force |", " |\n * force |"))


def self_test():
    page, failures = TOP / "README.md", 0
    for broken in ("",) + BROKEN:
        found = list(check_page(page, SOUND + broken))
        if len(found) != (1 if broken else 0):
            print("self-test: %r: %s" % (broken[:40], found))
            failures += 1
    for table in (TABLE,) + TORN:
        if bool(list(torn_rows(table))) != (table != TABLE):
            print("self-test: %r: %s" % (table, list(torn_rows(table))))
            failures += 1
    print("self-test: %d pages and tables, %d failures" % (2 + len(BROKEN) + len(TORN), failures))
    return failures


if __name__ == "__main__":
    sys.exit(1 if self_test() or (sys.argv[1:] != ["--self-test"] and check_tree()) else 0)
