#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each name has one meaning: no type is defined twice, and no two rooms have functions of the same name.

C++ forbids two definitions of one type in a program (the one-definition rule), but a compiler need not detect them.
Which definition a call uses is then undefined. Names in an anonymous namespace or inside a class are not visible
elsewhere and are not checked. Only functions that headers declare are checked. Overloads of one name must be in one
room, unless they are in SAME_THING.

    check_names.py [SOURCE_DIR]    check the tree (default: the one this script is in)
    check_names.py --self-test     define a name twice and check that it is noticed

Exit code: 0 no fault, 1 a fault, 2 wrong usage.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

from check_layering import HEADERS, code_files, main, room_of

SAME_THING = {"palpate::makeContactBody",    # from a file's body, and from a vtkPolyData
              "palpate::specificationOf"}    # for a simulated plant, and for a device that describes itself

# Text that is not code, and preprocessor lines with their continuation lines.
SILENT = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|'
                    r"^[ \t]*#(?:\\\n|[^\n])*", re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(r"\b(?:inline\s+)?namespace\s*([\w:]*)\s*$")
TYPE = re.compile(r"\b(?:class|struct|union|enum(?:\s+class|\s+struct)?)\s+(?:\[\[\w+\]\]\s*)?(?:[A-Z0-9_]+_EXPORT\s+)?"
                  r"(\w+)(?:\s+final)?(?:\s*:(?!:)[^;]*)?\s*$")
SPECIALISED = re.compile(r"^\s*template\s*<\s*>")
FUNCTION = re.compile(r"\b([A-Za-z_]\w*)\s*\(")
NO_FUNCTION = re.compile(r"^\s*(?:typedef|using|static_assert|extern|friend|VTK_|vtk\w*Macro|Q_|ABI)|\boperator\b|=")


def statements(text):
    """(namespace, words, end) of the code in named namespaces: the words before each '{' or ';', which is the end."""
    text = SILENT.sub(" ", text)
    stack, begin = [], 0             # names of namespaces; None for any other brace, "" for an anonymous one
    for match in re.finditer(r"[{};]", text):
        words, end = text[begin:match.start()], match.group()
        begin = match.end()
        if None not in stack and "" not in stack and end != "}":
            yield "::".join(stack), words, end
        if end == "{":
            namespace = NAMESPACE.search(words)
            stack.append(namespace.group(1) if namespace else None)
        elif end == "}" and stack:
            stack.pop()


def defined_types(text):
    for scope, words, end in statements(text):
        found = TYPE.search(words)
        if end == "{" and found and not SPECIALISED.match(words):
            yield f"{scope}::{found.group(1)}" if scope else found.group(1)


def declared_functions(text):
    for scope, words, _ in statements(text):
        found = FUNCTION.search(words)
        if scope and found and not NO_FUNCTION.search(words[:found.start() + 1]):
            yield f"{scope}::{found.group(1)}"


def check(files, read):
    types, functions = defaultdict(list), defaultdict(dict)
    for path in files:
        text = read(path)
        for name in defined_types(text):
            types[name].append(path)
        if path.suffix in HEADERS:
            for name in declared_functions(text):
                functions[name].setdefault(room_of(path), path)
    complaints = [f"{name} is defined in {' and in '.join(map(str, sorted(set(paths))))}"
                  for name, paths in sorted(types.items()) if len(set(paths)) > 1]
    complaints += [f"{name} is declared in {' and in '.join(str(rooms[room]) for room in sorted(rooms))}"
                   for name, rooms in sorted(functions.items()) if len(rooms) > 1 and name not in SAME_THING]
    return complaints


SOUND = {
    "Filters/A/One.h": "namespace palpate\n{\nclass Two;\nstruct One final : Base<3>\n{\n  struct Part {};\n};\n"
                       "double areaOf(const One& one);\nusing Call = void(int);\n}\n",
    "Filters/A/One.cxx": "namespace palpate\n{\nnamespace\n{\nstruct Part { int x = f(\"}\"); };\n"
                         "double radiusOf(int);\n}\ndouble areaOf(const One& one) { return radiusOf(1); }\n}\n",
    "Filters/B/Two.h": "namespace palpate\n{\nenum class Two : int\n{\n  A // struct One {\n};\n"
                       "double lengthOf(Two two);\n}\n",
    "Filters/B/Two.cxx": "namespace palpate::other { struct One {}; }\nnamespace { struct Part {}; }\n",
}
BREAKS = {
    "palpate::One": ("Filters/B/Three.cxx", "namespace palpate { struct One { int x; }; }"),
    "palpate::Two": ("Filters/A/Three.h", "namespace palpate\n{\nclass PALPATE_EXPORT Two : public Base\n{\n};\n}"),
    "palpate::areaOf": ("Filters/B/Three.h", "namespace palpate\n{\nbool areaOf(int);\n}"),
}


def self_test():
    failures = 0
    for name, wrong in [(None, None), *BREAKS.items()]:
        tree = dict(SOUND, **({wrong[0]: wrong[1]} if wrong else {}))
        found = check([Path(path) for path in tree], lambda path, tree=tree: tree[str(path)])
        if [complaint.split()[0] for complaint in found] != ([name] if name else []):
            print(f"self-test: expected a complaint about {name}, got {found}")
            failures += 1
    print(f"self-test: {1 + len(BREAKS)} trees, {failures} failures")
    return 1 if failures else 0


def check_tree(root):
    files = [path for path in code_files(root) if path.suffix != ".c"]
    return check(files, lambda path: (root / path).read_text(encoding="utf-8", errors="replace"))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:], __doc__, "names", check_tree, self_test))
