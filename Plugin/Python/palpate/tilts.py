# SPDX-License-Identifier: BSD-3-Clause
"""The effect of a tool's tilt on its force, from the arrays of the response, evaluated in numpy; see palpate.contract.

W0(D) is the work of pressing the upright tool to the depth D. The work of the tilted tool is W = W0(D) tau(D, theta) with
D = tip depth + h(theta). Then F = dW/dD, and M = dW/dtheta at constant tip depth. tau = rho eta: eta is the bicubic
Hermite interpolant of nodes in x = sqrt(D/range) and y = theta/largest. rho is 1 or, for a tool with a flat end
(scale > 0), the factor of a flat end on a half-space, at scale h/D. Units are mm, N, rad, N mm.
"""
import numpy as np

from .contract import _fetch


def load(body, prefix="Response"):
    """Reads the table of tilts as a dictionary. Returns None for a response without tilts.

    The keys are range, largest, scale, drops (k x 2: h and dh/dtheta), nodes (laws x depths x angles x 4) and weights
    (points x laws, or None)."""
    points, field = body.GetPointData(), body.GetFieldData()
    fetch = lambda data, name: _fetch(data, prefix + name, True)
    terms = fetch(field, "Tilt")
    if terms is None:
        return None
    span, largest, scale, depths, angles, _, laws = terms.ravel()
    weights = fetch(points, "TiltWeight")
    return {"range": span, "largest": largest, "scale": scale, "drops": fetch(field, "TiltDrop").reshape(-1, 2),
            "nodes": fetch(field, "TiltNode").reshape(int(laws), int(depths), int(angles), 4),
            "weights": None if weights is None else weights.reshape(-1, int(laws)).astype(float)}


def deepest(table, angle):
    """Returns the depth h (mm) of the tool's deepest point below the tip, and its lateral distance dh/dtheta (mm)."""
    drops, last = table["drops"], len(table["drops"]) - 1
    place = np.clip(angle / table["largest"], 0.0, 1.0) * last
    i = np.minimum(place.astype(int) if np.ndim(place) else int(place), last - 1)
    step, t = table["largest"] / last, place - i
    a, da, b, db = drops[i, 0], step * drops[i, 1], drops[i + 1, 0], step * drops[i + 1, 1]
    h = (2*t**3 - 3*t**2 + 1) * a + (t**3 - 2*t**2 + t) * da + (3*t**2 - 2*t**3) * b + (t**3 - t**2) * db
    offset = ((6*t**2 - 6*t) * (a - b) + (3*t**2 - 4*t + 1) * da + (3*t**2 - 2*t) * db) / step
    return h, np.where(np.asarray(angle) > table["largest"], 0.0, offset)


def factor(table, depth, angle, point=0):
    """Returns the factor tau at a depth of the deepest point (mm), a tilt (rad) and a point number; all are scalars."""
    weights = np.ones(1) if table["weights"] is None else table["weights"][point]
    nodes = np.tensordot(weights, table["nodes"], 1)
    i, along_x = _cell(np.sqrt(depth / table["range"]), nodes.shape[0])
    j, along_y = _cell(angle / table["largest"], nodes.shape[1])
    corners = nodes[i:i + 2, j:j + 2]                          # nodes in x, y: eta and its derivatives by x, y and both
    eta = float(np.einsum("ijk,ik,jk->", corners, along_x[:, [0, 1, 0, 1]], along_y[:, [0, 0, 1, 1]]))
    return eta if table["scale"] == 0.0 else eta * flat_end(table["scale"] * deepest(table, angle)[0] / depth)


# Coefficients of z, z^2, ..., fitted to boundary elements; see Data/Reference/tilt.
RIM = (0.21967052817978971, 1.3781689290941161, -6.757712350273644, 25.83380523956624, -62.31965296945057,
       92.52030735421076, -81.92991590971977, 39.62429688339708, -8.050449186485492)


def flat_end(s):
    """Returns W/W0 of a flat end on a half-space; s is three times the rim's drop over the depth. Contact is full up to
    s = 1."""
    if s <= 1.0:
        return 1.0 - 2.0 / 3.0 * s + 5.0 / 27.0 * s**2
    z = 1.0 / np.sqrt(s)
    return sum(term * z**(k + 1) for k, term in enumerate(RIM))


def _cell(place, count):
    """Returns the lower node, and the Hermite basis (value and slope) at this node and at the next."""
    place = min(max(place, 0.0), 1.0) * (count - 1)
    i = min(int(place), count - 2)
    t, width = place - i, 1.0 / (count - 1)
    return i, np.array([[2*t**3 - 3*t**2 + 1, width * (t**3 - 2*t**2 + t)], [3*t**2 - 2*t**3, width * (t**3 - t**2)]])
