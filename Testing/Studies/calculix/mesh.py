# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of second-order elements: a half section in (r, z) and a quarter body in (x, y, z).

Bodies are in z <= 0, with the surface at z = 0 and the contact at the origin; tools are above.
`Mesh` holds nodes numbered from 0 in `points`, elements as rows of node numbers in CalculiX's order
(corners, then mid-edge nodes), and the pairs (element, CalculiX face number) of the contact surface.
"""
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Mesh:
    points: np.ndarray
    elements: np.ndarray
    contact: list
    sets: dict = field(default_factory=dict)


def graded(first, uniform, length, growth, largest=np.inf):
    """Returns corners from 0 to `length`: steps of `first` up to `uniform`, then growing by `growth` up to `largest`."""
    count = max(1, round(uniform / first))
    corners, step = list(np.linspace(0, uniform, count + 1)), uniform / count
    while corners[-1] < length * (1 - 1e-9):
        step = min(step * growth, largest)
        corners.append(corners[-1] + step)
    corners = np.array(corners)
    # Stretched so that the last corner is at the end.
    tail = corners[count:] - corners[count]
    if length > uniform * (1 + 1e-9):
        corners[count:] = corners[count] + tail * (length - corners[count]) / tail[-1]
    return corners


def graded_about(edge, first, length, growth, largest):
    """Returns corners from 0 to `length`; the smallest steps, `first`, are on both sides of `edge`."""
    inner = edge - graded(first, first, edge, growth, largest)[::-1]
    outer = edge + graded(first, first, length - edge, growth)
    return np.concatenate([inner, outer[1:]])


def with_middles(corners):
    fine = np.empty(2 * len(corners) - 1)
    fine[::2] = corners
    fine[1::2] = 0.5 * (corners[1:] + corners[:-1])
    return fine


def renumber(points, elements):
    """Returns points and elements without the points that no element uses."""
    used = np.unique(elements)
    number = np.full(len(points), -1)
    number[used] = np.arange(len(used))
    return points[used], number[elements]


def quadrilaterals(index):
    """Returns 8-node elements on a lattice of node numbers, with mid-edge nodes at odd places."""
    i, j = np.meshgrid(np.arange(0, index.shape[0] - 1, 2), np.arange(0, index.shape[1] - 1, 2),
                       indexing="ij")
    steps = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
    return np.stack([index[i + a, j + b] for a, b in steps], axis=-1).reshape(-1, 8)


def half_section(radii, heights):
    """Returns a rectangle in (r, z); `heights` rises to 0. The contact surface is the top, face 3."""
    r, z = np.meshgrid(with_middles(radii), with_middles(heights), indexing="ij")
    index = np.arange(r.size).reshape(r.shape)
    points, elements = renumber(np.column_stack([r.ravel(), z.ravel()]), quadrilaterals(index))
    top = np.isclose(points[elements[:, 2], 1], 0)
    return Mesh(points, elements, [(e, 3) for e in np.flatnonzero(top)])


def sphere_section(radius, opening, count, thickness):
    """Returns a shell of a sphere that touches the origin, r <= opening; the contact surface is its outside (face 1)."""
    angles = with_middles(np.linspace(0, np.arcsin(opening / radius), count + 1))
    angle, inward = np.meshgrid(angles, [0, 0.5 * thickness, thickness], indexing="ij")
    r, z = (radius - inward) * np.sin(angle), radius - (radius - inward) * np.cos(angle)
    index = np.arange(r.size).reshape(r.shape)
    points, elements = renumber(np.column_stack([r.ravel(), z.ravel()]), quadrilaterals(index))
    return Mesh(points, elements, [(e, 1) for e in range(len(elements))])


def quarter_plane(side, rings, rectangle=None):
    """Returns 8-node elements of a quarter of a plane: a square core with `side` elements along its side within the circle
    of the first radius of `rings`, then rings between the growing radii. Beyond the last circle, if given, the rectangle:
    (half length in x, in y, corners 0 ... 1 from the last circle to the rectangle)."""
    radius = rings[0]
    s = np.linspace(0, 1, 2 * side + 1)
    u, v = np.meshgrid(s, s, indexing="ij")
    # The corner of the core on the diagonal is at 0.42 R: no angle of the elements around it
    # exceeds 150 degrees.
    bulge = 1 - 0.16 * u * v
    x, y = 0.5 * radius * u * bulge, 0.5 * radius * v * bulge
    points = [np.column_stack([x.ravel(), y.ravel()])]
    elements = [quadrilaterals(np.arange(x.size).reshape(x.shape))]
    rim = np.concatenate([np.column_stack([x[-1], y[-1]]), np.column_stack([x[::-1, -1], y[::-1, -1]])[1:]])
    angle = np.linspace(0, 0.5 * np.pi, len(rim))
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    curves = [rim + t * (radius * circle - rim) for t in np.linspace(0, 1, 2 * max(1, side // 2) + 1)]
    for ring in with_middles(np.array(rings))[1:]:
        curves.append(ring * circle)
    if rectangle is not None:
        half_x, half_y, corners = rectangle
        quarter = len(rim) // 2
        edge = np.concatenate([
            np.column_stack([np.full(quarter + 1, half_x), np.linspace(0, half_y, quarter + 1)]),
            np.column_stack([np.linspace(half_x, 0, quarter + 1), np.full(quarter + 1, half_y)])[1:]])
        for t in with_middles(corners)[1:]:
            curves.append((1 - t) * rings[-1] * circle + t * edge)
    lattice = np.array(curves)  # curve, position along it
    points.append(lattice.reshape(-1, 2))
    index = np.arange(lattice.shape[0] * lattice.shape[1]).reshape(lattice.shape[:2]) + x.size
    elements.append(quadrilaterals(index))
    points, elements = np.vstack(points), np.vstack(elements)
    # The core's rim occurs twice.
    keys = np.round(points, 9)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    return renumber(points[first], inverse.ravel()[elements])


def extruded(plane, elements, levels, place):
    """Returns 20-node elements: the 8-node elements of a plane at the corners `levels` (rising) of a third direction.
    place(points of the plane, level) returns (x, y, z). The bottom is face 1, the top face 2."""
    fine = with_middles(levels)
    points = np.vstack([place(plane, level) for level in fine])
    count, bricks = len(plane), []
    for k in range(0, len(fine) - 1, 2):
        low, middle, high = k * count, (k + 1) * count, (k + 2) * count
        bricks.append(np.hstack([elements[:, :4] + low, elements[:, :4] + high, elements[:, 4:] + low,
                                 elements[:, 4:] + high, elements[:, :4] + middle]))
    return renumber(points, np.vstack(bricks))


def quarter_body(plane, elements, heights):
    points, bricks = extruded(
        plane, elements, heights, lambda p, z: np.column_stack([p, np.full(len(p), z)]))
    return Mesh(points, bricks, [(e, 2) for e in range(len(bricks) - len(elements), len(bricks))])


def quarter_sphere(radius, plane, elements, thickness):
    """Returns a shell of a sphere that touches the origin, above the points of a plane; the outside is face 1."""
    def place(p, level):
        height = np.sqrt(radius ** 2 - (p ** 2).sum(axis=1))
        outside = np.column_stack([p, radius - height])
        return outside + (np.array([0, 0, radius]) - outside) * level / radius
    points, bricks = extruded(plane, elements, np.array([0.0, thickness]), place)
    return Mesh(points, bricks, [(e, 1) for e in range(len(bricks))])
