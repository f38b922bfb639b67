// SPDX-License-Identifier: BSD-3-Clause
// The end of the measured data in a stored curve.
#include "Laws/DataEnd.h"

#include "Paraboloid.h"
#include "Laws/ResponseLaw.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr double Range = 2.0;
// The curve is stored to a tolerance of 1e-3 of the force. This is an error of the depth of 2/3 of
// 1e-3 if the force ends the data, and of twice 1e-3 if the stiffness does.
constexpr double Given = 2.01e-3;

double endOf(const DataEnd& end)
{
  const auto tool = Paraboloid{}.make();
  std::array<float, 8> force{};
  std::array<float, 8> stiffness{};
  ResponseLaw(*tool, Range, 8).sample({ 0.06, 0.45, 0.0, 0.0 }, force.data(), stiffness.data());
  return depthOfDataEnd(ResponseSampling(8, 1.5), Range, force.data(), stiffness.data(), end);
}
} // namespace

TEST(DataEnd, AtTheMeasuredForce)
{
  EXPECT_NEAR(endOf({ Paraboloid{}.force(0.7, 0.06), 1e9 }), 0.7, Given * 0.7);
}

TEST(DataEnd, OrAtTheMeasuredStiffness)
{
  const double stiffness = 1.5 * Paraboloid{}.force(0.7, 0.06) / 0.7;
  EXPECT_NEAR(endOf({ 1e9, stiffness }), 0.7, Given * 0.7);
}

TEST(DataEnd, NowhereIfMoreWasMeasured)
{
  EXPECT_TRUE(std::isinf(endOf({ 1e9, 1e9 })));
}
