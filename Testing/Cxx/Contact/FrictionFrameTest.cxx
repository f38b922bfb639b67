// SPDX-License-Identifier: BSD-3-Clause
// Parallel transport against the geometry of the sphere.
#include "Contact/FrictionFrame.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using palpate::FrictionFrame;
using palpate::Pi;
using palpate::Vector2;
using palpate::Vector3;

namespace
{
Vector3 onSphere(double colatitude, double longitude)
{
  return { std::sin(colatitude) * std::cos(longitude), std::sin(colatitude) * std::sin(longitude),
    std::cos(colatitude) };
}

/// Angle from a to b about the axis, counter-clockwise, in (-π, π].
double angleAbout(const Vector3& axis, const Vector3& a, const Vector3& b)
{
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

/// Rotation of a tangent vector at a fixed point after the normal has moved once around a circle of
/// latitude in n ticks.
double turnAround(double colatitude, int n)
{
  FrictionFrame frame;
  const Vector3 point(1.0, 2.0, 3.0);
  const Vector3 start = onSphere(colatitude, 0.0);
  frame.advance(point, start);
  const Vector3 before = frame.toSpace({ 0.6, 0.8 });
  for (int i = 1; i <= n; ++i)
  {
    EXPECT_TRUE(frame.advance(point, i < n ? onSphere(colatitude, 2.0 * Pi * i / n) : start));
    EXPECT_EQ(frame.step().displacement(), Vector2::Zero());
  }
  return angleAbout(start, before, frame.toSpace({ 0.6, 0.8 }));
}
} // namespace

TEST(FrictionFrame, AroundALatitudeCircleItTurnsByTheSolidAngle)
{
  for (const double colatitude : { 0.1, 0.7, 1.2, 0.5 * Pi, 2.0 })
  {
    for (const int n : { 3, 7, 100, 5000 })
    {
      // Ticks are arcs of great circles. They form a polygon of n triangles that meet at the pole,
      // with the angles 2π/n, β, β and cot β = cos(colatitude) tan(π/n). The area of the polygon is
      // the excess of its angles.
      const double cotangent = std::cos(colatitude) * std::tan(Pi / n);
      const double beta = 0.5 * Pi - std::atan(cotangent);
      const double area = 2.0 * Pi + n * (2.0 * beta - Pi);
      // Tolerance for n roundings.
      EXPECT_NEAR(
        std::remainder(turnAround(colatitude, n) - area, 2.0 * Pi), 0.0, 1e-15 * n + 1e-14)
        << colatitude << " in " << n;
    }
    // The circle itself: the area of the polygon is smaller by 2π³/3 cos sin² / n² <= 8/n².
    const int n = 20000;
    EXPECT_NEAR(
      std::remainder(turnAround(colatitude, n) - 2.0 * Pi * (1.0 - std::cos(colatitude)), 2.0 * Pi),
      0.0, 8.0 / n / n + 1e-11);
  }
}

TEST(FrictionFrame, GoingBackUndoes)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Vector3> directions{ Vector3::UnitZ() };
  for (int i = 0; i < 500; ++i)
  {
    directions.push_back(
      (directions.back() + 0.3 * Vector3(normal(random), normal(random), normal(random)))
        .normalized());
  }
  const double R = 20.0;
  FrictionFrame frame;
  frame.advance(R * directions[0], directions[0]);
  const Vector3 first = frame.toSpace({ 1.0, 0.0 });
  std::vector<Vector2> out;
  for (std::size_t i = 1; i < directions.size(); ++i)
  {
    ASSERT_TRUE(frame.advance(R * directions[i], directions[i]));
    out.push_back(frame.step().displacement());
  }
  for (std::size_t i = directions.size() - 1; i-- > 0;)
  {
    ASSERT_TRUE(frame.advance(R * directions[i], directions[i]));
    // Rounding of 20 mm over 500 rotations.
    EXPECT_LE((frame.step().displacement() + out[i]).norm(), 1e-12);
  }
  EXPECT_LE((frame.toSpace({ 1.0, 0.0 }) - first).norm(), 1e-13);
}

TEST(FrictionFrame, DisplacementIsTheArc)
{
  const double R = 20.0;
  // The next term of the series is 5/112 sin⁶(φ/2); half of it is added for the further terms.
  for (const double turn : { 1e-6, 0.01, 0.1, 0.3, 1.0, 0.5 * Pi })
  {
    FrictionFrame frame;
    const Vector3 axis = Vector3(1.0, -2.0, 0.5).normalized();
    const Vector3 start = axis.unitOrthogonal();
    frame.advance(R * start, start);
    Vector2 first = Vector2::Zero();
    for (int i = 1; i <= 20; ++i)
    {
      const Vector3 normal = Eigen::AngleAxisd(turn * i, axis) * start;
      ASSERT_TRUE(frame.advance(R * normal, normal));
      const Vector2 displacement = frame.step().displacement();
      const double missing = 5.0 / 112.0 * std::pow(std::sin(0.5 * turn), 6);
      EXPECT_NEAR(displacement.norm() / (R * turn), 1.0, 1.5 * missing + 1e-15 / turn + 1e-14);
      if (i == 1)
      {
        first = displacement;
      }
      // On a great circle the displacement has a constant direction, to the rounding of points,
      // 4e-15 of R.
      EXPECT_LE((displacement - first).norm(), 1e-13);
      EXPECT_LE((frame.toSpace(displacement.normalized()) - axis.cross(normal)).norm(),
        1e-14 / turn + 1e-13);
    }
  }
}

TEST(FrictionFrame, OnAPlaneItIsTheChord)
{
  FrictionFrame frame;
  const Vector3 normal = Vector3(1.0, 2.0, -2.0) / 3.0;
  Vector3 point(5.0, -3.0, 2.0);
  frame.advance(point, normal);
  std::mt19937 random(2);
  std::normal_distribution<double> share;
  for (int i = 0; i < 100; ++i)
  {
    Vector3 chord(share(random), share(random), share(random));
    chord -= chord.dot(normal) * normal;
    point += chord;
    frame.advance(point, normal);
    // rounding of coordinates of 20 mm
    EXPECT_LE((frame.toSpace(frame.step().displacement()) - chord).norm(), 2e-14);
  }
}

TEST(FrictionFrame, AChordOutOfThePlaneIsTurnedIntoIt)
{
  // A facet tilted by 0.1 rad against the blended normal, as on a coarse mesh.
  const Vector3 chord(std::cos(0.1), 0.0, std::sin(0.1));
  FrictionFrame frame;
  frame.advance(Vector3::Zero(), Vector3::UnitZ());
  frame.advance(chord, Vector3::UnitZ());
  EXPECT_LE((frame.toSpace(frame.step().displacement()) - Vector3::UnitX()).norm(), 1e-15);
  // A chord along the normal has no tangential direction.
  frame.advance(chord + 3.0 * Vector3::UnitZ(), Vector3::UnitZ());
  EXPECT_EQ(frame.step().displacement(), Vector2::Zero());
  frame.advance(chord + 6.0 * Vector3::UnitZ() + 0.01 * Vector3::UnitX(), Vector3::UnitZ());
  EXPECT_NEAR(frame.step().displacement().norm(), 0.02, 1e-15);
}

TEST(FrictionFrame, OppositeNormalsStartAnew)
{
  for (const double angle : { 0.0, 0.5, 2.0, 3.0, 3.09, 3.11, Pi - 1e-9, Pi })
  {
    FrictionFrame frame;
    EXPECT_FALSE(frame.advance(Vector3::Zero(), Vector3::UnitZ()));
    const Vector3 normal(std::sin(angle), 0.0, std::cos(angle));
    const bool carried = frame.advance({ 1.0, 1.0, 0.0 }, normal);
    EXPECT_EQ(carried, std::cos(angle) > -0.999); // the limit is 177.4 degrees
    const Vector3 first = frame.toSpace({ 1.0, 0.0 });
    const Vector3 second = frame.toSpace({ 0.0, 1.0 });
    // Error of a division by 1 + cos >= 1e-3.
    EXPECT_NEAR(first.norm(), 1.0, 1e-12);
    EXPECT_NEAR(second.norm(), 1.0, 1e-12);
    EXPECT_NEAR(first.dot(normal), 0.0, 1e-12);
    EXPECT_LE((first.cross(second) - normal).norm(), 1e-12);
    EXPECT_EQ(frame.step().displacement() == Vector2::Zero(), !carried);
  }
}

TEST(StraightStep, DecayIsTheExponential)
{
  // 1.5 units in the last place, inside the polynomial's range and beyond it.
  for (double x = 0.0; x < 2.0; x += 1e-3)
  {
    EXPECT_NEAR(palpate::StraightStep::decay(x) / std::exp(-x), 1.0, 3.4e-16) << x;
  }
  EXPECT_EQ(palpate::StraightStep::decay(0.0), 1.0);
  EXPECT_EQ(palpate::StraightStep::decay(1e300), 0.0);
  EXPECT_TRUE(std::isnan(palpate::StraightStep::decay(std::numeric_limits<double>::quiet_NaN())));
}

TEST(FrictionFrame, StaysAFrame)
{
  std::mt19937 random(3);
  std::normal_distribution<double> share;
  FrictionFrame frame;
  Vector3 normal = Vector3::UnitZ();
  for (int i = 0; i < 200000; ++i)
  {
    normal = (normal + 0.2 * Vector3(share(random), share(random), share(random))).normalized();
    frame.advance(normal, normal);
  }
  const Vector3 first = frame.toSpace({ 1.0, 0.0 });
  const Vector3 second = frame.toSpace({ 0.0, 1.0 });
  // The frame is corrected in every tick, so only the rounding of one tick remains.
  EXPECT_NEAR(first.norm(), 1.0, 2e-15);
  EXPECT_NEAR(second.norm(), 1.0, 2e-15);
  EXPECT_NEAR(first.dot(normal), 0.0, 2e-15);
  EXPECT_NEAR(first.dot(second), 0.0, 2e-15);
}
