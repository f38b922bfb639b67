# SPDX-License-Identifier: BSD-3-Clause
"""The default response of a closed surface: the law of contact in series with the compliance of the whole body."""
import numpy as np
import palpate
from vtkmodules.util.numpy_support import vtk_to_numpy

TOOLS = ("sphere:6.35", "flat:1.6", "sphere:1.6")  # the widest first: the others reuse its solution
SMALL = "Small"  # prefix of responses at small strain


def press(body, depth=1.0, tolerance=0.05, poisson=0.45):
    """Returns the body with two responses of each tool, and the faces that hold the body. The name of the response with
    Neo-Hooke is the tool; that of the response at small strain is SMALL and the tool. Raises ValueError if no compliance is
    found."""
    made = body
    for tool in TOOLS:
        for name in (tool, SMALL + tool):
            made = palpate.response(made, tool=tool, young=0.05, poisson=poisson, maximum_deflection=depth, compliance=True,
                                    strain="neohooke" if name == tool else "small", error_tolerance=tolerance, name=name)
        model = made.GetFieldData().GetAbstractArray(tool + "Model").GetValue(0)
        if "held at " not in model:
            raise ValueError("has no compliance of the whole body")
    return made, model.split("held at ")[1].split(";")[0].split(",")[0].strip()
