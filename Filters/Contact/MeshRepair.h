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
 * Reverses triangles until neighbours are wound alike: in each part connected by edges of two
 * triangles, the minority is reversed. Returns the number of reversed triangles. A part that cannot
 * be consistent (a Moebius band) is unchanged.
 */
std::size_t makeWindingConsistent(std::vector<TriangleCorners>& triangles);

/**
 * For each point, the first point with the same coordinates (3 floats per point) among the points
 * on an edge without neighbour; other points map to themselves. Joins the triangles of files that
 * list every triangle's corners separately, and surfaces split for their normals, but never two
 * closed bodies that touch.
 */
std::vector<std::int32_t> findTwins(
  const float* coordinates, std::size_t pointCount, const TriangleLinks& links);

/**
 * Adds the ends of a triangle's edges without length to such a list. A contour through a grid point
 * has a separate point from each cell around it; triangles without area connect these points. The
 * list may then lead to the first point in several steps, until followJoints() is called.
 */
void joinEmptyEdges(
  const float* coordinates, const TriangleCorners& corners, std::vector<std::int32_t>& first);

/// Makes each point of such a list lead to the first one in a single step.
void followJoints(std::vector<std::int32_t>& first);
} // namespace palpate

#endif
