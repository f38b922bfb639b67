# SPDX-License-Identifier: BSD-3-Clause
"""The words that name a choice. The program and ParaView have the same ones."""

OLDER = {"neohooke": "neo-hooke", "normalized": "normalized-direction", "energy": "energy-consistent",
         "shape": "shape-derived"}                     # still read


def value_of(word, choices, argument):
    """The value of a word, or of an older word for the same; ValueError with the words if there is none."""
    known = OLDER.get(word, word) if isinstance(word, str) else word
    if known not in choices:
        raise ValueError("%s must be one of %s, but is %r" % (argument, ", ".join(map(repr, choices)), word))
    return choices[known]
