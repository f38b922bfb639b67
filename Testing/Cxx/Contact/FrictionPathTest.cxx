// SPDX-License-Identifier: BSD-3-Clause
// The three friction models along given paths on a plane. The number of ticks has no effect on a
// straight path. On a circle the forces agree with the models' differential equations, which are
// integrated here in small steps.
#include "Contact/Friction.h"
#include "FrictionCurves.h"
#include "Sanitized.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace palpate::testing;
using palpate::Friction;
using palpate::FrictionModel;
using palpate::FrictionSettings;
using palpate::Pi;
using palpate::Vector2;
using palpate::Vector3;

namespace
{
/// A contact at a depth of 1 mm with 10 N: limit 5 N, z_max 2.5 mm. ShapeDerived slides at 0.75 mm.
class Slider
{
public:
  explicit Slider(FrictionSettings settings)
    : Model(settings)
  {
    this->moveTo({ 0.0, 0.0 });
  }
  Vector2 moveTo(const Vector2& point)
  {
    const auto result = this->Model.update(
      { point.x(), point.y(), 0.0 }, Vector3::UnitZ(), this->Curve.force(1.0), 1.0, this->Curve);
    this->Point = point;
    this->Sliding = result.sliding;
    EXPECT_NEAR(result.force.z(), 0.0, 1e-15);
    return result.force.head<2>();
  }
  Vector2 move(const Vector2& displacement, int ticks)
  {
    const Vector2 start = this->Point;
    Vector2 force = Vector2::Zero();
    for (int i = 1; i <= ticks; ++i)
    {
      force = this->moveTo(start + displacement * i / ticks);
    }
    return force;
  }
  bool sliding() const { return this->Sliding; }

private:
  PowerCurve Curve;
  Friction Model;
  Vector2 Point = Vector2::Zero();
  bool Sliding = false;
};

constexpr double Limit = 5.0;
constexpr double Longest = 2.5;

Vector2 direction(double angle)
{
  return { std::cos(angle), std::sin(angle) };
}

/// Solves z' = rate(z, d) along the circle of radius rho from its lowest point, by Runge-Kutta.
/// Many steps are needed because limiting |z| reduces the order to one.
Vector2 onCircle(const std::function<Vector2(const Vector2&, const Vector2&)>& rate, double rho,
  double angle, int steps, bool clipped)
{
  Vector2 z = Vector2::Zero();
  const double h = angle / steps;
  for (int i = 0; i < steps; ++i)
  {
    const auto at = [&](double part, const Vector2& state)
    { return Vector2(rho * h * rate(state, direction((i + part) * h))); };
    const Vector2 k1 = at(0.0, z);
    const Vector2 k2 = at(0.5, z + 0.5 * k1);
    const Vector2 k3 = at(0.5, z + 0.5 * k2);
    const Vector2 k4 = at(1.0, z + k3);
    z += (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
    if (clipped && z.norm() > Longest)
    {
      z *= Longest / z.norm();
    }
  }
  return z;
}

/// The law of ElastoPlasticFriction as stated in its header.
std::function<Vector2(const Vector2&, const Vector2&)> elastoPlastic(double b, double s)
{
  return [=](const Vector2& z, const Vector2& d) -> Vector2
  {
    const double r = z.norm() / Longest;
    const double w = std::max(std::pow(r, 8) - std::pow(b, 8), 0.0);
    const double alpha = w > 0.0 ? w / (w + std::pow(s, 8) - std::pow(b, 8)) / Longest : 0.0;
    return r > 0.0 ? Vector2(d - alpha * z * std::max(d.dot(z) / z.norm(), 0.0)) : d;
  };
}
} // namespace

TEST(FrictionPath, TheNumberOfTicksDoesNotMatterOnAStraightWay)
{
  for (const FrictionModel model : FrictionModels)
  {
    // The result is exact, except for the creep of ElastoPlastic: Runge-Kutta in steps of 1/8
    // z_max, with a measured error of 2e-5.
    const double tolerance = model == FrictionModel::ElastoPlastic ? 3e-5 * Limit : 1e-12;
    for (const double before : { 0.0, 0.4, 1.9, 2.2, 10.0 })
    {
      for (double angle = 0.0; angle <= Pi; angle += Pi / 12.0)
      {
        for (const double length : { 0.1, 0.7, 1.8, 2.4, 5.0, 40.0 })
        {
          Vector2 forces[3];
          const int ticks[3] = { 1, 10, palpate::testing::casesOf(1000) };
          for (int i = 0; i < 3; ++i)
          {
            Slider slider(frictionOf(model, 0.5, 2.0));
            slider.move({ before, 0.0 }, 100);
            forces[i] = slider.move(length * direction(angle), ticks[i]);
          }
          EXPECT_LE((forces[0] - forces[2]).norm(), tolerance) << before << ' ' << angle;
          EXPECT_LE((forces[1] - forces[2]).norm(), tolerance) << before << ' ' << angle;
        }
      }
    }
  }
}

TEST(FrictionPath, LongWaysSlide)
{
  for (const FrictionModel model : FrictionModels)
  {
    Slider slider(frictionOf(model, 0.5, 2.0));
    slider.move({ 0.0, 2.0 }, 7);
    const Vector2 force = slider.move({ 100.0, 0.0 }, 1);
    EXPECT_LE((force - Vector2(-Limit, 0.0)).norm(), 1e-14); // e^-40
    EXPECT_TRUE(slider.sliding());
  }
}

TEST(FrictionPath, SlidesWhenTheLimitIsReached)
{
  Slider dahl(frictionOf(FrictionModel::Dahl, 0.5, 2.0));
  dahl.move({ 4.60 * Longest, 0.0 }, 5); // 1 - e^-4.60 = 0.98995
  EXPECT_FALSE(dahl.sliding());
  dahl.move({ 0.01 * Longest, 0.0 }, 1);
  EXPECT_TRUE(dahl.sliding());

  Slider shape(frictionOf(FrictionModel::ShapeDerived, 0.5, 2.0));
  // μcδ = 0.75 at ν = 0.5. The first of the springs touches at 7e-4 mm, not at 0.
  shape.move({ 0.749, 0.0 }, 3);
  EXPECT_FALSE(shape.sliding());
  shape.move({ 0.001, 0.0 }, 1);
  EXPECT_TRUE(shape.sliding());

  // ∫ dr/(1 - α r) from 0 to 1, by Simpson's rule.
  const auto slower = [](double r)
  {
    const double w = std::max(std::pow(r, 8) - std::pow(0.8, 8), 0.0);
    return 1.0 / (1.0 - r * w / (w + std::pow(0.9, 8) - std::pow(0.8, 8)));
  };
  double way = 0.8;
  const int n = 1000;
  for (int i = 0; i < n; ++i)
  {
    const double r = 0.8 + 0.2 * i / n;
    way += 0.2 / n / 6.0 * (slower(r) + 4.0 * slower(r + 0.1 / n) + slower(r + 0.2 / n));
  }
  Slider plastic(frictionOf(FrictionModel::ElastoPlastic, 0.5, 2.0));
  // Runge-Kutta has an error of 2e-5 of the force, at a slope of 1 - α = 0.24.
  plastic.move({ (way - 1e-4) * Longest, 0.0 }, 4);
  EXPECT_FALSE(plastic.sliding());
  plastic.move({ 2e-4 * Longest, 0.0 }, 1);
  EXPECT_TRUE(plastic.sliding());
  plastic.move({ -1e-6, 0.0 }, 1);
  EXPECT_FALSE(plastic.sliding());
}

TEST(FrictionPath, StuckIsASpring)
{
  // Below breakaway (4 N), on any path back and forth, the stiffness is exactly σ₀, and the force
  // at the start point is zero.
  Slider slider(frictionOf(FrictionModel::ElastoPlastic, 0.5, 2.0));
  for (int i = 1; i < 400; ++i)
  {
    const Vector2 point = 1.99 * std::sin(0.037 * i) * direction(1.3 * i);
    EXPECT_LE((slider.moveTo(point) + 2.0 * point).norm(), 1e-13);
    EXPECT_FALSE(slider.sliding());
  }
  EXPECT_LE(slider.moveTo({ 0.0, 0.0 }).norm(), 1e-13);
}

TEST(FrictionPath, SlopeAtReversal)
{
  // At reversal ElastoPlastic is elastic. Dahl has the stiffness σ₀(1 + z/z_max), twice the stable
  // limit of the loop.
  const double h = 1e-6;
  for (const FrictionModel model : { FrictionModel::ElastoPlastic, FrictionModel::Dahl })
  {
    Slider slider(frictionOf(model, 0.5, 2.0));
    const double before = slider.move({ 100.0, 0.0 }, 10).x();
    const double after = slider.move({ -h, 0.0 }, 1).x();
    const double slope = model == FrictionModel::Dahl ? 4.0 : 2.0;
    // Rounding of 100 mm divided by h, and for Dahl the second order, h/z_max.
    EXPECT_NEAR((after - before) / h, slope, 1e-6);
  }
}

TEST(FrictionPath, CircleAgainstTheEquations)
{
  const double rho = 6.0;
  const auto dahl = [](const Vector2& z, const Vector2& d) { return Vector2(d - z / Longest); };
  FrictionSettings eight = frictionOf(FrictionModel::ElastoPlastic, 0.5, 2.0);
  eight.breakaway = 0.0;
  const struct
  {
    FrictionSettings settings;
    std::function<Vector2(const Vector2&, const Vector2&)> rate;
    bool clipped;
  } cases[] = { { frictionOf(FrictionModel::Dahl, 0.5, 2.0), dahl, false },
    { frictionOf(FrictionModel::ElastoPlastic, 0.5, 2.0), elastoPlastic(0.8, 0.9), true },
    { eight, elastoPlastic(0.0, 0.9), true } };
  for (const auto& one : cases)
  {
    for (const double angle : { 0.3, 0.45, 1.0, 4.0, 15.0 })
    {
      const Vector2 expected = -2.0 *
        onCircle(one.rate, rho, angle, 5000 + static_cast<int>(15000.0 * angle), one.clipped);
      double errors[3];
      const int ticks[3] = { 40, 80, 4000 };
      for (int k = 0; k < 3; ++k)
      {
        Slider slider(one.settings);
        Vector2 force = Vector2::Zero();
        for (int i = 1; i <= ticks[k]; ++i)
        {
          const double phi = angle * i / ticks[k];
          force = slider.moveTo({ rho * std::sin(phi), rho * (1.0 - std::cos(phi)) });
        }
        errors[k] = (force - expected).norm();
      }
      // Chords are shorter than arcs by φ²/24, and their directions differ by the same amount. The
      // error of a tick decays over z_max. A tick in which the limit is reached adds the 2e-5 of
      // Runge-Kutta.
      for (int k = 0; k < 3; ++k)
      {
        const double chord = angle / ticks[k];
        EXPECT_LE(errors[k], Limit * (0.5 * chord * chord + 3e-5)) << angle << ' ' << ticks[k];
      }
    }
  }
}

// Sliding along a slightly curved path while the limit rises and falls, so that the load differs in
// every tick. Compared with the law above, integrated in steps of 1e-4 mm.
TEST(FrictionPath, TheLoadChangesWhileItSlides)
{
  for (const double stickRadius : { 0.85, 0.9, 1.3 })
  {
    FrictionSettings settings = frictionOf(FrictionModel::ElastoPlastic, 0.5, 2.0);
    settings.stickRadius = stickRadius;
    palpate::ElastoPlasticFriction friction(settings);
    const auto law = elastoPlastic(settings.breakaway, stickRadius);
    Vector2 z = Vector2::Zero();
    int sliding = 0;
    double worst = 0.0;
    for (int tick = 0; tick < 3000; ++tick)
    {
      const double longest = Longest * (1.0 + 0.3 * std::sin(0.005 * tick));
      const double scale = Longest / longest; // the law uses z / Longest
      const Vector2 along = direction(2e-4 * tick);
      const double length = 0.05;
      z *= scale;
      constexpr int pieces = 500;
      for (int i = 0; i < pieces; ++i)
      {
        z *= std::min(1.0, Longest / std::max(z.norm(), 1e-300));
        z += length / pieces * scale * law(z, along);
      }
      z *= std::min(1.0, Longest / z.norm());
      z /= scale;
      const auto felt = friction.update(palpate::StraightStep(length * along), 2.0 * longest);
      worst = std::max(worst, (felt.force + 2.0 * z).norm() / (2.0 * longest));
      sliding += felt.sliding;
    }
    // Relative to the limit. The steps of Euler's method are 4e-5 of z_max.
    EXPECT_LT(worst, 1e-4) << stickRadius;
    EXPECT_GT(sliding, 2000) << stickRadius;
  }
}

TEST(FrictionPath, SteadyOnACircle)
{
  // The force is opposite to the direction of motion except for a lag: asin(z_max/ρ) as for a stone
  // pulled on a string, or atan(z_max/ρ) for Dahl, whose force is cos(lag) times the limit.
  const double rho = 10.0;
  const int perTurn = 20000;
  for (const FrictionModel model : { FrictionModel::ElastoPlastic, FrictionModel::Dahl })
  {
    Slider slider(frictionOf(model, 0.5, 2.0));
    Vector2 force = Vector2::Zero();
    double phi = 0.0;
    for (int i = 1; i <= 4 * perTurn; ++i)
    {
      phi = 2.0 * Pi * i / perTurn;
      force = slider.moveTo({ rho * std::sin(phi), rho * (1.0 - std::cos(phi)) });
    }
    const bool isDahl = model == FrictionModel::Dahl;
    const double lag = isDahl ? std::atan(Longest / rho) : std::asin(Longest / rho);
    const Vector2 expected = -Limit * (isDahl ? std::cos(lag) : 1.0) * direction(phi - lag);
    EXPECT_LE((force - expected).norm(), 1e-6 * Limit); // square of the angle per tick, 3e-4
    EXPECT_TRUE(slider.sliding() || isDahl);
    EXPECT_NEAR(force.norm(), isDahl ? Limit * std::cos(lag) : Limit, 1e-6);
  }
  // Each spring of ShapeDerived lags by its own asin(limit/ρ), the longest by asin(0.75/ρ). The
  // force is Σ limit_j (sin, cos) with the load density of f = 10 δ^1.5, by the midpoint rule.
  Slider slider(frictionOf(FrictionModel::ShapeDerived, 0.5, 2.0));
  Vector2 force = Vector2::Zero();
  double phi = 0.0;
  for (int i = 1; i <= 2 * perTurn; ++i)
  {
    phi = 2.0 * Pi * i / perTurn;
    force = slider.moveTo({ rho * std::sin(phi), rho * (1.0 - std::cos(phi)) });
  }
  Vector2 expected = Vector2::Zero();
  const int n = 20000;
  for (int j = 0; j < n; ++j)
  {
    const double root = (j + 0.5) / n; // √η; f'' dη = 7.5 η^-½ dη = 15 d√η
    const double unloaded = 1.0 - root * root;
    expected -= 0.5 * 15.0 / n * unloaded * direction(phi - std::asin(0.75 * unloaded / rho));
  }
  // Within a cell of lumped springs the limits differ by 1/64, which is an error of second order in
  // the lag.
  EXPECT_LE((force - expected).norm(), 1e-5 * Limit);
  EXPECT_TRUE(slider.sliding());
}
