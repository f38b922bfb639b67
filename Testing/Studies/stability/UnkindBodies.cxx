// SPDX-License-Identifier: BSD-3-Clause
#include "UnkindBodies.h"

#include "Mechanics/Numerics/Constants.h"

#include <cmath>
#include <utility>

namespace palpate::testing
{
namespace
{
constexpr double Section = 20.13; // z of the paths, away from all points

std::vector<Vector3> inSection(const std::vector<Eigen::Vector2d>& corners)
{
  std::vector<Vector3> path;
  for (const Eigen::Vector2d& corner : corners)
  {
    path.emplace_back(corner.x(), corner.y(), Section);
  }
  path.push_back(path.front());
  return path;
}

/// A convex edge along z. The path leads under one face towards the edge, over to the other face,
/// and back around the edge.
UnkindBody wedge(double degrees, double size)
{
  const double half = degrees * Pi / 360.0;
  const Eigen::Vector2d face(std::cos(half), std::sin(half));
  const Eigen::Vector2d out(-std::sin(half), std::cos(half));
  const Eigen::Vector2d mirror(1.0, -1.0);
  const Eigen::Vector2d above = 3.3 * face + 2.0 * out;
  const Eigen::Vector2d under = 3.3 * face - UnkindDepth * out;
  const Eigen::Vector2d corner = 25.0 * face;
  UnkindBody body;
  body.name = "edge " + std::to_string(static_cast<int>(degrees)) + "°";
  body.surface =
    subdivided(prism({ { 0, 0 }, mirror.cwiseProduct(corner), corner }, { { 0, 1, 2 } }, 40.0),
      static_cast<int>(std::lround(std::log2(30.0 / size))));
  body.path = inSection({ above, under, { UnkindDepth / std::sin(half), 0.0 },
    mirror.cwiseProduct(under), mirror.cwiseProduct(above), { -6.0, 0.0 } });
  body.forceJump = 2.0 * std::cos(half);
  body.contactJump = UnkindDepth * body.forceJump;
  return body;
}

/// A concave edge: all tips of a fan have the same contact point, and there is no jump.
UnkindBody inner(int times)
{
  return { "inner edge",
    subdivided(prism({ { 0, 0 }, { 20, 0 }, { 20, 8 }, { 8, 8 }, { 8, 20 }, { 0, 20 } },
                 { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 } }, 40.0),
      times),
    inSection(
      { { 15.1, 10.0 }, { 15.1, 7.0 }, { 8.0, 7.0 }, { 7.0, 8.0 }, { 7.0, 15.1 }, { 10.0, 15.1 } }),
    0.0, 0.0 };
}

/// A V groove: two edges of 135° and a concave edge between them.
UnkindBody groove(int times)
{
  const double in = 5.0 + (std::sqrt(2.0) - 1.0) * UnkindDepth;
  const double side = std::sqrt(0.5) * UnkindDepth;
  const double jump = 2.0 * std::cos(0.375 * Pi);
  return { "groove", subdivided(grooveBlock(), times),
    inSection({ { -12.1, 12.0 }, { -12.1, 9.0 }, { -in, 9.0 }, { -side, 5.0 - side },
      { side, 5.0 - side }, { in, 9.0 }, { 12.1, 9.0 }, { 12.1, 12.0 } }),
    jump, UnkindDepth * jump };
}

/// A slab of 3 mm, pressed from above until the tip comes out below; the path then returns around
/// the slab. In the middle the nearest point changes to the other side, and the force reverses.
UnkindBody slab(int times)
{
  return { "slab", subdivided(block(40.0, 3.0, 40.0), times),
    inSection({ { 17.3, 4.0 }, { 17.3, -1.0 }, { -5.0, -1.0 }, { -5.0, 4.0 } }), 2.0, 3.0 };
}
} // namespace

std::vector<UnkindBody> unkindBodies()
{
  std::vector<UnkindBody> bodies;
  for (const double degrees : { 30.0, 60.0, 90.0, 120.0, 150.0 })
  {
    bodies.push_back(wedge(degrees, 1.0));
  }
  bodies.push_back(inner(4));
  bodies.push_back(groove(5));
  bodies.push_back(slab(5));
  return bodies;
}
} // namespace palpate::testing
