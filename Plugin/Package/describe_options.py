#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the man page and the bash completion of `palpate` from the output of `palpate --help`.

describe_options.py PALPATE VERSION OUTPUT: writes OUTPUT/palpate.1.gz and OUTPUT/palpate (the completion).
"""

import gzip
import os
import re
import subprocess
import sys
import time

# Values of an option whose help does not list them in braces.
WORDS = {
    "--tool": "flat: sphere: paraboloid: cone: truncated: blunted: rounded: power: profile:",
    "--layer": "scan none",
    "--length-unit": "mm cm m",
    "--device": "simulated plant: replay: hid: bridge:",
    "--fixed": "x- x+ y- y+ z- z+",
}

NAMES = re.compile(r"\s+((?:(?:-\w|--?!?[a-z][\w-]*)(?:\{\w+\})?,?\s*)+)(.*)")


class Option:
    """An option with its names, the type of its value ("" for a flag), its default and its description."""

    def __init__(self, names, spec):
        """`spec` is the text between names and description, such as "FLOAT:POSITIVE=2 Needs: --voxel"."""
        self.names = names
        self.text = ""
        spec, *self.excluded = re.split(r" *\bExcludes: ", spec)
        spec, *self.needed = re.split(r" *\bNeeds: ", spec)
        # CLI11 2.1 writes the default as "=1", CLI11 2.4 as " [1]".
        spec, *default = re.split(r"=| (?=\[[^\]]*\] ?$)(?<!in )", spec.strip().removesuffix(" ..."), maxsplit=1)
        self.type = spec
        self.default = default[0].strip("[] ") if default else ""

    def words(self):
        """Returns the possible values. The list is empty if any value is possible."""
        listed = re.search(r"\{([^}]*)\}", self.type)
        for name in self.names:
            if name in WORDS:
                return WORDS[name].split()
        return listed.group(1).split(",") if listed else []

    def is_number(self):
        return self.type.startswith(("FLOAT", "INT", "UINT"))

    def value(self):
        """Returns the value in the form of the man page."""
        kind = self.type.removeprefix("TEXT:")
        if not self.type or re.fullmatch(r"[\w:|,]+", kind) and self.type.startswith("TEXT"):
            return kind
        return "|".join(self.words()) or ("NUMBER" if self.is_number() else kind)

    def description(self):
        text = self.text
        span = re.search(r"in \[(\S+) - (\S+)\]", self.type)
        for said, sentence in (("POSITIVE", "More than 0."), ("NONNEGATIVE", "Not less than 0.")):
            if re.search(rf":{said}\b", self.type):
                text += f". {sentence}"
        if span:
            text += f". From {span.group(1)} to {span.group(2)}."
        for said, options in (("Needs", self.needed), ("Not with", self.excluded)):
            if options:
                text = f"{text.removesuffix('.')}. {said} {options[0].replace(' ', ', ')}."
        return f"{text.removesuffix('.')}. Default: {self.default}." if self.default else text


def read_help(text):
    """Returns the options, and the paragraphs after them as (heading, lines)."""
    options, paragraphs, reading = [], [], False
    for line in text.splitlines():
        if re.fullmatch(r"options:", line, re.IGNORECASE):
            reading = True
        elif reading and re.match(r"\s+-", line):
            names, rest = NAMES.fullmatch(line).groups()
            has_value = not (names.endswith("  ") or not rest)
            value, _, described = rest.partition("  ") if has_value else ("", "", rest)
            names = [re.sub(r"\{\w+\}|!", "", name) for name in re.split(r",\s*|\s+", names) if name]
            options.append(Option(names, value.strip()))
            options[-1].text = described.strip()
        elif reading and line.startswith("    "):
            options[-1].text = f"{options[-1].text} {line.strip()}".strip()
        elif line.strip() and options:
            reading = False
            heading = re.match(r"([A-Z]\w+): *(.*)", line)
            if heading:
                paragraphs.append((heading.group(1), [heading.group(2)] if heading.group(2) else []))
            else:
                paragraphs[-1][1].append(line)
    return options, paragraphs


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def manual(template, options, paragraphs, version):
    described = []
    for option in options:
        names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option.names)
        value = f" \\fI{roff(option.value())}\\fR" if option.type else ""
        described += [".TP", names + value, roff(option.description())]
    sections = []
    for heading, lines in paragraphs:
        heading = "FILE FORMATS" if heading == "Files" else heading.upper()
        sections.append(f".SH {heading}")
        if heading == "EXAMPLES":
            sections += [".nf", *(roff(line) for line in lines), ".fi"]
        else:
            sections += [roff(line) for line in lines]
    seconds = int(os.environ.get("SOURCE_DATE_EPOCH", time.time()))
    for name, value in (("DATE", time.strftime("%Y-%m-%d", time.gmtime(seconds))), ("VERSION", version),
                        ("OPTIONS", "\n".join(described)), ("SECTIONS", "\n".join(sections))):
        template = template.replace(f"@{name}@", value)
    return template


def completion(options):
    cases = []
    for option in options:
        if not option.type:
            continue
        wanted = f'-W "{" ".join(option.words())}"' if option.words() else "-f"
        offered = "" if option.is_number() and not option.words() else f'$(compgen {wanted} -- "$word")'
        cases.append(f"    {'|'.join(option.names)}) COMPREPLY=({offered}); return ;;")
    names = " ".join(name for option in options for name in option.names)
    return "\n".join([
        "# bash completion of palpate; made from palpate --help",
        "_palpate()",
        "{",
        "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}",
        "  case $before in",
        *cases,
        "  esac",
        "  if [[ $word == -* ]]; then",
        f'    COMPREPLY=($(compgen -W "{names}" -- "$word"))',
        "  else",
        '    COMPREPLY=($(compgen -f -- "$word"))',
        "  fi",
        "}",
        "complete -o filenames -F _palpate palpate",
        ""])


def main(program, version, output):
    text = subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout
    options, paragraphs = read_help(text)
    if not options:
        sys.exit(f"{program} --help shows no options")
    os.makedirs(output, exist_ok=True)
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "palpate.1.in"), encoding="utf-8") as file:
        page = manual(file.read(), options, paragraphs, version)
    with open(os.path.join(output, "palpate.1.gz"), "wb") as file:
        file.write(gzip.compress(page.encode(), 9, mtime=0))
    with open(os.path.join(output, "palpate"), "w", encoding="utf-8") as file:
        file.write(completion(options))


if __name__ == "__main__":
    main(*sys.argv[1:])
