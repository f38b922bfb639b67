// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * A uniform pressure on a disc around a point of a body's surface, as forces on the nodes.
 *
 * The disc lies in the tangent plane at the point, its total force is 1 N along -n. It is
 * represented by the 24 points of a quadrature rule (three rings of eight; moments exact to the
 * fifth degree), each projected along n onto the surface and distributed to the nodes of its face
 * by the face's shapes. Only surface connected to the point through triangles whose normals turn by
 * no more than 30° from n counts: a disc that reaches beyond it wraps an edge.
 */
#ifndef palpate_PatchLoad_h
#define palpate_PatchLoad_h

#include "Solids/FiniteElements/BodySurface.h"

#include <utility>

namespace palpate
{
/// cos 30°: how far the surface may turn under a patch.
constexpr double PatchTurn = 0.86602540378443864676;

/// A disc's quadrature: points in units of its radius, weights that sum to 1.
struct DiscRule
{
  static constexpr int Count = 24;
  std::array<Eigen::Vector2d, Count> at;
  std::array<double, Count> weights{};

  static const DiscRule& standard();
};

/// Tangents and inward normal of a point: columns x, y, z (z into the body); right-handed.
Eigen::Matrix3d tangentFrame(const Eigen::Vector3d& outwardNormal);

/// A unit force, spread over a disc around a point of the surface.
struct PatchLoad
{
  /// False when the disc wraps an edge or leaves the surface.
  bool complete = false;
  /// Weights of the force by node; they sum to 1. Nodes ascend.
  std::vector<std::pair<std::int32_t, double>> nodes;
  /// The points of the quadrature, mm, in the order of `DiscRule::weights`.
  std::array<Eigen::Vector3d, DiscRule::Count> places;
};

PatchLoad makePatchLoad(
  const VolumeMesh& mesh, const BodySurface& surface, std::int32_t point, double radius);
} // namespace palpate

#endif
