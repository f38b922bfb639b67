#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes HTML pages of the manual, the gallery and the public classes by Doxygen.

    make.py [--output FOLDER] [--no-examples]

The examples of Plugin/Python/examples are run first unless their results exist. Their output and pictures become the
end of the gallery. They need the package palpate on PYTHONPATH and a display; ./run docs provides both. Any warning
of Doxygen is an error. Exit code: 0 success, 1 an error, 2 wrong usage, 77 Doxygen is not installed.
"""
import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

from convert import Page, private_headers
from pages import TOP, links, page_name, pages, split_target

EXAMPLES = TOP / "Plugin/Python/examples"
# Command-line arguments of the examples that need any.
ARGUMENTS = {"touch_window.py": ["--demo"], "read_contract.py": ["ball.vtp", "Finger", "100"]}


def run_example(script, folder):
    """Runs an example. Returns its output, or None if the example cannot run on this machine."""
    interpreter = "pvpython" if re.search(r"\./run pvpython|pvbatch", script.read_text(encoding="utf-8")) else sys.executable
    command = [interpreter, str(script), *ARGUMENTS.get(script.name, [])]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)
    except (OSError, subprocess.TimeoutExpired) as error:
        print("make.py: %s: %s" % (script.name, error), file=sys.stderr)
        return None
    if done.returncode != 0:
        print("make.py: %s failed (%d):\n%s" % (script.name, done.returncode, done.stderr[-2000:]), file=sys.stderr)
        return None
    return done.stdout


def run_examples(folder):
    """Runs the examples and stores their results in `folder`. Returns (script, text, pictures) of each that ran."""
    folder.mkdir(parents=True, exist_ok=True)
    results = []
    for script in sorted(EXAMPLES.glob("*.py")):
        kept, drawn = folder / (script.stem + ".txt"), folder / (script.stem + ".pictures")
        if not (kept.is_file() and drawn.is_file() and kept.stat().st_mtime >= script.stat().st_mtime):
            before = {path: path.stat().st_mtime_ns for path in folder.glob("*.png")}
            text = run_example(script, folder)
            if text is None:
                continue
            drawn.write_text("\n".join(path.name for path in sorted(folder.glob("*.png"))
                                       if before.get(path) != path.stat().st_mtime_ns), encoding="utf-8")
            kept.write_text(text, encoding="utf-8")
        results.append((script, kept.read_text(encoding="utf-8"), drawn.read_text(encoding="utf-8").split()))
    return results


def example_page(results):
    """Returns the end of the gallery, with the description, pictures, command and output of each example."""
    for script, text, pictures in results:
        source = script.read_text(encoding="utf-8")
        first, rest = re.search(r'"""(.*?)\n(.*?)"""', source, re.DOTALL).groups()
        command = re.search(r"^ *(\S.*%s.*?) *(?:\(.*)?$" % re.escape(script.name), rest, re.MULTILINE)
        yield "### %s\n\n%s\n" % (script.stem.replace("_", " "), first)
        for picture in pictures:
            yield '<img src="examples/%s" alt="%s"/>\n' % (picture, first.replace('"', "&quot;"))
        if command:
            yield "```\n%s\n```\n" % command.group(1)
        if text.strip():
            lines = text.rstrip().split("\n")
            yield "```\n%s\n```\n" % "\n".join(lines[:20] + (["..."] if len(lines) > 20 else []))
        yield '<a href="files/%s">%s</a>\n' % (script.relative_to(TOP), script.name)


def write_layout(path):
    """Writes Doxygen's layout, changed so that the description of a class precedes the list of its members."""
    subprocess.run(["doxygen", "-l", str(path)], check=True, stdout=subprocess.DEVNULL)
    text = path.read_text(encoding="utf-8")
    head, rest = text.split("<class>", 1)
    description = re.search(r"\n *<detaileddescription [^\n]*", rest).group()
    rest = rest.replace(description, "", 1)
    rest = re.sub(r"\n *<briefdescription [^\n]*", lambda brief: brief.group() + description, rest, count=1)
    path.write_text(head + "<class>" + rest, encoding="utf-8")


def write_pages(folder, inserted):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for page in pages():
        name = page_name(page.relative_to(TOP)) + ".md"
        (folder / name).write_text(Page(page, inserted).converted(), encoding="utf-8")


def run_doxygen(output, settings=""):
    """Runs Doxygen with the Doxyfile and additional `settings`. Returns its warnings; empty if there are none."""
    version = re.search(r"VERSION (\d[\d.]*)", (TOP / "CMakeLists.txt").read_text(encoding="utf-8").split("project(")[1])
    write_layout(output / "layout.xml")
    done = subprocess.run(["doxygen", "-"], cwd=TOP, text=True, capture_output=True, input="\n".join((
        "@INCLUDE = Plugin/Manual/Doxygen/Doxyfile",
        'OUTPUT_DIRECTORY = "%s"' % output,
        'INPUT += "%s"' % (output / "pages"),
        *('EXCLUDE += "%s"' % header.relative_to(TOP) for header in private_headers()),
        'LAYOUT_FILE = "%s"' % (output / "layout.xml"),
        "PROJECT_NUMBER = " + version.group(1),
        "HAVE_DOT = " + ("YES" if shutil.which("dot") else "NO"), settings)))
    return done.stderr.strip() or ("Doxygen failed" if done.returncode else "")


def copy_files(output):
    """Copies the examples, and the files and pictures to which pages refer."""
    named = {split_target(page, target)[0] for page in pages()
             for _, _, target in links(page.read_text(encoding="utf-8"))}
    named |= {path.relative_to(TOP) for path in EXAMPLES.glob("*.py")}
    for file in sorted(path for path in named if path and (TOP / path).is_file() and path.suffix != ".md"):
        (output / "files" / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(TOP / file, output / "files" / file)


def main(words, settings=""):
    """Runs the program. `settings` are additional settings of Doxygen, which override those of the Doxyfile."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--output", type=Path, default=TOP / "build/docs", help="default: build/docs")
    parser.add_argument("--no-examples", action="store_true", help="the gallery shows what the tree holds")
    arguments = parser.parse_args(words)
    if not shutil.which("doxygen"):
        print("make.py: doxygen is not installed", file=sys.stderr)
        return 77
    output = arguments.output.resolve()
    output.mkdir(parents=True, exist_ok=True)
    results = [] if arguments.no_examples else run_examples(output / "examples")
    write_pages(output / "pages", {"examples": "\n".join(example_page(results))})
    complaints = run_doxygen(output, settings)
    if complaints:
        print(complaints, "make.py: Doxygen had something to say", sep="\n", file=sys.stderr)
        return 1
    copy_files(output)
    print("%s, with %d of %d examples" % (output / "index.html", len(results), len(list(EXAMPLES.glob("*.py")))))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
