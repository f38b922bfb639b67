# SPDX-License-Identifier: BSD-3-Clause
"""The words for the values of a choice. The program and ParaView use the same words."""

OLDER = {"neohooke": "neo-hooke", "normalized": "normalized-direction", "energy": "energy-consistent",
         "shape": "shape-derived"}                     # earlier words, which are still accepted


def value_of(word, choices, argument):
    """Returns the value of a word, or of an earlier word for the same value. Raises ValueError with the list of words for
    an unknown word."""
    known = OLDER.get(word, word) if isinstance(word, str) else word
    if known not in choices:
        raise ValueError("%s must be one of %s, but is %r" % (argument, ", ".join(map(repr, choices)), word))
    return choices[known]
