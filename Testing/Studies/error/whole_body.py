# SPDX-License-Identifier: BSD-3-Clause
"""What a user gets for a closed surface: the law of contact in series with the compliance of the whole body."""
import numpy as np
import palpate
from vtkmodules.util.numpy_support import vtk_to_numpy

TOOLS = ("sphere:6.35", "flat:1.6", "sphere:1.6")  # the widest first: the others reuse its solution
SMALL = "Small"  # prefix of responses at small strain


def press(body, depth=1.0, tolerance=0.05, poisson=0.45):
    """The body with a response of each tool with Neo-Hooke's strain, called by the tool, and at small strain, called SMALL and
    the tool; and the faces that hold the body. ValueError where the compliance is not found."""
    made = body
    for tool in TOOLS:
        for name in (tool, SMALL + tool):
            made = palpate.response(made, tool=tool, young=0.05, poisson=poisson, maximum_deflection=depth, compliance=True,
                                    strain="neohooke" if name == tool else "small", error_tolerance=tolerance, name=name)
        model = made.GetFieldData().GetAbstractArray(tool + "Model").GetValue(0)
        if "held at " not in model:
            raise ValueError("has no compliance of the whole body")
    return made, model.split("held at ")[1].split(";")[0].split(",")[0].strip()
