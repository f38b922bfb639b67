#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A C header for Doxygen: its plain comments become Doxygen's, the first one that of the file. Behind code a comment
belongs to what stands before it.

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
