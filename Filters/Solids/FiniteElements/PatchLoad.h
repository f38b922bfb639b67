// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * A uniform pressure on a disc around a point of a body's surface, as forces on the nodes.
 *
 * The disc is in the tangent plane at the point, and the total force is 1 N along -n. The pressure
 * is represented by the 24 points of a quadrature rule (three rings of eight points; moments are
 * exact to the fifth degree). Each point is projected along n onto the surface and distributed to
 * the nodes of its face by the face's shape functions. Only the part of the surface that is
 * connected to the point by triangles with normals within 30° of n is used. A disc that reaches
 * beyond this part extends over an edge.
 */
#ifndef palpate_PatchLoad_h
#define palpate_PatchLoad_h

#include "Solids/FiniteElements/BodySurface.h"

#include <utility>

namespace palpate
{
/// cos 30°, for the largest variation of the surface normal under a patch.
constexpr double PatchTurn = 0.86602540378443864676;

/// Quadrature rule on a disc. The points are in units of the radius of the disc. The weights have
/// the sum 1.
struct DiscRule
{
  static constexpr int Count = 24;
  std::array<Eigen::Vector2d, Count> at;
  std::array<double, Count> weights{};

  static const DiscRule& standard();
};

/// Returns the tangents and the inward normal of a point as the columns x, y, z of a right-handed
/// matrix. z points into the body.
Eigen::Matrix3d tangentFrame(const Eigen::Vector3d& outwardNormal);

/// A unit force that is distributed over a disc around a point of the surface.
struct PatchLoad
{
  /// Whether the whole disc is on the surface. It is false if the disc extends over an edge or
  /// beyond the surface.
  bool complete = false;
  /// Nodes in ascending order and their weights. The weights have the sum 1.
  std::vector<std::pair<std::int32_t, double>> nodes;
  /// The points of the quadrature, mm, in the order of `DiscRule::weights`.
  std::array<Eigen::Vector3d, DiscRule::Count> places;
};

PatchLoad makePatchLoad(
  const VolumeMesh& mesh, const BodySurface& surface, std::int32_t point, double radius);
} // namespace palpate

#endif
