// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleProjection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
struct Region
{
  Vector3 weights;
  TriangleFeature feature;
};

/// Returns the nearest of the projections on the edges and on the plane. The area coordinates of
/// the projection on the plane are computed from cross products; their rounding error corresponds
/// to at most the height of the sliver.
Region nearestOnSliver(
  const Vector3& ap, const Vector3& bp, const Vector3& cp, const Vector3& ab, const Vector3& ac)
{
  Region best{ Vector3::Zero(), TriangleFeature::Face };
  double nearest = std::numeric_limits<double>::infinity();
  const auto offer = [&](double u, double v, double w, TriangleFeature feature)
  {
    const double squaredDistance = (ap - v * ab - w * ac).squaredNorm();
    if (squaredDistance < nearest)
    {
      nearest = squaredDistance;
      best = { { u, v, w }, feature };
    }
  };
  const auto share = [](const Vector3& from, const Vector3& along)
  { return std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0); };
  const double s = share(ap, ab);
  const double t = share(bp, ac - ab);
  const double r = share(ap, ac);
  offer(1.0 - s, s, 0.0, TriangleFeature::Edge0);
  offer(0.0, 1.0 - t, t, TriangleFeature::Edge1);
  offer(1.0 - r, 0.0, r, TriangleFeature::Edge2);
  const Vector3 normal = ab.cross(ac);
  const double area = normal.squaredNorm();
  const double v = normal.dot(cp.cross(ap)) / area;
  const double w = normal.dot(ap.cross(bp)) / area;
  if (v >= 0.0 && w >= 0.0 && v + w <= 1.0)
  {
    offer(1.0 - v - w, v, w, TriangleFeature::Face);
  }
  return best;
}

Region findRegion(
  const Vector3& tip, const Vector3& a, const Vector3& ab, const Vector3& ac) noexcept
{
  const Vector3 ap = tip - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return { { 1.0, 0.0, 0.0 }, TriangleFeature::Corner0 };
  }
  const Vector3 bp = ap - ab;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return { { 0.0, 1.0, 0.0 }, TriangleFeature::Corner1 };
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    const double v = d1 / (d1 - d3);
    return { { 1.0 - v, v, 0.0 }, TriangleFeature::Edge0 };
  }
  const Vector3 cp = ap - ac;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return { { 0.0, 0.0, 1.0 }, TriangleFeature::Corner2 };
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    const double w = d2 / (d2 - d6);
    return { { 1.0 - w, 0.0, w }, TriangleFeature::Edge2 };
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return { { 0.0, 1.0 - w, w }, TriangleFeature::Edge1 };
  }
  const double sum = va + vb + vc;
  if (sum < SliverSine * ab.squaredNorm() * ac.squaredNorm())
  {
    return nearestOnSliver(ap, bp, cp, ab, ac);
  }
  const double v = vb / sum;
  const double w = vc / sum;
  return { { 1.0 - v - w, v, w }, TriangleFeature::Face };
}
} // namespace

[[gnu::hot]] TriangleProjection projectOnTriangle(
  const Vector3& tip, const Vector3& a, const Vector3& b, const Vector3& c) noexcept
{
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Region region = findRegion(tip, a, ab, ac);
  TriangleProjection projection;
  projection.weights = region.weights;
  projection.feature = region.feature;
  projection.point = a + region.weights[1] * ab + region.weights[2] * ac;
  projection.squaredDistance = (tip - projection.point).squaredNorm();
  return projection;
}
} // namespace palpate
