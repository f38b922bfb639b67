#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every public class has an example in its comment, and what an example calls exists.

Public are the VTK classes that a CMakeLists.txt of Filters or Interactors lists under CLASSES, and the C headers in
C_HEADERS. The examples in Python (@code{.py}) are checked by the text of the headers: each method called on an object
of a palpate class, and each constant of such a class. Of the examples in C (@code{.c}) each function named palpate_…
is checked.

    check_examples.py [FOLDER]     check the tree (FOLDER is not used)
    check_examples.py --self-test  break an example in each way and check that it is noticed

Exit code: 0 no fault, 1 a fault.
"""
import ast
import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
ROOMS = ("Filters", "Interactors")
C_HEADERS = ("Interactors/Haptics/palpate.h", "Interactors/Transports/device/palpate_hid.h")
LEAST, MOST = 2, 10        # lines of an example

# Objects of palpate classes that an example uses and does not make. Other such names are not checked.
GIVEN = {"charts": "vtkLiveCharts", "clock": "vtkFrameClock", "compliance": "vtkElasticCompliance",
         "curves": "vtkResponseCurves", "felt": "vtkElasticContactResponse", "material": "vtkNoduleMaterial",
         "measured": "vtkMeasuredContactResponse", "path": "vtkPressPath", "probe": "vtkToolContactProbe",
         "reader": "vtkBodyFileReader", "regime": "vtkContactRegime", "response": "vtkToolContactResponse",
         "scene": "vtkContactScene", "session": "vtkHapticSession", "setup": "vtkContactSetup",
         "skin": "vtkSkinSurface", "solid": "vtkGradedBody", "style": "vtkInteractorStyleHaptic",
         "tool": "vtkContactTool"}
# Methods of VTK, by the ending of the superclass.
OBJECT = {"AddObserver"}
OF_VTK = {"Algorithm": OBJECT | {"GetOutput", "GetOutputDataObject", "GetOutputPort", "SetInputArrayToProcess",
                                 "SetInputConnection", "SetInputData", "Update"}}

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
UNWRAPPED = re.compile(r"^#ifndef __VTK_WRAP__$.*?^#endif", re.DOTALL | re.MULTILINE)   # not in Python
CODE = re.compile(r"@code\{\.(py|c)\}\n(.*?)@endcode", re.DOTALL)


class Header:
    """The public members of a class, by the text of its header."""

    def __init__(self, text):
        code = COMMENT.sub(" ", text)
        found = re.search(r"\bclass \w+_EXPORT (vtk\w+) *: *public (vtk\w+)\s*\{(.*)^\};", code, re.DOTALL | re.MULTILINE)
        self.name, self.superclass, body = found.groups()
        body = UNWRAPPED.sub("", body)
        parts = re.split(r"^(public|protected|private):", "private:\n" + body, flags=re.MULTILINE)
        public = "".join(part for access, part in zip(parts[1::2], parts[2::2]) if access == "public")
        self.returned = {method: kind for kind, method in re.findall(r"\b(vtk\w+)\* (\w+)\(", public)}
        self.methods = set(re.findall(r"[\w>&*] [*&]?([A-Z]\w*)\(", public)) - {"Macro"}
        for kind, name in re.findall(r"\bvtk(Set|Get|Boolean)\w*Macro\((\w+)", public):
            self.methods |= {name + "On", name + "Off"} if kind == "Boolean" else {kind + name}
        enums = re.findall(r"\benum(?: \w+)?\s*\{(.*?)\}", public, re.DOTALL)
        self.constants = {name for enum in enums for name in re.findall(r"\b([A-Z]\w*)\s*(?:=|,|$)", enum.strip())}


class Examples(ast.NodeVisitor):
    """Complaints about one example in Python."""

    def __init__(self, headers, functions):
        self.headers, self.functions = headers, functions
        self.kinds, self.complaints = dict(GIVEN), []

    def kind_of(self, node):
        """The palpate class of the value of an expression; None: another value."""
        if isinstance(node, ast.Name):
            return self.kinds.get(node.id)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if isinstance(node.func.value, ast.Name) and node.func.value.id == "palpate":
                return node.func.attr if node.func.attr in self.headers else None
            owner = self.headers.get(self.kind_of(node.func.value))
            returned = owner and owner.returned.get(node.func.attr)
            return returned if returned in self.headers else None
        return None

    def has(self, kind, name):
        header = self.headers.get(kind)
        if header is None:
            return name in OBJECT or any(kind.endswith(end) and name in methods for end, methods in OF_VTK.items())
        return name in header.methods | header.constants or self.has(header.superclass, name)

    def visit_Assign(self, node):
        self.generic_visit(node)
        for target in node.targets:
            if isinstance(target, ast.Name):
                self.kinds[target.id] = self.kind_of(node.value)

    def visit_Attribute(self, node):
        self.generic_visit(node)
        value = node.value
        if isinstance(value, ast.Name) and value.id == "palpate":
            if node.attr not in self.headers and node.attr not in self.functions:
                self.complaints.append("there is no palpate.%s" % node.attr)
            return
        is_class = isinstance(value, ast.Attribute) and isinstance(value.value, ast.Name) and value.value.id == "palpate"
        kind = value.attr if is_class and value.attr in self.headers else self.kind_of(value)
        if kind and not self.has(kind, node.attr):
            self.complaints.append("%s has no %s" % (kind, node.attr))


def python_faults(code, headers, functions):
    try:
        tree = ast.parse(code)
    except SyntaxError as error:
        return ["the example is not Python: %s" % error]
    visitor = Examples(headers, functions)
    visitor.visit(tree)
    return visitor.complaints


def c_faults(code, text):
    declared = set(re.findall(r"\b(palpate_\w+)\(", COMMENT.sub(" ", text)))
    return ["there is no function %s" % name for name in re.findall(r"\b(palpate_\w+)\(", code) if name not in declared]


def blocks(text):
    """(language, code) of each example in the comments of a header."""
    for language, block in CODE.findall(text):
        yield language, "\n".join(re.sub(r"^\s*(\*|//+) ?", "", line) for line in block.split("\n")).strip()


def check_header(text, headers, functions):
    examples = list(blocks(text))
    if not examples:
        yield "there is no example in the comment of the class or file"
    for language, code in examples:
        lines = code.count("\n") + 1
        if not LEAST <= lines <= MOST:
            yield "an example has %d lines; it is to have %d to %d" % (lines, LEAST, MOST)
        yield from python_faults(code, headers, functions) if language == "py" else c_faults(code, text)


def public_classes():
    """The headers of the VTK classes that the modules list."""
    for lists in sorted(file for room in ROOMS for file in (TOP / room).glob("**/CMakeLists.txt")):
        found = re.search(r"vtk_module_add_module\(.*?\bCLASSES\b(.*?)(?:\b[A-Z]+(?:_[A-Z]+)*\b\s|\))",
                          lists.read_text(encoding="utf-8"), re.DOTALL)
        for name in found.group(1).split() if found else ():
            yield lists.parent / (name + ".h")


def check_tree():
    texts = {file: file.read_text(encoding="utf-8") for file in public_classes()}
    headers = {header.name: header for header in map(Header, texts.values())}
    texts.update((TOP / name, (TOP / name).read_text(encoding="utf-8")) for name in C_HEADERS)
    package = (TOP / "Plugin/Python/palpate/__init__.py").read_text(encoding="utf-8")
    functions = set(re.findall(r'"([a-z]\w*|[A-Z]\w*)"', package))
    complaints = ["GIVEN names no class %s" % kind for kind in GIVEN.values() if kind not in headers]
    for file, text in texts.items():
        complaints += ["%s: %s" % (file.relative_to(TOP), fault) for fault in check_header(text, headers, functions)]
    for complaint in complaints:
        print(complaint)
    print("examples: %d headers, %d complaints" % (len(texts), len(complaints)))
    return 1 if complaints else 0


SOUND = """/**
 * @class vtkContactTool
 *
 * @code{.py}
 * made = palpate.vtkContactTool()
 * made.SetRadius(3)                  # mm
 * made.SharpOn()
 * made.SetShape(palpate.vtkContactTool.Sphere)
 * made.GetOwner().GetOwner().Update()
 * body = palpate.response(made.GetOutput(), made)
 * @endcode
 */
class X_EXPORT vtkContactTool : public vtkPolyDataAlgorithm
{
public:
  enum Shapes { Flat = 0, Sphere = 1 };
  vtkSetMacro(Radius, double);       // void SetRemark(int);
  vtkBooleanMacro(Sharp, bool);
  void SetShape(int shape);
  vtkContactTool* GetOwner();
#ifndef __VTK_WRAP__
  void SetKernel(int kernel);
#endif

protected:
  void SetHidden(int value);
};
"""
C_SOUND = "/* @code{.c}\n * palpate_step(contact);\n * palpate_free(contact);\n * @endcode */\n" \
          "void palpate_step(int); void palpate_free(int);\n"
BROKEN = (("SetRadius(3)", "SetRadus(3)"), ("SetRadius(3)", "SetHidden(3)"), ("SetRadius(3)", "SetRemark(3)"),
          ("SetRadius(3)", "SetKernel(3)"),
          ("SharpOn()", "SharpUp()"), (".Sphere)", ".Cone)"), ("GetOwner().Update", "GetOwner().Render"),
          ("palpate.response", "palpate.responses"), ("= palpate.vtkContactTool()", "= palpate.vtkContactTol()"),
          ("made.SharpOn()", "made.SharpOn("), ("@code{.py}", "@code"), (" * made.SharpOn()\n", " * 1\n" * MOST))


def self_test():
    headers, failures = {"vtkContactTool": Header(SOUND)}, 0
    cases = [(SOUND, False), (C_SOUND, False), (C_SOUND.replace(" * palpate_step", " * palpate_stop"), True)]
    cases += [(SOUND.replace(*change), True) for change in BROKEN]
    for text, is_broken in cases:
        found = list(check_header(text, headers, {"response"}))
        if bool(found) != is_broken:
            print("self-test: %s\n%s" % (found, text))
            failures += 1
    print("self-test: %d examples, %d failures" % (len(cases), failures))
    return failures


if __name__ == "__main__":
    sys.exit(1 if self_test() or (sys.argv[1:] != ["--self-test"] and check_tree()) else 0)
