#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Converts a C header for Doxygen. Plain comments become comments of Doxygen, and the first one becomes the comment of
the file. A comment after code belongs to the preceding declaration.

    filter_c_header.py FILE
"""
import re
import sys


def mark(text):
    kinds = iter(["/** @file\n"])

    def marked(match):
        before, comment = match.groups()
        if "SPDX" in comment or "NOLINT" in comment:
            return match.group()
        return before + ("/**<" if before.strip() else next(kinds, "/**")) + comment

    return re.sub(r"([^\n]*?)/\*(.*?\*/)", marked, text, flags=re.DOTALL)


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    with open(sys.argv[1], encoding="utf-8") as header:
        print(mark(header.read()), end="")
