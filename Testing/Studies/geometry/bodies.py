# SPDX-License-Identifier: BSD-3-Clause
"""Bodies with difficult geometry for a contact, their outlines in the plane of the tip, and paths of the tip there."""
import collections

import numpy as np

# outline: (x, y) in the plane of the picture, closed unless the body is open. place: maps arrays (x, y) of that plane to
# points in the body's frame. path: path of the tip in that plane. says: text about the expected result.
Case = collections.namedtuple("Case", "name title points triangles outline place path says")


def extruded(outline, length, rows, closed=True):
    """Returns (points, triangles) of a line in the plane that is extruded along the third axis; open at its ends."""
    line = np.asarray(outline, float)
    around = len(line)
    z = np.linspace(-length / 2, length / 2, rows + 1)
    points = np.array([(x, y, depth) for depth in z for x, y in line])
    triangles = []
    for r in range(rows):
        for i in range(around if closed else around - 1):
            a, b = r * around + i, r * around + (i + 1) % around
            triangles += [(a, b + around, b), (a, a + around, b + around)]
    return points, np.array(triangles)


def refined(corners, size, closed=True):
    """Returns the line through the corners, divided into pieces of at most `size`."""
    corners = np.asarray(corners, float)
    ends = np.roll(corners, -1, axis=0) if closed else corners[1:]
    pieces = []
    for start, end in zip(corners, ends):
        count = max(1, int(np.ceil(np.linalg.norm(end - start) / size - 1e-9)))
        pieces += [start + (end - start) * k / count for k in range(count)]
    return np.array(pieces if closed else pieces + [corners[-1]])


def walk(*corners, step=0.02):
    return refined(corners, step, closed=False)


def flat(x, y):
    return np.column_stack([x, y, np.full_like(x, 0.13)])


def extrusion(name, title, corners, size, path, says, closed=True):
    # A closed outline is clockwise; an open one is from left to right. The outside is then to its left or above.
    outline = refined(corners, size, closed)
    points, triangles = extruded(outline, 40.0, int(40 / size), closed)
    return Case(name, title, points, triangles, outline, flat, path, says)


def slab():
    return extrusion("slab", "Thin slab, 2 mm", [(-10, 0), (-10, 2), (10, 2), (10, 0)], 0.5,
                     walk((-3, 2.6), (-1, -0.4), (1, -0.4), (3, 2.6)),
                     "held to the side it entered, past the middle and through")


def groove():
    return extrusion("groove", "V-groove, 90°", [(-12, -4), (-12, 5), (-5, 5), (0, 0), (5, 5), (12, 5), (12, -4)],
                     0.5, walk((-4, 2.6), (0, -1.4), (4, 2.6)),
                     "a quarter of tips belongs to the bottom line")


def edge():
    return extrusion("edge", "Convex edge, 0.5 mm facets", [(0, -12), (0, 0), (12, 0), (12, -12)], 0.5,
                     walk((4, 0.3), (3, -1.5), (0.05, -1.5)),
                     "held to the face it entered until the edge is in the contact's ring")


def border():
    return extrusion("border", "Open border", [(-10, 0), (4, 0)], 0.5, walk((1, -1), (6, -1)),
                     "beyond the border contact is lost and its force fades; nothing pulls the tip back", closed=False)


def cone():
    half, rings, around, height = np.pi / 6, 24, 48, 12.0
    points, triangles = [(0, 0, 0)], []
    for r in range(1, rings + 1):
        depth = height * r / rings
        angles = 2 * np.pi * (np.arange(around) + 0.5) / around  # the plane of the tip cuts through facets
        points += [(depth * np.tan(half) * np.cos(a), -depth, depth * np.tan(half) * np.sin(a)) for a in angles]
    points.append((0, -height, 0))
    for i in range(around):
        j = (i + 1) % around
        triangles.append((0, 1 + j, 1 + i))
        for r in range(rings - 1):
            a, b, c, d = (1 + r * around + k for k in (i, j, i + around, j + around))
            triangles += [(a, b, d), (a, d, c)]
        last = 1 + (rings - 1) * around
        triangles.append((len(points) - 1, last + i, last + j))
    wide = height * np.tan(half)
    return Case("cone", "Tip of a cone, half angle 30°", np.array(points), np.array(triangles),
                np.array([(-wide, -height), (0, 0), (wide, -height)]),
                lambda x, y: np.column_stack([x, y, np.zeros_like(x)]),
                walk((-0.5, 0.4), (-0.5, -2.4), (1.5, -2.4)),
                "pushed out of the nearer flank; the sideways force turns round on the axis")


def saddle():
    """The inner side of a torus of 20 and 6 mm, in the plane across its hole."""
    big, small, around, across = 20.0, 6.0, 120, 60
    points, triangles = [], []
    for i in range(around):
        for j in range(across):
            u, v = 2 * np.pi * i / around, 2 * np.pi * j / across
            r = big + small * np.cos(v)
            points.append((r * np.cos(u), r * np.sin(u), small * np.sin(v)))
            a, b = i * across, (i + 1) % around * across
            triangles += [(a + j, b + j, b + (j + 1) % across), (a + j, b + (j + 1) % across, a + (j + 1) % across)]
    angle = np.linspace(-0.6, 0.6, 60)
    inner = (big - small) * np.column_stack([np.sin(angle), -np.cos(angle)])
    deep = (big - small + 1.0) * np.column_stack([np.sin(angle * 0.8), -np.cos(angle * 0.8)])
    outline = np.vstack([inner, 1.25 * inner[::-1]])
    # In the plane of the torus the surface is concave; across it, convex.
    return Case("saddle", "Saddle: the inner side of a torus", np.array(points), np.array(triangles), outline,
                lambda x, y: np.column_stack([x, y, np.full_like(x, 0.11)]), refined(deep, 0.02, closed=False),
                "1 mm deep all along; the force turns with the surface")


CASES = (slab, groove, edge, cone, saddle, border)
