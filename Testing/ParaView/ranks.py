# SPDX-License-Identifier: BSD-3-Clause
"""Compares a body in pieces on several ranks with the whole body bit by bit, for parallel.py.

The triangles are compared as a multiset. Each triangle is represented by the coordinates of its corners, beginning
with the smallest, and by the values of the arrays there. A sum over the surface therefore has the same terms on any
number of ranks, in another order.
"""
import math
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

EPS = np.finfo(float).eps


def array_of(data, name):
    values = vtk_to_numpy(data.GetPointData().GetArray(name)).astype(float)     # exact, because the values are floats
    return values.reshape(data.GetNumberOfPoints(), -1)


def triangles_of(data, names=()):
    """Rows of x, y, z and the arrays' components for each of the three corners; sorted."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    columns = np.hstack([points + 0.0] + [array_of(data, name) for name in names])
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    assert len(corners) == data.GetNumberOfCells()
    least = np.argmin(np.unique(points, axis=0, return_inverse=True)[1].reshape(-1)[corners], axis=1)
    turned = np.take_along_axis(corners, (least[:, None] + np.arange(3)) % 3, axis=1)
    rows = columns[turned].reshape(len(corners), -1)
    return rows[np.lexsort(rows.T)], corners


def inner_points(data):
    """Indices, and coordinates as bytes, of the points that lie in only one piece."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float) + 0.0
    _, first, count = np.unique(points, axis=0, return_index=True, return_counts=True)
    return {points[i].tobytes(): i for i in first[count == 1]}


def terms(data):
    """Area (mm2) of each triangle times the mean of the peak force (N) at its corners, and times the mean of their
    energy (N mm)."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    force, reach = array_of(data, "ResponseForce"), array_of(data, "ResponseRange")
    samples = force.shape[1]
    depth = np.hstack([np.zeros_like(reach), reach * (np.arange(1, samples + 1) / samples) ** 2])
    whole = np.hstack([np.zeros_like(reach), force])
    energy = np.sum(0.5 * (whole[:, 1:] + whole[:, :-1]) * np.diff(depth, axis=1), axis=1)
    a, b, c = (points[corners[:, k]] for k in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return [area * value[corners].mean(axis=1) for value in (force[:, -1], energy)]


def check_bits(pieces, serial, everywhere, inside=()):
    """The arrays `everywhere` are bitwise equal to those of the serial body at all points, the arrays `inside` at
    points that are on no seam."""
    found, _ = triangles_of(pieces, everywhere)
    expected, _ = triangles_of(serial, everywhere)
    assert found.shape == expected.shape, (found.shape, expected.shape)
    assert found.tobytes() == expected.tobytes(), "%d of %d triangles differ" % (
        (found != expected).any(axis=1).sum(), len(expected))
    here, there = inner_points(pieces), inner_points(serial)
    assert len(there) == serial.GetNumberOfPoints() and here.keys() <= there.keys() and len(here) > len(there) // 2
    for name in inside:
        one, other = array_of(pieces, name), array_of(serial, name)
        differ = [k for k, i in here.items() if one[i].tobytes() != other[there[k]].tobytes()]
        assert not differ, "%s differs at %d of %d points" % (name, len(differ), len(here))


def check_sums(pieces, serial):
    """The sums of peak force and energy over the surface. A term has at most 20 rounding errors, and a sum of n terms
    in any order has n - 1. Therefore two sums differ by at most 2 (n + 20) eps times the sum of the magnitudes of the
    terms."""
    for found, expected in zip(terms(pieces), terms(serial)):
        bound = 2 * (len(expected) + 20) * EPS * np.abs(expected).sum()
        off = abs(np.cumsum(found)[-1] - np.cumsum(expected)[-1]) # cumsum adds the terms one after the other
        assert off <= bound, (off, bound)
        assert abs(math.fsum(found) - math.fsum(expected)) <= 40 * EPS * np.abs(expected).sum()
