# SPDX-License-Identifier: BSD-3-Clause
"""Types of the arguments of the functions on arrays, for type checkers.

VTK in Debian has no type stubs. With this VTK, a type checker accepts any value for a class of VTK.
"""
import os
from typing import Any, Literal, Protocol, Sequence, Tuple, Union

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from .palpateResponse import vtkContactTool


class Wrapped(Protocol):
    """A wrapper of a data set, such as vtkmodules.numpy_interface.dataset_adapter.PolyData."""

    VTKObject: Any


File = Union[str, os.PathLike[str]]
Reals = Union[np.ndarray, Sequence[Any]]                # numbers, or sequences of numbers for more than one dimension
PerPoint = Union[float, str, Reals]                     # a number, the name of a point array, or a value per point
Body = Union[vtkDataObject, vtkAlgorithm, vtkAlgorithmOutput, Wrapped, Tuple[Reals, Reals], File]
Tool = Union[str, vtkContactTool]
Layer = Union[Tuple[PerPoint, float, float], Tuple[PerPoint, float, float, bool]]
Base = Union[Literal["bonded", "slip"], Tuple[Literal["elastic"], float, float]]
Strain = Union[Literal["small", "neo-hooke", "neohooke"], Tuple[Literal["ogden", "demiray"], float]]
