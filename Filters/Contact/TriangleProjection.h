// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleProjection_h
#define palpate_TriangleProjection_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace palpate
{
using Vector3 = Eigen::Vector3d;
/// The indices of the three points of a triangle.
using TriangleCorners = std::array<std::int32_t, 3>;

/// The part of a triangle abc on which the closest point is. Edge i runs from corner i to corner
/// i+1 (mod 3).
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

/// The closest point of a triangle.
struct TriangleProjection
{
  Vector3 point = Vector3::Zero();
  /// Area coordinates of the point (Mahvash and Hayward 2002, eq. 4): >= 0, sum 1.
  Vector3 weights = Vector3::Zero();
  double squaredDistance = 0.0;
  TriangleFeature feature = TriangleFeature::Face;
};

/// Returns the closest point of triangle abc to `tip`, using the Voronoi regions of its corners and
/// edges (Ericson 2005, Real-Time Collision Detection, sec. 5.1.5). The triangle must have an area.
PALPATE_EXPORT TriangleProjection projectOnTriangle(
  const Vector3& tip, const Vector3& a, const Vector3& b, const Vector3& c) noexcept;

/// Smallest squared sine of the angle at a. If it is smaller, rounding makes the area coordinates
/// of a projection useless.
constexpr double SliverSine = 1e-8;

/// Position of a tip's projection on a triangle's plane, relative to the triangle.
enum class PlaneFoot : std::int8_t
{
  OnFace = -1,
  BeyondEdge0,
  BeyondEdge1,
  BeyondEdge2,
  Unknown ///< the triangle is a sliver, or the tip is not finite
};

/// Computes the result of projectOnTriangle(), bit for bit, if the closest point is on the face.
/// This is the case in most ticks of a followed contact; therefore the function is inline.
/// Otherwise returns an edge beyond which the projection is, or Unknown, and leaves `projection`
/// unchanged.
inline PlaneFoot projectOnFace(const Vector3& tip, const Vector3& a, const Vector3& b,
  const Vector3& c, TriangleProjection& projection) noexcept
{
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ap = tip - a;
  const Vector3 bp = ap - ab;
  const Vector3 cp = ap - ac;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  const double va = d3 * d6 - d5 * d4;
  const double vb = d5 * d2 - d1 * d6;
  const double vc = d1 * d4 - d3 * d2;
  const double sum = va + vb + vc;
  if (!(sum >= SliverSine * ab.squaredNorm() * ac.squaredNorm()))
  {
    return PlaneFoot::Unknown;
  }
  if (!(va > 0.0 && vb > 0.0 && vc > 0.0))
  {
    return va <= 0.0 ? PlaneFoot::BeyondEdge1
      : vb <= 0.0    ? PlaneFoot::BeyondEdge2
                     : PlaneFoot::BeyondEdge0;
  }
  const double v = vb / sum;
  const double w = vc / sum;
  projection.weights = { 1.0 - v - w, v, w };
  projection.point = a + v * ab + w * ac;
  projection.squaredDistance = (tip - projection.point).squaredNorm();
  projection.feature = TriangleFeature::Face;
  return PlaneFoot::OnFace;
}
} // namespace palpate

#endif
