# SPDX-License-Identifier: BSD-3-Clause
"""Catches the messages that ParaView writes to the standard error of the process while it updates a proxy."""
import os
import sys
import tempfile


def complaint(proxy):
    with tempfile.TemporaryFile("w+") as kept:
        sys.stderr.flush()
        usual = os.dup(2)
        os.dup2(kept.fileno(), 2)
        try:
            proxy.UpdatePipeline()
        finally:
            os.dup2(usual, 2)
            os.close(usual)
        kept.seek(0)
        return kept.read()


def check_complaint(proxy, *words):
    text = complaint(proxy)
    for word in words:
        assert word in text, (word, text)
