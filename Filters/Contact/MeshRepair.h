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
 * Reverses triangles until neighbours are wound alike: in each part connected by edges between two
 * triangles, the minority is reversed. Returns the number of reversed triangles. A part that cannot
 * be wound consistently (a Moebius band) is not changed.
 */
std::size_t makeWindingConsistent(std::vector<TriangleCorners>& triangles);

/**
 * For each point on an edge without neighbour: the first such point with the same coordinates (3
 * floats per point). Every other point maps to itself. This joins the triangles of files that list
 * every triangle's corners separately, and surfaces split for their normals, but never two closed
 * bodies that touch.
 */
std::vector<std::int32_t> findTwins(
  const float* coordinates, std::size_t pointCount, const TriangleLinks& links);

/**
 * Adds to a list of findTwins() the end points of each edge of a triangle that has no length. A
 * contour through a grid point has a separate point from each cell around the grid point; triangles
 * without area connect these points. A point of the list may then lead to the first point in
 * several steps, until followJoints() is called.
 */
void joinEmptyEdges(
  const float* coordinates, const TriangleCorners& corners, std::vector<std::int32_t>& first);

/// Makes each point of a list of findTwins() lead to the first point in a single step.
void followJoints(std::vector<std::int32_t>& first);
} // namespace palpate

#endif
