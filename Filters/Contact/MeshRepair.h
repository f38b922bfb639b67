// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshRepair_h
#define palpate_MeshRepair_h

#include "Contact/TriangleLinks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/**
 * Reverses triangles until neighbours are wound consistently. In each part connected by edges
 * between two triangles, the minority is reversed. Returns the number of reversed triangles. A part
 * that cannot be wound consistently (a Moebius band) is not changed.
 */
std::size_t makeWindingConsistent(std::vector<TriangleCorners>& triangles);

/**
 * Returns a list with one point index per point. For a point on an edge without neighbour, the list
 * has the first such point with the same coordinates (3 floats per point). For every other point,
 * it has the point itself. This list joins the triangles of files that store the corners of every
 * triangle separately, and surfaces that are split for their normals. Two closed bodies that touch
 * are not joined.
 */
std::vector<std::int32_t> findTwins(
  const float* coordinates, std::size_t pointCount, const TriangleLinks& links);

/**
 * Adds to a list of findTwins() the end points of each zero-length edge of a triangle. Such edges
 * occur in a contour through a grid point: each cell around the grid point has its own point there,
 * and triangles without area connect these points. A point of the list may then lead to the first
 * point in several steps, until followJoints() is called.
 */
void joinEmptyEdges(
  const float* coordinates, const TriangleCorners& corners, std::vector<std::int32_t>& first);

/// Changes a list of findTwins() so that each point leads to the first point in a single step.
void followJoints(std::vector<std::int32_t>& first);
} // namespace palpate

#endif
