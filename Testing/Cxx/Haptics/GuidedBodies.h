// SPDX-License-Identifier: BSD-3-Clause
// Bodies with a distance in closed form, for hands that move around them.
#ifndef palpate_testing_GuidedBodies_h
#define palpate_testing_GuidedBodies_h

#include "SampleBodies.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace palpate::testing
{
struct GuidedShape
{
  std::string name;
  Surface surface;
  /// Function that is positive outside the exact shape and negative inside, mm. Its magnitude is at
  /// most the distance from the shape.
  std::function<double(const Vector3&)> outside;
  /// Largest distance between triangles and exact shape, mm.
  double facets;
};

inline Surface scaled(Surface surface, const Vector3& by)
{
  for (Vector3& point : surface.points)
  {
    point = point.cwiseProduct(by);
  }
  return surface;
}

/// Signed distance from the box with corners -half and half.
inline double boxDistance(const Vector3& point, const Vector3& half)
{
  const Vector3 over = point.cwiseAbs() - half;
  return over.cwiseMax(0.0).norm() + std::min(over.maxCoeff(), 0.0);
}

inline GuidedShape boxShape(const std::string& name, const Vector3& half)
{
  Surface surface = block(2.0 * half.x(), 2.0 * half.y(), 2.0 * half.z());
  for (Vector3& point : surface.points)
  {
    point -= half;
  }
  return { name, subdivided(std::move(surface), 3),
    [half](const Vector3& point) { return boxDistance(point, half); }, 1e-5 };
}

/// A hollow hemisphere with its centre at the origin, open towards +z, with a flat rim.
inline Surface bowl(double outer, double inner, int rings, int around)
{
  std::vector<Eigen::Vector2d> profile; // radius and height, from the outer pole to the inner pole
  for (int i = 0; i <= rings; ++i)
  {
    const double angle = M_PI / 2.0 * i / rings;
    profile.emplace_back(outer * std::sin(angle), -outer * std::cos(angle));
  }
  for (int i = rings; i >= 0; --i)
  {
    const double angle = M_PI / 2.0 * i / rings;
    profile.emplace_back(inner * std::sin(angle), -inner * std::cos(angle));
  }
  Surface body;
  body.points.emplace_back(0.0, 0.0, -outer);
  const auto ringCount = static_cast<std::int32_t>(profile.size()) - 2;
  for (std::int32_t ring = 1; ring <= ringCount; ++ring)
  {
    for (int k = 0; k < around; ++k)
    {
      const double turn = 2.0 * M_PI * k / around;
      const Eigen::Vector2d& place = profile[static_cast<std::size_t>(ring)];
      body.points.emplace_back(place.x() * std::cos(turn), place.x() * std::sin(turn), place.y());
    }
  }
  body.points.emplace_back(0.0, 0.0, -inner);
  const auto last = static_cast<std::int32_t>(body.points.size()) - 1;
  const auto at = [around](std::int32_t ring, std::int32_t k)
  { return 1 + ring * around + k % around; };
  for (std::int32_t k = 0; k < around; ++k)
  {
    body.triangles.push_back({ 0, at(0, k + 1), at(0, k) });
    body.triangles.push_back({ last, at(ringCount - 1, k), at(ringCount - 1, k + 1) });
    for (std::int32_t ring = 0; ring + 1 < ringCount; ++ring)
    {
      body.triangles.push_back({ at(ring, k), at(ring, k + 1), at(ring + 1, k + 1) });
      body.triangles.push_back({ at(ring, k), at(ring + 1, k + 1), at(ring + 1, k) });
    }
  }
  return body;
}

inline std::vector<GuidedShape> guidedShapes()
{
  std::vector<GuidedShape> shapes;
  const Vector3 axes(30.0, 20.0, 12.0);
  // The value of the quadric, times half the smallest axis, is smaller than the distance. An edge
  // of the ball is 0.14 of its radius long, so the sagitta is 0.14²/8 of the largest axis.
  shapes.push_back({ "ellipsoid", scaled(icosphere(1.0, 3), axes),
    [axes](const Vector3& point) {
      return 0.5 * axes.minCoeff() * (1.0 - 1.0 / std::max(point.cwiseQuotient(axes).norm(), 0.1));
    },
    0.14 * 0.14 / 8.0 * 30.0 });
  shapes.push_back(boxShape("box", { 25.0, 15.0, 10.0 }));
  shapes.push_back(boxShape("thin plate", { 20.0, 20.0, 0.5 }));
  // 72 chords around 24 mm, and 36 around 6 mm.
  shapes.push_back({ "torus", torus(18.0, 6.0, 72, 36),
    [](const Vector3& point)
    { return std::hypot(std::hypot(point.x(), point.y()) - 18.0, point.z()) - 6.0; },
    24.0 * (1.0 - std::cos(M_PI / 72.0)) + 6.0 * (1.0 - std::cos(M_PI / 36.0)) });
  shapes.push_back({ "bowl", bowl(20.0, 15.0, 24, 72),
    [](const Vector3& point)
    {
      const double radius = point.norm();
      const double shell = std::max(radius - 20.0, 15.0 - radius);
      return std::max(shell, point.z());
    },
    20.0 * (1.0 - std::cos(M_PI / 72.0)) + 20.0 * (1.0 - std::cos(M_PI / 96.0)) });
  return shapes;
}
} // namespace palpate::testing

#endif
