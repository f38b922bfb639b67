// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/StackTable.h"

#include "TestTools.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Layers/LayerTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace palpate
{
namespace
{
using testing::tool;

const std::vector<double> Depths = { 0.05, 0.2, 0.5 };

/// The contact with a kernel made for exactly this stack, as reference for the table.
std::unique_ptr<LayerContact> direct(
  const AxisymmetricTool& shape, LayerStack stack, double first, double second)
{
  stack.layers[0].thickness = first;
  stack.layers[1].thickness = second;
  return std::make_unique<LayerContact>(shape, std::make_shared<const LayerKernel>(stack), first);
}

double worstOf(
  const char* shape, const LayerStack& stack, ThicknessSpan first, ThicknessSpan second)
{
  const auto pressed = tool(shape);
  const StackTable table(
    *pressed, std::make_shared<const StackKernels>(stack, first, second), Depths);
  std::mt19937 random(7);
  const auto between = [&random](const ThicknessSpan& span)
  {
    const double t = std::uniform_real_distribution<>()(random);
    return span.thinnest * std::pow(span.thickest / span.thinnest, t);
  };
  double worst = 0.0;
  for (int trial = 0; trial < 8; ++trial)
  {
    const double h1 = between(first);
    const double h2 = between(second);
    const auto curve = table.sample({ h1, h2, 0.0 });
    const auto exact = direct(*pressed, stack, h1, h2);
    for (std::size_t i = 0; i < Depths.size(); ++i)
    {
      const IndentationPoint at = exact->evaluate(Depths[i], 1.0);
      const auto row = static_cast<Eigen::Index>(i);
      worst = std::max({ worst, std::abs(curve(row, 0) / at.force - 1.0),
        std::abs(curve(row, 1) / at.stiffness - 1.0) });
    }
  }
  return worst;
}

LayerStack skinOverFat(double ratio, double nu)
{
  LayerStack stack;
  stack.layers = { { 1.0, 0.1 * ratio, nu }, { 4.0, 0.1, 0.45 } };
  return stack;
}
} // namespace

// An error below 1e-3 is required for maps of thickness.
TEST(StackTable, AgreesWithKernelsOfTheirOwn)
{
  EXPECT_LT(worstOf("sphere:3", skinOverFat(5.0, 0.45), { 0.3, 3.0 }, { 1.5, 15.0 }), 1e-3);
  EXPECT_LT(worstOf("flat:2", skinOverFat(0.1, 0.3), { 0.5, 5.0 }, { 0.5, 5.0 }), 1e-3);
}

TEST(StackTable, IsDirectWhereNothingVaries)
{
  // One node: no interpolation, only the rounding of ln and exp.
  EXPECT_LT(worstOf("sphere:3", skinOverFat(10.0, 0.48), { 1.0, 1.0 }, { 4.0, 4.0 }), 1e-12);
}

TEST(StackTable, OfEqualLayersIsOneLayer)
{
  const auto pressed = tool("sphere:3");
  const StackTable table(*pressed,
    std::make_shared<const StackKernels>(
      skinOverFat(1.0, 0.45), ThicknessSpan{ 1.0, 2.0 }, ThicknessSpan{ 3.0, 4.0 }),
    Depths);
  const LayerContact one(
    *pressed, std::make_shared<const LayerKernel>(0.45, LayerBase::Bonded), 5.0);
  const auto curve = table.sample({ 1.4, 3.6, 0.0 });
  for (std::size_t i = 0; i < Depths.size(); ++i)
  {
    // Error of the table's interpolation over thickness ratios of 2 and 1.33.
    EXPECT_NEAR(
      curve(static_cast<Eigen::Index>(i), 0) / one.evaluate(Depths[i], 1.0).force, 1.0, 1e-5);
  }
}

TEST(StackTable, DoesNotAnswerWhereTheFirstLayerIsTooThin)
{
  const auto pressed = tool("flat:3");
  const StackTable table(*pressed,
    std::make_shared<const StackKernels>(
      skinOverFat(2.0, 0.45), ThicknessSpan{ 0.1, 1.0 }, ThicknessSpan{ 4.0, 4.0 }),
    Depths);
  EXPECT_FALSE(table.answers({ 0.2, 4.0, 0.0 })); // a = 15 h
  EXPECT_TRUE(std::isnan(table.sample({ 0.2, 4.0, 0.0 })(0, 0)));
  ASSERT_TRUE(table.answers({ 0.34, 4.0, 0.0 })); // a = 8.8 h
  const auto exact = direct(*pressed, skinOverFat(2.0, 0.45), 0.34, 4.0);
  EXPECT_NEAR(
    table.sample({ 0.34, 4.0, 0.0 })(2, 0) / exact->evaluate(Depths[2], 1.0).force, 1.0, 1e-3);
}
} // namespace palpate
