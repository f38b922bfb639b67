# SPDX-License-Identifier: BSD-3-Clause
"""numpy arrays to VTK and back, in the same memory where that can be.

A VTK array made of a numpy array keeps that alive as long as it lives itself (an attribute of it, as VTK's own
numpy_support does); a numpy array made of a VTK array keeps that. Copied is what VTK cannot read: numbers of other
types, rows that do not follow one another, memory that may not be written.
"""
import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray


def to_vtk(array, name=None):
    """A VTK array of a contiguous numpy array of one or two dimensions."""
    made = numpy_support.numpy_to_vtk(array)
    if name is not None:
        made.SetName(name)
    return made


def to_points(array):
    """vtkPoints of an (n, 3) array."""
    points = vtkPoints()
    points.SetData(to_vtk(array))
    return points


def to_cells(connectivity, size):
    """vtkCellArray of cells of `size` points each, of an array of int32 or int64."""
    cells = vtkCellArray()
    ends = np.arange(0, connectivity.size + 1, size, dtype=connectivity.dtype)
    flat = connectivity.reshape(-1)
    cells.SetData(to_vtk(ends), to_vtk(flat))
    # It has made arrays of its own in the same memory: these are to keep that alive.
    cells.GetOffsetsArray()._numpy_reference = ends
    cells.GetConnectivityArray()._numpy_reference = flat
    return cells


def to_numpy(array):
    return numpy_support.vtk_to_numpy(array)


def reals(values, argument, shape):
    """`values` as floats of that shape, None standing for any number; the same memory if it can be."""
    try:
        given = np.asarray(values)
        array = given if given.dtype in (np.float32, np.float64) else given.astype(np.float64, casting="same_kind")
    except (TypeError, ValueError):
        raise TypeError("%s must be numbers, but is %s" % (argument, _kind(values))) from None
    if array.ndim != len(shape) or any(want is not None and want != have for want, have in zip(shape, array.shape)):
        raise ValueError("%s must have shape %s, but has %s" % (argument, _shape(shape), _shape(array.shape)))
    return np.require(array, requirements="CW")


def indices(values, argument, columns):
    """`values` as whole numbers, rows of so many columns; the same memory if it can be."""
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise TypeError("%s must be whole numbers (of points, from 0), but are %s" % (argument, _kind(values)))
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError("%s must have shape %s, but has %s" %
                         (argument, _shape((None, columns)), _shape(array.shape)))
    if array.dtype not in (np.int32, np.int64):
        array = array.astype(np.int64)
    return np.require(array, requirements="CW")


def _shape(shape):
    return "(%s)" % (", ".join("n" if size is None else str(size) for size in shape) + ("," if len(shape) == 1 else ""))


def _kind(values):
    return "an array of %s" % values.dtype if isinstance(values, np.ndarray) else repr(values)[:60]
