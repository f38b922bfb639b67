// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleProjection_h
#define palpate_TriangleProjection_h

#include <Eigen/Core>

#include <cstdint>

namespace palpate
{
using Vector3 = Eigen::Vector3d;

/// Where on a triangle abc its closest point lies. Edge i runs from corner i to corner i+1 (mod 3).
enum class TriangleFeature : std::uint8_t
{
  Corner0,
  Corner1,
  Corner2,
  Edge0,
  Edge1,
  Edge2,
  Face
};

struct TriangleProjection
{
  Vector3 point = Vector3::Zero();
  /// Area coordinates of the point (Mahvash and Hayward 2002, eq. 4): >= 0, sum 1.
  Vector3 weights = Vector3::Zero();
  double squaredDistance = 0.0;
  TriangleFeature feature = TriangleFeature::Face;
};

/// Closest point of triangle abc to `tip`, by the Voronoi regions of its corners and edges
/// (Ericson 2005, Real-Time Collision Detection, sec. 5.1.5). The triangle must have an area.
TriangleProjection projectOnTriangle(
  const Vector3& tip, const Vector3& a, const Vector3& b, const Vector3& c) noexcept;
} // namespace palpate

#endif
