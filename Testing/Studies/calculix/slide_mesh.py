# SPDX-License-Identifier: BSD-3-Clause
"""Half models for a tool that slides along x: the part at y >= 0, symmetric about the plane y = 0.

They are built from the quarter planes of mesh.py and have 20-node elements.
"""
import numpy as np

import mesh


def half_plane(plane, elements):
    """Returns 8-node elements of the quarter plane x, y >= 0 and of its mirror image in x."""
    mirrored = elements[:, [0, 3, 2, 1, 7, 6, 5, 4]] + len(plane)  # reordered, to keep the orientation
    points = np.vstack([plane, plane * [-1, 1]])
    _, first, inverse = np.unique(np.round(points, 9), axis=0, return_index=True, return_inverse=True)
    return mesh.renumber(points[first], inverse.ravel()[np.vstack([elements, mirrored])])


def half_body(side, rings, heights):
    """Returns half of a cylinder of the radius rings[-1]; the contact surface is z = 0, `heights` rises to 0."""
    return mesh.quarter_body(*half_plane(*mesh.quarter_plane(side, rings)), heights)


def half_tool(radius, reach, side, count, thickness):
    """Returns a shell of a sphere that touches the origin, on a shaft of the same radius. `reach` is the arc from the tip to
    the end of the shell, in radii. The outside is face 1."""
    plane, elements = half_plane(*mesh.quarter_plane(side, reach * np.linspace(0.5, 1, count + 1)))
    arc = np.hypot(*plane.T)
    angle = np.minimum(arc, 0.5 * np.pi)
    around = plane / np.maximum(arc, 1e-300)[:, None]

    def place(_, inward):
        r = radius - inward
        return np.column_stack([r * np.sin(angle)[:, None] * around,
                                radius - r * np.cos(angle) + radius * (arc - angle)])
    points, bricks = mesh.extruded(plane, elements, np.array([0.0, thickness]), place)
    return mesh.Mesh(points, bricks, [(e, 1) for e in range(len(bricks))])
