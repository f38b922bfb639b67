# SPDX-License-Identifier: BSD-3-Clause
"""Converts numpy arrays to VTK and back, in the same memory if possible.

A VTK array made from a numpy array keeps the numpy array alive (by an attribute, as in VTK's own numpy_support), and
vice versa. Arrays that VTK cannot read are copied: other types of numbers, rows that are not contiguous, read-only
memory.
"""
import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray


def to_vtk(array, name=None):
    """Returns a VTK array from a contiguous numpy array of one or two dimensions."""
    made = numpy_support.numpy_to_vtk(array)
    if name is not None:
        made.SetName(name)
    return made


def to_points(array):
    """Returns vtkPoints from an (n, 3) array."""
    points = vtkPoints()
    points.SetData(to_vtk(array))
    return points


def to_cells(connectivity, size):
    """Returns a vtkCellArray of cells of `size` points each, from an array of int32 or int64."""
    cells = vtkCellArray()
    ends = np.arange(0, connectivity.size + 1, size, dtype=connectivity.dtype)
    flat = connectivity.reshape(-1)
    cells.SetData(to_vtk(ends), to_vtk(flat))
    # VTK has made separate array objects for the same memory. These objects must keep the memory alive.
    cells.GetOffsetsArray()._numpy_reference = ends
    cells.GetConnectivityArray()._numpy_reference = flat
    return cells


def to_numpy(array):
    return numpy_support.vtk_to_numpy(array)


def reals(values, argument, shape):
    """Returns `values` as floats of the given shape (None for any number), in the same memory if possible."""
    refuse_masked(values, argument)
    try:
        given = np.asarray(values)
        array = given if given.dtype in (np.float32, np.float64) else given.astype(np.float64, casting="same_kind")
    except (TypeError, ValueError):
        raise TypeError("%s must be numbers, but is %s" % (argument, _kind(values))) from None
    if array.ndim != len(shape) or any(want is not None and want != have for want, have in zip(shape, array.shape)):
        raise ValueError("%s must have shape %s, but has %s" % (argument, _shape(shape), _shape(array.shape)))
    return np.require(array, requirements="CW")


def indices(values, argument, columns):
    """Returns `values` as whole numbers in rows of `columns` numbers, in the same memory if possible."""
    refuse_masked(values, argument)
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise TypeError("%s must be whole numbers (of points, from 0), but are %s" % (argument, _kind(values)))
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError("%s must have shape %s, but has %s" %
                         (argument, _shape((None, columns)), _shape(array.shape)))
    if array.dtype not in (np.int32, np.int64):
        array = array.astype(np.int64)
    return np.require(array, requirements="CW")


def refuse_masked(values, argument):
    """Raises ValueError for masked values: VTK ignores masks and would use the number under the mask."""
    if np.ma.is_masked(values):
        mask = np.ma.getmaskarray(values)
        raise ValueError("%s: %d of %d values are masked, the first at %s; give a number for each, as by filled(), or "
                         "leave out what they belong to" % (argument, mask.sum(), mask.size, _place(mask)))


def _place(mask):
    first = tuple(map(int, np.argwhere(mask)[0]))
    return first[0] if len(first) == 1 else first


def _shape(shape):
    return "(%s)" % (", ".join("n" if size is None else str(size) for size in shape) + ("," if len(shape) == 1 else ""))


def _kind(values):
    return "an array of %s" % values.dtype if isinstance(values, np.ndarray) else repr(values)[:60]


def number(value, argument):
    if isinstance(value, (str, bytes)):
        raise TypeError("%s must be a number, but is %r" % (argument, value))
    try:
        return float(value)
    except (TypeError, ValueError):
        raise TypeError("%s must be a number, but is %r" % (argument, value)) from None
