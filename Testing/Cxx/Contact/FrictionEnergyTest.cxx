// SPDX-License-Identifier: BSD-3-Clause
// From the first contact on, friction never returns more energy than it took, for any motion of
// point and depth and for responses that differ: the work of the tool against friction is always >=
// 0.
#include "Contact/Friction.h"
#include "FrictionCurves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace palpate::testing;
using palpate::Friction;
using palpate::FrictionModel;
using palpate::FrictionSettings;
using palpate::ShapeFriction;
using palpate::Vector2;
using palpate::Vector3;

namespace
{
struct PressedContact
{
  Vector2 point;
  double depth;
  double factor; ///< factor of the response at the point
};
using Path = std::function<PressedContact(double)>;
/// Tangential force on the tool in a contact.
using Answer = std::function<Vector2(const PressedContact&)>;

/// The smallest and the final work along the path from t = 0 to the end, N mm, by the trapezoidal
/// rule.
struct Work
{
  double least = 0.0;
  double last = 0.0;
};

Work workAlong(const Path& path, double end, int ticks, const Answer& answer)
{
  Work work;
  PressedContact before = path(0.0);
  Vector2 forceBefore = answer(before);
  for (int i = 1; i <= ticks; ++i)
  {
    const PressedContact contact = path(end * i / ticks);
    const Vector2 force = answer(contact);
    work.last -= 0.5 * (force + forceBefore).dot(contact.point - before.point);
    work.least = std::min(work.least, work.last);
    before = contact;
    forceBefore = force;
  }
  return work;
}

PowerCurve curveAt(const PressedContact& contact)
{
  PowerCurve curve;
  curve.factor = contact.factor;
  return curve;
}

Answer answerOf(Friction& friction)
{
  return [&friction](const PressedContact& contact) -> Vector2
  {
    const PowerCurve curve = curveAt(contact);
    return friction
      .update({ contact.point.x(), contact.point.y(), 0.0 }, Vector3::UnitZ(),
        curve.force(contact.depth), contact.depth, curve)
      .force.head<2>();
  };
}

/// Pre-sliding with σ₀ = μ f_n/z_max as in Hayward and Armstrong, with stick and slide.
Answer proportionalStiffness(Vector2& z, Vector2& last)
{
  return [&z, &last](const PressedContact& contact) -> Vector2
  {
    z += contact.point - last;
    z *= std::min(1.0, 0.5 / std::max(z.norm(), 1e-300));
    last = contact.point;
    return -0.5 * curveAt(contact).force(contact.depth) / 0.5 * z;
  };
}

/// Each coordinate and the depth are sums of three incommensurable oscillations, within `reach` mm
/// and between 0.05 and 1.95 mm.
Path wandering(unsigned seed, double reach, double variation)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double a[9];
  double w[9];
  for (int i = 0; i < 9; ++i)
  {
    a[i] = share(random);
    w[i] = 0.5 + 3.0 * share(random);
  }
  return [=](double t) -> PressedContact
  {
    const auto swing = [&](int first)
    {
      return (a[first] * std::sin(w[first] * t) + a[first + 1] * std::sin(w[first + 1] * t) +
               a[first + 2] * std::sin(w[first + 2] * t)) /
        (a[first] + a[first + 1] + a[first + 2]);
    };
    const Vector2 point(reach * swing(0), reach * swing(3));
    return { point, 1.0 + 0.95 * swing(6), 10.0 * (1.0 + variation * std::sin(8.0 * point.x())) };
  };
}

/// The cycle that gains most energy from a stiffness proportional to the normal force: push at a
/// small depth, press, return at a large depth, lift.
Path pressAndReturn(double reach)
{
  return [=](double t) -> PressedContact
  {
    const double part = std::fmod(t, 4.0);
    const auto smooth = [](double s)
    {
      const double clamped = std::clamp(s, 0.0, 1.0);
      return clamped * clamped * (3.0 - 2.0 * clamped);
    };
    const double out = smooth(part) - smooth(part - 2.0);
    const double deep = smooth(part - 1.0) - smooth(part - 3.0);
    return { { reach * out, 0.0 }, 0.5 + deep, 10.0 };
  };
}
} // namespace

TEST(FrictionEnergy, NeverGivenBackMoreThanTaken)
{
  for (const FrictionModel model : FrictionModels)
  {
    for (unsigned seed = 0; seed < 12; ++seed)
    {
      const double reach = seed % 3 == 0 ? 0.1 : seed % 3 == 1 ? 0.5 : 3.0;
      const double variation = seed % 2 == 0 ? 0.0 : 0.3;
      Friction friction(frictionOf(model, 0.5, 5.0));
      const Work work =
        workAlong(wandering(seed, reach, variation), 40.0, 40000, answerOf(friction));
      // At a kink of the force the trapezoidal rule has an error of σ₀ dx²/8, with dx < 0.01 mm: at
      // most 4e-5. This is a part of the work of 10 N over a hundredth of a millimetre at the
      // start.
      EXPECT_GE(work.least, -1e-5) << static_cast<int>(model) << ' ' << seed;
      EXPECT_GT(work.last, 0.0);
    }
  }
}

TEST(FrictionEnergy, PressAndReturn)
{
  for (const double reach : { 0.05, 0.3, 2.0 })
  {
    for (const FrictionModel model : FrictionModels)
    {
      Friction friction(frictionOf(model, 0.5, 5.0));
      const Work work = workAlong(pressAndReturn(reach), 40.0, 40000, answerOf(friction));
      EXPECT_GE(work.least, -1e-9) << static_cast<int>(model) << ' ' << reach;
      // After ten cycles one more cycle dissipates energy as well.
      const Work next = workAlong(pressAndReturn(reach), 4.0, 4000, answerOf(friction));
      EXPECT_GE(next.last, -1e-9) << static_cast<int>(model) << ' ' << reach;
    }
  }
  // A stiffness proportional to the normal force gains ½ (μ/z_max) z² ΔF_n per cycle. This test
  // must detect the gain.
  Vector2 z = Vector2::Zero();
  Vector2 last = Vector2::Zero();
  const double reach = 0.3;
  const Work work = workAlong(pressAndReturn(reach), 40.0, 40000, proportionalStiffness(z, last));
  const PowerCurve curve;
  const double gained = 0.5 * reach * reach * (curve.force(1.5) - curve.force(0.5));
  EXPECT_NEAR(work.last, -10.0 * gained, 1e-5); // trapezoidal rule with 1000 ticks per cycle
}

TEST(FrictionEnergy, StuckUnderAChangingForceIsLossless)
{
  // As long as the limit is not reached, a constant stiffness stores and returns the same energy.
  Friction friction(frictionOf(FrictionModel::ElastoPlastic, 0.5, 5.0));
  const Work work = workAlong(pressAndReturn(0.2), 40.0, 4000, answerOf(friction));
  EXPECT_NEAR(work.last, 0.0, 1e-14);
  EXPECT_GE(work.least, -1e-15);
}

TEST(FrictionEnergy, ShapeDerivedInAStiffeningBody)
{
  // Out where the response is soft, back where it is stiff, at constant depth and without sliding.
  const Path loop = [](double t) -> PressedContact
  {
    const Vector2 point(0.1 * std::sin(t) * std::cos(t), 0.1 * (1.0 - std::cos(t)));
    return { point, 1.0, 10.0 * (1.0 + 8.0 * point.x()) };
  };
  for (const double turns : { 1.0, -1.0 })
  {
    Friction friction(frictionOf(FrictionModel::ShapeDerived, 0.5, 5.0));
    const double end = turns * 10.0 * 3.14159265358979323846;
    const Work work = workAlong(loop, end, 40000, answerOf(friction));
    EXPECT_GE(work.least, -1e-9);
  }
}
