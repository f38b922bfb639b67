# SPDX-License-Identifier: BSD-3-Clause
"""palpate.measured: the response of any tool from force-deflection curves measured with other tools."""
from __future__ import annotations

import os
from typing import Any, Dict, List, Literal, NamedTuple, Optional, Sequence, Union

from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _arrays, _filters
from ._bodies import as_body
from ._response import _count, _text, _tool
from ._types import Body, File, Tool

MODELS = ("half-space", "compliance", "layer")


class Measured(NamedTuple):
    """The body identified from measured curves. See palpate.measured."""

    body: vtkPolyData
    sites: List[Dict[str, Any]]


def measured(body: Body, files: Union[File, Sequence[File]], tool: Tool = "sphere:5",
             model: Optional[Literal["half-space", "compliance", "layer"]] = None, poisson: float = 0.45,
             maximum_strain: float = 0.4, reach: float = 20.0, registration: Optional[File] = None,
             maximum_deflection: float = 2.0, samples: int = 8, name: str = "Response") -> Measured:
    """Attaches the curve of a tool to each point of a body around measured sites.

    The curve is computed from curves that were measured at these sites with other tools.

    Parameters
    ----------
    body, tool, maximum_deflection (mm), samples, name : as in palpate.response.
    files : the name of a file of curves, or a sequence of names. Each file contains the curves of one tool, as .csv with
        the columns site, x_mm, y_mm, z_mm, deflection_mm and force_N, and the head '# tool: sphere:6.35'.
    model : "half-space", "compliance" (in series with a half-space) or "layer", if the model is known. None means the
        simplest model that explains the readings.
    poisson : Poisson's ratio of a layer, 0 to 0.5.
    maximum_strain : largest ratio of contact radius to tip radius at which readings are used. The Remark of a site gives
        the number of readings that are not used.
    reach : largest distance of a point from a site that determines the response of the point, mm.
    registration : the name of a file that maps the frame of the curves to the frame of the body, or None.

    Returns
    -------
    Measured, a tuple:
        body : the body with the arrays of palpate.response;
        sites : a dictionary for each site, with the results of vtkMeasuredContactResponse. The keys are Verdict, Model,
            Remark, and 'ReducedModulus (MPa)' and others with their 95 % intervals (' from', ' to' before the unit).

    Raises ValueError with the message of vtkMeasuredContactResponse, also if no site can be used; TypeError for arguments
    of another type. Refused sites cause a RuntimeWarning. Runs on all threads; a site takes about 0.1 s.
    """
    from .palpateMeasuredResponse import vtkMeasuredContactResponse  # the build may lack this module

    made = vtkMeasuredContactResponse()
    made.SetInputData(as_body(body))
    for file in [files] if isinstance(files, (str, os.PathLike)) else files:
        made.AddFileName(_text(os.fspath(file) if isinstance(file, os.PathLike) else file, "files"))
    kind = _tool(tool)
    made.SetTool(kind)
    if model is not None and model not in MODELS:
        raise ValueError("model must be one of %s, or None, but is %r" % (", ".join(map(repr, MODELS)), model))
    made.SetBodyModel(0 if model is None else 1 + MODELS.index(model))
    made.SetPoissonRatio(_arrays.number(poisson, "poisson"))
    made.SetMaximumStrain(_arrays.number(maximum_strain, "maximum_strain"))
    made.SetReach(_arrays.number(reach, "reach (mm)"))
    if registration is not None:
        made.SetRegistrationFile(_text(os.fspath(registration), "registration"))
    made.SetMaximumDeflection(_arrays.number(maximum_deflection, "maximum_deflection (mm)"))
    made.SetNumberOfSamples(_count(samples, "samples"))
    made.SetResponseName(_text(name, "name"))
    _filters.run(made, others=[kind])
    table = made.GetOutputDataObject(1)
    columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
    return Measured(made.GetOutput(), [{column.GetName(): column.GetValue(row) for column in columns}
                                       for row in range(table.GetNumberOfRows())])
