// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_BruteForce_h
#define palpate_testing_BruteForce_h

#include "SampleBodies.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <vector>

/// Geometry of contact by enumeration, in long double: slow and simple.
namespace palpate::testing
{
using Real = long double;
using Point = Eigen::Matrix<Real, 3, 1>;

struct Nearest
{
  Point point = Point::Zero();
  Real distance = std::numeric_limits<Real>::infinity();
  std::int32_t triangle = -1;
};

/// Closest point of a triangle: the best of its corners, of the feet of the perpendiculars on its
/// edges, and of the foot on its plane if this foot is inside. The signs of the areas that the foot
/// spans with the edges decide whether it is inside.
Nearest nearestOfTriangle(
  const Vector3& tipGiven, const Vector3& aGiven, const Vector3& bGiven, const Vector3& cGiven);

/// Closest point of the listed triangles.
Nearest nearestOf(
  const Surface& body, const Vector3& tip, const std::vector<std::int32_t>& triangles);

std::vector<std::int32_t> allTriangles(const Surface& body);

/// The triangles within two rings of `triangle`: those with a corner in common with a triangle that
/// has a corner in common with `triangle`.
std::vector<std::int32_t> twoRings(const Surface& body, std::int32_t triangle);

/// Winding number of the closed surface around the tip: 1 inside, 0 outside. It is the sum of the
/// solid angles of the triangles (Van Oosterom and Strackee 1983).
double windingNumber(const Surface& body, const Vector3& tip);

Eigen::AlignedBox3d boxOf(const Surface& body);

/// Diagonal of the bounding box.
double diagonal(const Surface& body);
} // namespace palpate::testing

#endif
