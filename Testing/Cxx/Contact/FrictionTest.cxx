// SPDX-License-Identifier: BSD-3-Clause
// The interface of Friction: inputs and outputs, limits, invalid input, curved bodies.
#include "Contact/Friction.h"
#include "FrictionCurves.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace palpate::testing;
using palpate::Friction;
using palpate::FrictionModel;
using palpate::FrictionSettings;
using palpate::Infinity;
using palpate::NotANumber;
using palpate::Pi;
using palpate::Vector3;

namespace
{
FrictionSettings rubbingOf(FrictionModel model)
{
  FrictionSettings settings = frictionOf(model, 0.5, 4.0);
  settings.poissonRatio = 0.45;
  return settings;
}

const PowerCurve Curve;

Friction::Result press(
  Friction& friction, const Vector3& point, const Vector3& normal = Vector3::UnitZ())
{
  return friction.update(point, normal, Curve.force(1.0), 1.0, Curve);
}

bool isNone(const Friction::Result& result)
{
  return result.force == Vector3::Zero() && result.sliding;
}
} // namespace

TEST(Friction, FirstContactHasNoPreSliding)
{
  for (const FrictionModel model : FrictionModels)
  {
    Friction friction(rubbingOf(model));
    for (int i = 0; i < 2; ++i)
    {
      const auto first = press(friction, { 3.0, 4.0, 0.0 });
      EXPECT_EQ(first.force, Vector3::Zero());
      EXPECT_FALSE(first.sliding);
      const auto second = press(friction, { 3.1, 4.0, 0.0 });
      EXPECT_LT(second.force.x(), 0.0);
      EXPECT_NEAR(second.force.y(), 0.0, 1e-14);
      friction.reset();
    }
  }
}

TEST(Friction, NoneWithoutCoefficientOrLoad)
{
  for (const FrictionModel model : FrictionModels)
  {
    FrictionSettings without = rubbingOf(model);
    without.coefficient = 0.0;
    Friction frictionless(without);
    Friction friction(rubbingOf(model));
    for (int i = 0; i < 5; ++i)
    {
      const Vector3 point(0.3 * i, 0.0, 0.0);
      EXPECT_TRUE(isNone(press(frictionless, point)));
      EXPECT_TRUE(isNone(friction.update(point, Vector3::UnitZ(), 0.0, 0.0, Curve)));
      EXPECT_TRUE(isNone(friction.update(point, Vector3::UnitZ(), -1.0, 1.0, Curve)));
    }
  }
}

TEST(Friction, SettingsOutOfRangeGiveNone)
{
  for (const FrictionModel model : FrictionModels)
  {
    for (const double bad : { NotANumber, Infinity, -1.0 })
    {
      FrictionSettings settings = rubbingOf(model);
      (model == FrictionModel::ShapeDerived ? settings.poissonRatio
                                            : settings.tangentialStiffness) = bad;
      Friction friction(settings);
      press(friction, Vector3::Zero());
      EXPECT_TRUE(isNone(press(friction, Vector3::UnitX())));
      settings = rubbingOf(model);
      settings.coefficient = bad;
      Friction other(settings);
      press(other, Vector3::Zero());
      EXPECT_TRUE(isNone(press(other, Vector3::UnitX())));
    }
  }
  FrictionSettings settings = rubbingOf(FrictionModel::ElastoPlastic);
  settings.breakaway = 1.5;
  Friction friction(settings);
  press(friction, Vector3::Zero());
  EXPECT_TRUE(isNone(press(friction, Vector3::UnitX())));
}

TEST(Friction, WhatIsNotFiniteEndsTheHistory)
{
  for (const FrictionModel model : FrictionModels)
  {
    for (const double bad : { NotANumber, Infinity, -Infinity })
    {
      for (int field = 0; field < 4; ++field)
      {
        Friction friction(rubbingOf(model));
        press(friction, Vector3::Zero());
        EXPECT_NE(press(friction, { 0.1, 0.0, 0.0 }).force, Vector3::Zero());
        const Vector3 point(0.1, field == 0 ? bad : 0.0, 0.0);
        const Vector3 normal(0.0, field == 1 ? bad : 0.0, 1.0);
        EXPECT_TRUE(isNone(
          friction.update(point, normal, field == 2 ? bad : 10.0, field == 3 ? bad : 1.0, Curve)));
        EXPECT_EQ(press(friction, { 0.2, 0.0, 0.0 }).force, Vector3::Zero());
        EXPECT_LT(press(friction, { 0.3, 0.0, 0.0 }).force.x(), 0.0);
      }
    }
    Friction friction(rubbingOf(model));
    press(friction, Vector3::Zero());
    EXPECT_TRUE(isNone(press(friction, Vector3::UnitX(), Vector3::Zero())));
    EXPECT_TRUE(isNone(press(friction, Vector3::UnitX(), { 0.0, 0.0, 2.0 })));
  }
  struct Broken
  {
    palpate::ResponseValue evaluate(double) const { return { NotANumber, NotANumber, false }; }
    double range() const { return NotANumber; }
  } const broken;
  Friction friction(rubbingOf(FrictionModel::ShapeDerived));
  press(friction, Vector3::Zero());
  EXPECT_TRUE(isNone(friction.update({ 0.1, 0.0, 0.0 }, Vector3::UnitZ(), 10.0, 1.0, broken)));
  press(friction, { 0.2, 0.0, 0.0 });
  EXPECT_LT(press(friction, { 0.3, 0.0, 0.0 }).force.x(), 0.0);
}

TEST(Friction, AStandingContactKeepsItsForce)
{
  for (const FrictionModel model : FrictionModels)
  {
    for (const double way : { 0.05, 50.0 })
    {
      Friction friction(rubbingOf(model));
      press(friction, Vector3::Zero());
      const auto moved = press(friction, { way, 0.0, 0.0 });
      EXPECT_EQ(moved.sliding, way > 1.0);
      for (int i = 0; i < 1000; ++i)
      {
        const auto standing = press(friction, { way, 0.0, 0.0 });
        EXPECT_NEAR(standing.force.x(), moved.force.x(), 1e-12); // rounding of the frame
        EXPECT_EQ(standing.sliding, moved.sliding);
      }
    }
  }
}

TEST(Friction, ATinyLimitAndAHugeStep)
{
  for (const FrictionModel model : FrictionModels)
  {
    for (const double force : { 1e-320, 1e-200, 1e-12, 1e12 })
    {
      for (const double step : { 1e-300, 1e-30, 1.0, 1e6 })
      {
        Friction friction(rubbingOf(model));
        friction.update(Vector3::Zero(), Vector3::UnitZ(), force, 1.0, Curve);
        const auto result =
          friction.update({ 0.6 * step, 0.8 * step, 0.0 }, Vector3::UnitZ(), force, 1.0, Curve);
        EXPECT_TRUE(result.force.allFinite());
        EXPECT_LE(result.force.norm(), 0.5 * force * (1.0 + 1e-12));
      }
    }
  }
}

TEST(Friction, NeverBeyondCoulombsLimitAndTangential)
{
  std::mt19937 random(5);
  std::normal_distribution<double> share;
  for (const FrictionModel model : FrictionModels)
  {
    Friction friction(rubbingOf(model));
    Vector3 point(20.0, 0.0, 0.0);
    for (int i = 0; i < 20000; ++i)
    {
      const double step = i % 100 < 50 ? 0.01 : 1.0;
      point += step * Vector3(share(random), share(random), share(random));
      const Vector3 normal = point.normalized();
      point = 20.0 * normal;
      const double depth = std::abs(share(random));
      const double force = Curve.force(depth) * (i % 7 == 0 ? 1.3 : 1.0);
      const auto result = friction.update(point, normal, force, depth, Curve);
      ASSERT_LE(result.force.norm(), 0.5 * force * (1.0 + 1e-14));
      ASSERT_LE(std::abs(result.force.dot(normal)), 1e-15 * force);
    }
  }
}

TEST(Friction, OppositeNormalsEndTheHistory)
{
  for (const FrictionModel model : FrictionModels)
  {
    Friction friction(rubbingOf(model));
    press(friction, Vector3::Zero());
    EXPECT_LT(press(friction, { 0.1, 0.0, 0.0 }).force.x(), 0.0);
    const auto flipped = press(friction, { 0.2, 0.0, 0.0 }, -Vector3::UnitZ());
    EXPECT_EQ(flipped.force, Vector3::Zero());
    EXPECT_LT(press(friction, { 0.3, 0.0, 0.0 }, -Vector3::UnitZ()).force.x(), 0.0);
  }
}

TEST(Friction, IsCarriedOverACurvedBody)
{
  // The contact sticks at a fixed point while the normal moves once around a circle of latitude.
  // The force rotates by the solid angle, 2π(1 - cos), and keeps its magnitude.
  const double colatitude = 0.6;
  const int n = 40000;
  const auto normalAt = [&](int i)
  {
    const double phi = 2.0 * Pi * (i % n) / n;
    return Vector3(std::sin(colatitude) * std::cos(phi), std::sin(colatitude) * std::sin(phi),
      std::cos(colatitude));
  };
  for (const FrictionModel model : FrictionModels)
  {
    Friction friction(rubbingOf(model));
    press(friction, Vector3::Zero(), normalAt(0));
    const Vector3 start = 0.1 * normalAt(0).unitOrthogonal();
    const Vector3 before = press(friction, start, normalAt(0)).force;
    Vector3 after = before;
    for (int i = 1; i <= n; ++i)
    {
      after = press(friction, start, normalAt(i)).force;
    }
    const Vector3 turned =
      Eigen::AngleAxisd(2.0 * Pi * (1.0 - std::cos(colatitude)), normalAt(0)) * before;
    // The polygon of n sides differs by at most 8/n²; rounding of n ticks is added.
    EXPECT_LE((after - turned).norm(), (8.0 / n / n + 1e-10) * before.norm());
  }
}

TEST(Friction, SlidesAroundASphere)
{
  // A circle of latitude has the geodesic curvature cot(colatitude)/R. On the surface it is a
  // circle of radius R tan(colatitude), and the force lags as on a plane circle of this radius.
  const double R = 20.0;
  const double colatitude = 0.5;
  const double rho = R * std::tan(colatitude);
  const double longest = 0.5 * 10.0 / 4.0;
  const int perTurn = 20000;
  for (const FrictionModel model : { FrictionModel::ElastoPlastic, FrictionModel::Dahl })
  {
    Friction friction(rubbingOf(model));
    Vector3 normal;
    Vector3 along;
    Vector3 force;
    for (int i = 0; i <= 2 * perTurn; ++i)
    {
      const double phi = 2.0 * Pi * i / perTurn;
      normal = { std::sin(colatitude) * std::cos(phi), std::sin(colatitude) * std::sin(phi),
        std::cos(colatitude) };
      along = { -std::sin(phi), std::cos(phi), 0.0 };
      force = press(friction, R * normal, normal).force;
    }
    const bool isDahl = model == FrictionModel::Dahl;
    const double lag = isDahl ? std::atan(longest / rho) : std::asin(longest / rho);
    const double size = 0.5 * 10.0 * (isDahl ? std::cos(lag) : 1.0);
    // The pole is to the left of the motion; the path turns towards it.
    const Vector3 expected = -size * (std::cos(lag) * along - std::sin(lag) * normal.cross(along));
    EXPECT_LE((force - expected).norm(), 1e-6 * size); // square of the angle per tick, 3e-4
  }
}
