# SPDX-License-Identifier: BSD-3-Clause
"""The body of palpate.response(..., tissues=...): a segmentation filled with tetrahedra, solved by finite elements."""
from __future__ import annotations

from typing import Any, Callable, Mapping, Optional

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from . import _arrays, _filters
from ._bodies import as_labels

# Arguments of palpate.response that have no meaning for finite elements of tissues.
REFUSED = ("young", "poisson", "layer", "base", "layers", "compliance", "compliance_excludes_layer", "curvature", "automatic",
           "compliance_relaxes", "coupling", "points")


def refuse(given: Mapping[str, Any], defaults: Mapping[str, Any]) -> None:
    """Raises ValueError if one of the REFUSED arguments differs from its default."""
    for name in REFUSED:
        value, usual = given[name], defaults[name]
        if value is not usual and (np.ndim(value) > 0 or value != usual):
            raise ValueError("%s cannot be combined with tissues: the body is solved by finite elements of its tissues" % name)


def fill(body: Any, tissues: Mapping[float, Any], spacing: float, fixed: str, progress: Optional[Callable[[str, float], Any]]):
    """Fills the tissues with tetrahedra. Returns the updated filter vtkSegmentedBody."""
    try:
        from .palpateSolidResponse import vtkSegmentedBody
    except ImportError as missing:
        raise ImportError("tissues need the module Solids, which this build of palpate lacks (%s)" % missing) from None
    made = vtkSegmentedBody()
    made.SetInputData(as_labels(body))
    if not isinstance(tissues, Mapping):
        raise TypeError("tissues must be a dictionary {label: (young, poisson)}, but is %r" % (tissues,))
    for label, material in tissues.items():
        if not isinstance(material, (tuple, list)) or len(material) != 2:
            raise ValueError("tissues[%r] must be (young in MPa, poisson), but is %r" % (label, material))
        made.AddTissue(_arrays.number(label, "tissues: a label"), _arrays.number(material[0], "tissues[%r]: young (MPa)" % label),
                       _arrays.number(material[1], "tissues[%r]: poisson" % label))
    made.SetSurfaceSpacing(_arrays.number(spacing, "spacing (mm)"))
    made.SetFixedFaces(fixed)
    return _filters.run(made, progress=_steps(progress, "filling the tissues"))


def press(solid: Any, setting: Callable[[Any], Any], progress: Optional[Callable[[str, float], Any]]) -> vtkPolyData:
    """Returns the responses on the solid. `setting` sets tool and terms; it returns objects whose errors are raised."""
    from .palpateSolidResponse import vtkElasticContactResponse

    felt = vtkElasticContactResponse()
    felt.SetInputData(solid.GetOutput())
    for index, name in enumerate(("YoungsModulus", "PoissonRatio")):
        felt.SetInputArrayToProcess(index, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, name)
    others = setting(felt)
    # Every body is held at some points, and these points have no response.
    return _filters.run(felt, others=others, progress=_steps(progress, "solving"), expected="points have no response").GetOutput()


def _steps(progress, step):
    return None if progress is None else lambda done: progress(step, done)
