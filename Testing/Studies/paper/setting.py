# SPDX-License-Identifier: BSD-3-Clause
"""The data of Mahvash and Hayward (2002) about their tests, section 4, and the three tools as objects."""
import collections

from palpate import vtkContactTool

# The paper states diameters. Colours by Okabe and Ito, which colour-blind readers can distinguish.
Tool = collections.namedtuple("Tool", "name key specification table1 colour dash")
LARGE = Tool("sphere, 12.7 mm", "sphere12.7", "sphere:6.35", "paraboloid:6.35", "#0072B2", "-")
SMALL = Tool("sphere, 3.2 mm", "sphere3.2", "sphere:1.6", "paraboloid:1.6", "#D55E00", "--")
FLAT = Tool("flat, 3.2 mm", "flat3.2", "flat:1.6", "flat:1.6", "#009E73", "-.")
TOOLS = (LARGE, FLAT, SMALL)

RUBBER = 3.45          # E*, MPa, identified in section 4.2
LARGEST_FORCE = 12.0   # N, up to which the fit holds, section 4.2
SLIDING_FORCE = 14.0   # N, section 4.4
FRICTION_FORCE = 7.0   # N, section 4.4
LIVER = 10.0           # mm, section 4.3
SPEED = 1.0            # mm/s, section 4


def contact_tool(specification):
    tool = vtkContactTool()
    if not tool.SetSpecification(specification):
        raise ValueError(specification)
    return tool


def root(function, low, high):
    """Returns the root of a rising function, to rounding, by bisection."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return 0.5 * (low + high)


def half_space_depth(tool, force, modulus=RUBBER):
    """Returns the depth (mm) at which the force of a tool on a half-space is `force`."""
    deepest = 1.0
    while tool.GetForce(deepest, modulus) < force:
        deepest *= 2.0
    return root(lambda depth: tool.GetForce(depth, modulus) - force, 0.0, deepest)
