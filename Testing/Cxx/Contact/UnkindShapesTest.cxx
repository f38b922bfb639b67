// SPDX-License-Identifier: BSD-3-Clause
// Slab, groove, edge, cone and saddle: the side at which the contact is, and the magnitude and
// direction of the force. The path of the tip is given. The force is F = 10 δ^1.5 N up to a depth
// of 2 mm.
#include "BruteForce.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::testing
{
namespace
{
/// The law of the responses; beyond 2 mm it continues as the last tangent. The samples are float32.
double law(double depth)
{
  return depth <= 2.0 ? 10.0 * std::pow(depth, 1.5)
                      : 10.0 * std::pow(2.0, 1.5) + 15.0 * std::sqrt(2.0) * (depth - 2.0);
}

void expectForce(const Contact& found, double depth, const Vector3& normal)
{
  EXPECT_NEAR(found.deflection, depth, 1e-5);       // float32 coordinates of 40 mm
  EXPECT_NEAR(found.normalForce, law(depth), 3e-4); // 22 N/mm times 1e-5 mm, and float32 samples
  EXPECT_LE((found.normal - normal).norm(), 1e-6);  // float32 normals
  EXPECT_LE((found.force - found.normalForce * found.normal).norm(), 1e-12 * found.normalForce);
}

/// A cone with a given half angle and its apex at the origin, pointing up, `height` high, closed by
/// a flat bottom. It has `around` facets in each of `rings` rings of equal height.
Surface cone(double halfAngle, double height, int around, int rings)
{
  Surface body;
  body.points.emplace_back(0, 0, 0);
  for (int r = 1; r <= rings; ++r)
  {
    const double z = height * r / rings;
    for (int i = 0; i < around; ++i)
    {
      const double a = 2.0 * Pi * i / around;
      body.points.emplace_back(
        z * std::tan(halfAngle) * std::cos(a), z * std::tan(halfAngle) * std::sin(a), -z);
    }
  }
  const auto bottom = static_cast<std::int32_t>(body.points.size());
  body.points.emplace_back(0, 0, -height);
  const auto at = [around](int r, int i) { return r == 0 ? 0 : 1 + (r - 1) * around + i % around; };
  for (int i = 0; i < around; ++i)
  {
    for (int r = 0; r < rings; ++r)
    {
      body.triangles.push_back({ at(r, i), at(r + 1, i), at(r + 1, i + 1) });
      if (r > 0)
      {
        body.triangles.push_back({ at(r, i), at(r + 1, i + 1), at(r, i + 1) });
      }
    }
    body.triangles.push_back({ bottom, at(rings, i + 1), at(rings, i) });
  }
  return body;
}
} // namespace

TEST(UnkindShapes, ThinSlabPushesBackAllTheWay)
{
  // A slab of 2 mm: the contact does not change sides at half of the thickness, nor at the whole
  // thickness. The tip leaves where it entered.
  const auto body = uniformBody(subdivided(block(40, 40, 2), 4));
  ToolContact contact(*body);
  for (int i = 1; i <= 400; ++i)
  {
    const double depth = 0.01 * (i <= 250 ? i : 500 - i);
    const Contact found = contact.update(Vector3(15.3 + 0.01 * i, 17.1, 2.0 - depth));
    expectForce(found, depth, Vector3::UnitZ());
    EXPECT_EQ(found.state, depth > 2.0 + 1e-6 ? ContactState::BeyondRange : ContactState::Slide);
  }
  // Without its history a tip at a depth of 1.5 mm has a force from the bottom.
  contact.reset();
  expectForce(contact.update(Vector3(19.3, 17.1, 0.5)), 0.5, -Vector3::UnitZ());
}

TEST(UnkindShapes, BottomOfAGroove)
{
  // Below the bottom line of the groove, tips within a quarter of a full turn have their closest
  // point on the line. The depth is the distance from the line, and the normal is half-way between
  // those of the walls.
  const auto body = uniformBody(subdivided(grooveBlock(), 3));
  ToolContact contact(*body);
  for (int i = -99; i <= 99; ++i)
  {
    const double angle = 0.25 * Pi * i / 100.0;
    const Vector3 tip(1.5 * std::sin(angle), 5.0 - 1.5 * std::cos(angle), 20.3);
    const Contact found = contact.update(tip);
    expectForce(found, 1.5, Vector3::UnitY());
    EXPECT_LE((found.contactPoint - Vector3(0, 5, 20.3)).norm(), 1e-12);
  }
}

TEST(UnkindShapes, WallsOfAGroove)
{
  const auto body = uniformBody(subdivided(grooveBlock(), 3));
  const double s = std::sqrt(0.5);
  for (const double side : { -1.0, 1.0 })
  {
    ToolContact contact(*body);
    const Vector3 normal(-side * s, s, 0.0);
    const Vector3 along(side * s, s, 0.0);
    // Up the wall, 7.07 mm long in 8 rows, at a depth of 1 mm. The normal is that of the wall,
    // except in the first and the last row, whose points at the edges have the mean of two faces.
    double lastForce = 0.0;
    for (int i = -100; i <= 600; ++i)
    {
      const double way = 0.01 * i;
      const Vector3 tip = Vector3(0, 5, 20.3) + way * along - normal;
      const Contact found = contact.update(tip);
      if (way > 0.9 && way < 6.1)
      {
        expectForce(found, 1.0, normal);
      }
      // There is no step: on the bottom line the force changes by 0.01 mm times 15 N/mm per tick,
      // and then it is constant.
      EXPECT_NEAR(found.normalForce, i == -100 ? found.normalForce : lastForce, 0.16);
      EXPECT_GT(found.force.y(), 0.0);
      lastForce = found.normalForce;
    }
  }
}

TEST(UnkindShapes, AConvexEdgeIsPassedWhereTheSidesAreEquallyNear)
{
  // With facets of 5 mm the edge is within the ring of the triangle, so the contact changes to the
  // other face as soon as this face is nearer. The force rotates by a right angle and keeps its
  // magnitude.
  const auto body = uniformBody(subdivided(block(40, 40, 40), 3));
  ToolContact contact(*body);
  const double depth = 1.0;
  int sides = 0;
  bool onTop = true;
  for (int i = 300; i >= 1; --i)
  {
    const double x = 0.01 * i;
    const Contact found = contact.update(Vector3(x, 21.3, 40.0 - depth));
    const bool isTop = found.contactPoint.z() == 40.0;
    EXPECT_EQ(isTop, x > depth - 1e-12) << x;
    EXPECT_NEAR(found.normalForce, law(std::min(x, depth)), 3e-4);
    sides += isTop != onTop;
    onTop = isTop;
  }
  EXPECT_EQ(sides, 1);
}

TEST(UnkindShapes, AFineConvexEdgeHoldsOnLonger)
{
  // With facets of 0.625 mm and a depth of 2 mm the contact stays on the first face, although the
  // other face is nearer from x = 2 on, until the edge is in the ring of its triangle. In the
  // opposite direction the contact stays on the side in the same way.
  const Surface given = subdivided(block(10, 10, 10), 4);
  const double facet = 10.0 / 16.0;
  const auto body = uniformBody(given);
  ToolContact contact(*body);
  double passed = 0.0;
  for (int i = 400; i >= 1 && passed == 0.0; --i)
  {
    const double x = 0.01 * i;
    const Contact found = contact.update(Vector3(x, 5.3, 8.0));
    passed = found.contactPoint.z() == 10.0 ? 0.0 : x;
    EXPECT_NEAR(found.normalForce, law(passed == 0.0 ? 2.0 : x), 3e-4);
  }
  EXPECT_LE(passed, facet);
  EXPECT_GT(passed, 0.0);
  for (int i = 1; i <= 150; ++i)
  {
    const double x = 0.01 * i;
    EXPECT_EQ(contact.update(Vector3(x, 5.3, 8.0)).contactPoint.x(), 0.0);
  }
}

TEST(UnkindShapes, ConeTip)
{
  // Half angle 30°. A tip at the distance d below the apex, next to the axis, is about d sin 30°
  // below the flank (facets change this). The force is normal to the flank: more sideways than up.
  // The closest point is d cos 30° down the flank.
  const double half = Pi / 6.0;
  const int around = 48;
  const auto body = uniformBody(cone(half, 20.0, around, 40));
  ToolContact contact(*body);
  // Slope of the flank in the middle of a facet.
  const double facet = std::atan(std::tan(half) * std::cos(Pi / around));
  const Vector3 outward(std::cos(Pi / around), std::sin(Pi / around), 0.0);
  for (int i = 1; i <= 300; ++i)
  {
    const double d = 0.01 * i;
    const Vector3 tip(1e-3 * outward.x(), 1e-3 * outward.y(), -d);
    const Contact found = contact.update(tip);
    if (d * std::sin(facet) <= 1e-3 * std::cos(facet))
    {
      EXPECT_EQ(found.state, ContactState::None);
      continue;
    }
    const double depth = d * std::sin(facet) - 1e-3 * std::cos(facet);
    EXPECT_NEAR(found.deflection, depth, 1e-5);
    EXPECT_NEAR(found.normalForce, law(depth), 3e-4);
    // beyond the first ring, which has the normal of the apex at one corner
    if (d * std::cos(facet) > 0.6)
    {
      const Vector3 flank = std::cos(facet) * outward + std::sin(facet) * Vector3::UnitZ();
      EXPECT_LE((found.normal - flank).norm(), 0.066);
    }
  }
  // Across the axis the contact changes to the other flank: the sideways force reverses, and the
  // upward force keeps its value.
  const Contact before = contact.update(-3.0 * Vector3::UnitZ() + 0.01 * outward);
  const Contact after = contact.update(-3.0 * Vector3::UnitZ() - 0.01 * outward);
  EXPECT_LE((before.force - 2.0 * before.force.z() * Vector3::UnitZ() + after.force).norm(), 0.01);
  EXPECT_GT(before.force.dot(outward), 0.8 * before.normalForce);
}

TEST(UnkindShapes, Saddle)
{
  // The inner side of a torus, with curvatures 1/14 and -1/6, at a depth of 1 mm in several
  // directions.
  const double R = 20.0;
  const double r = 6.0;
  const Surface given = torus(R, r, 120, 60);
  const auto body = uniformBody(given);
  for (const double tilt : { 0.0, 0.5, 1.5 })
  {
    ToolContact contact(*body);
    double last = -1.0;
    for (int i = 0; i <= 1000; ++i)
    {
      const double t = -0.5 + 1e-3 * i;
      const double u = std::cos(tilt) * t;
      const double v = Pi + std::sin(tilt) * t;
      const auto at = [&](double minor)
      {
        const double radius = R + minor * std::cos(v);
        return Vector3(radius * std::cos(u), radius * std::sin(u), minor * std::sin(v));
      };
      const Vector3 normal = at(r + 0.5) - at(r - 0.5);
      const Contact found = contact.update(at(r - 1.0));
      // Facets of 1.05 mm along the hole and 0.63 mm around the tube are within h²/8R = 0.008 and
      // 0.0082 of the torus, outside in one direction and inside in the other.
      EXPECT_NEAR(found.deflection, 1.0, 0.017);
      EXPECT_NEAR(found.normalForce, law(found.deflection), 3e-4);
      // Normals differ by half the angle between facets, at most 0.37/14 and 0.32/6, plus blends of
      // second order.
      EXPECT_LE((found.normal - normal).norm(), 0.06);
      EXPECT_NEAR(found.normalForce, last < 0.0 ? found.normalForce : last, 0.05);
      last = found.normalForce;
    }
  }
}
} // namespace palpate::testing
