# SPDX-License-Identifier: BSD-3-Clause
"""palpate.curves: the stored force-deflection curves of points."""
from __future__ import annotations

from typing import NamedTuple, Optional, Union

import numpy as np

from . import _arrays, contract
from ._bodies import as_body
from ._types import Body, Reals


class Curves(NamedTuple):
    """Force-deflection curves of p points at d depths. See palpate.curves."""

    deflection: np.ndarray
    force: np.ndarray
    stiffness: np.ndarray
    error: np.ndarray


def _error(array, ranges, points, depths):
    """Returns the error. Between samples it is linear in the square root of the depth; below the first sample it is
    constant. Without an array it is NaN."""
    points, depths = np.broadcast_arrays(points, depths)
    if array is None:
        return np.full(depths.shape, np.nan)
    stored = _arrays.to_numpy(array).astype(float)[points]
    with np.errstate(all="ignore"):
        place = np.maximum(np.sqrt(np.maximum(depths, 0) / ranges[points]) * stored.shape[-1] - 1, 0)
    low = np.clip(np.nan_to_num(place).astype(int), 0, stored.shape[-1] - 1)
    high = np.minimum(low + 1, stored.shape[-1] - 1)
    below, above = (np.take_along_axis(stored, at[..., None], -1)[..., 0] for at in (low, high))
    return below + (place - low) * (above - below)


def curves(body: Body, points: Optional[Union[int, Reals]] = None, deflection: Optional[Union[float, Reals]] = None,
           rows: int = 101, name: str = "Response") -> Curves:
    """Returns the stored force-deflection curves of points of a body.

    Parameters
    ----------
    body : a body with a response, as palpate.response returns it, or a saved body, "body.vtp".
    points : indices of points, as one number or an array of shape (p,); None means all points.
    deflection : depths, mm, shape (d,) or one number; None means `rows` depths from 0 to the largest range.
    rows : number of depths if deflection is None; at least 2.
    name : prefix of the response arrays.

    Returns
    -------
    Curves, a tuple of float64 arrays:
        deflection (d,) : mm;
        force (p, d) : N; NaN beyond the range of a point and where a point has no response;
        stiffness (p, d) : dF/d(deflection), N/mm; NaN as for the force;
        error (p, d) : estimated relative error of the force; NaN as for the force, and if the response stores no error.
    If `points` is a single number, the arrays have one row only, shape (d,).

    Raises ValueError for a body without the response, or for missing points; TypeError for arguments of another type.
    Uses palpate.contract, on one thread; a value takes about 0.5 microseconds.
    """
    body = as_body(body)
    try:
        stored = contract.load(body, name)
    except KeyError as missing:
        raise ValueError("no response '%s' on the body: %s" % (name, missing.args[0])) from None
    _arrays.refuse_masked(points, "points")
    chosen = np.arange(body.GetNumberOfPoints()) if points is None else np.asarray(points)
    if chosen.dtype.kind not in "iu" or chosen.ndim > 1:
        raise TypeError("points must be whole numbers, one or an array of shape (n,), but are %r" % (points,))
    for point in chosen[(chosen < 0) | (chosen >= body.GetNumberOfPoints())].reshape(-1)[:1]:
        raise ValueError("there is no point %d: the body has %d points" % (point, body.GetNumberOfPoints()))
    usable = np.isin(stored["status"][chosen], (0, 5)) & (stored["range"][chosen] > 0)
    reach = np.where(usable, stored["range"][chosen], 0.0)
    if deflection is None:
        if rows < 2:
            raise ValueError("rows must be at least 2, but is %r" % (rows,))
        deflection = np.linspace(0.0, reach.max(initial=0.0), rows)
    depths = np.atleast_1d(_arrays.reals(deflection, "deflection (mm)", np.shape(deflection)[:1])).astype(float)
    force, stiffness = contract.evaluate(stored, chosen[..., None], depths)
    beyond = ~(depths <= reach[..., None]) | ~usable[..., None]
    error = _error(body.GetPointData().GetArray(name + "Error"), stored["range"], chosen[..., None], depths)
    return Curves(depths, *(np.where(beyond, np.nan, values) for values in (force, stiffness, error)))
