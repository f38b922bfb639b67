// SPDX-License-Identifier: BSD-3-Clause
// Friction does not use the heap: sticking, sliding, turning, deeper, out of range, reversed, NaN.
#include "AllocationCount.h"
#include "Contact/Friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using palpate::Friction;
using palpate::FrictionModel;
using palpate::FrictionSettings;
using palpate::Vector3;
using palpate::testing::allocationCount;

namespace
{
struct Hertz
{
  palpate::ResponseValue evaluate(double depth) const
  {
    return { 10.0 * depth * std::sqrt(depth), 15.0 * std::sqrt(depth), depth > 1.0 };
  }
  double range() const { return 1.0; }
};
} // namespace

TEST(TickAllocation, Friction)
{
  for (const FrictionModel model :
    { FrictionModel::ElastoPlastic, FrictionModel::Dahl, FrictionModel::ShapeDerived })
  {
    FrictionSettings settings;
    settings.model = model;
    settings.coefficient = 0.5;
    int sliding = 0;
    const long before = allocationCount();
    Friction friction(settings);
    for (int i = 0; i < 5000; ++i)
    {
      const double t = 1e-3 * i;
      const double reach = i % 1000 < 500 ? 0.01 : 20.0;
      const Vector3 normal(0.0, std::sin(t), i % 811 == 0 ? -std::cos(t) : std::cos(t));
      const Vector3 point(reach * std::sin(40.0 * t), reach * std::cos(31.0 * t),
        i % 997 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0);
      const double depth = 1.0 + 0.5 * std::sin(7.0 * t);
      const auto result =
        friction.update(point, normal, Hertz().evaluate(depth).force, depth, Hertz());
      sliding += result.sliding ? 1 : 0;
      if (i % 1711 == 0)
      {
        friction.reset();
      }
    }
    EXPECT_EQ(allocationCount() - before, 0);
    EXPECT_GT(sliding, 500); // both sticking and sliding occurred
    EXPECT_LT(sliding, 4500);
  }
}
