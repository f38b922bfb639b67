// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForce.h"

#include <algorithm>
#include <cmath>

namespace palpate::testing
{
Nearest nearestOfTriangle(
  const Vector3& tipGiven, const Vector3& aGiven, const Vector3& bGiven, const Vector3& cGiven)
{
  const Point tip = tipGiven.cast<Real>();
  const std::array<Point, 3> corner = { aGiven.cast<Real>(), bGiven.cast<Real>(),
    cGiven.cast<Real>() };
  Nearest best;
  const auto offer = [&](const Point& p)
  {
    const Real distance = (tip - p).norm();
    if (distance < best.distance)
    {
      best.point = p;
      best.distance = distance;
    }
  };
  Point normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  normal /= normal.norm();
  const Point foot = tip - normal * normal.dot(tip - corner[0]);
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point& from = corner[k];
    const Point along = corner[(k + 1) % 3] - from;
    const Real share = (tip - from).dot(along) / along.squaredNorm();
    offer(from + std::clamp(share, Real(0), Real(1)) * along);
    inside = inside && normal.dot(along.cross(foot - from)) >= 0;
  }
  if (inside)
  {
    offer(foot);
  }
  return best;
}

Nearest nearestOf(
  const Surface& body, const Vector3& tip, const std::vector<std::int32_t>& triangles)
{
  Nearest best;
  for (const std::int32_t t : triangles)
  {
    const Nearest candidate =
      nearestOfTriangle(tip, body.corner(t, 0), body.corner(t, 1), body.corner(t, 2));
    if (candidate.distance < best.distance)
    {
      best = candidate;
      best.triangle = t;
    }
  }
  return best;
}

std::vector<std::int32_t> allTriangles(const Surface& body)
{
  std::vector<std::int32_t> all(body.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t)
  {
    all[t] = static_cast<std::int32_t>(t);
  }
  return all;
}

std::vector<std::int32_t> twoRings(const Surface& body, std::int32_t triangle)
{
  std::vector<bool> touched(body.points.size(), false);
  const auto touch = [&](std::int32_t t)
  {
    for (const std::int32_t corner : body.triangles[static_cast<std::size_t>(t)])
    {
      touched[static_cast<std::size_t>(corner)] = true;
    }
  };
  touch(triangle);
  std::vector<std::int32_t> ring;
  for (int pass = 0; pass < 2; ++pass)
  {
    ring.clear();
    for (const std::int32_t t : allTriangles(body))
    {
      const auto& corners = body.triangles[static_cast<std::size_t>(t)];
      if (std::any_of(corners.begin(), corners.end(),
            [&](std::int32_t corner) { return touched[static_cast<std::size_t>(corner)]; }))
      {
        ring.push_back(t);
      }
    }
    std::for_each(ring.begin(), ring.end(), touch);
  }
  return ring;
}

double windingNumber(const Surface& body, const Vector3& tip)
{
  double sum = 0.0;
  for (const std::int32_t t : allTriangles(body))
  {
    const Vector3 a = body.corner(t, 0) - tip;
    const Vector3 b = body.corner(t, 1) - tip;
    const Vector3 c = body.corner(t, 2) - tip;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    sum += 2.0 *
      std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4.0 * 3.14159265358979323846);
}

Eigen::AlignedBox3d boxOf(const Surface& body)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& p : body.points)
  {
    box.extend(p);
  }
  return box;
}

double diagonal(const Surface& body)
{
  return boxOf(body).diagonal().norm();
}
} // namespace palpate::testing
