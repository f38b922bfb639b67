// SPDX-License-Identifier: BSD-3-Clause
// Stacks of layers: against one layer and a half-space in closed form, and against moments and
// forces of two other codes (Data/Reference/deep/stack_*.csv).
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/Layers/LayerContact.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "ReferenceTable.h"
#include "TestTools.h"

#include <cmath>
#include <map>
#include <sstream>

using palpate::LayerBase;
using palpate::LayerContact;
using palpate::LayerKernel;
using palpate::LayerStack;
using palpate::Pi;
using palpate::StackLayer;
using palpate::testing::agrees;
using palpate::testing::ReferenceTable;
using palpate::testing::tool;

namespace
{
constexpr double Modulus = 0.1; // MPa for the value 1 in the tables

/// Reads a stack from text such as "1 10 0.45 | 5 1 0.45 slip-top": h, E and ν of each layer.
LayerStack stackOf(const std::string& layers, const std::string& base)
{
  LayerStack stack;
  std::istringstream text(layers);
  std::string part;
  while (std::getline(text, part, '|'))
  {
    std::istringstream numbers(part);
    StackLayer layer;
    std::string interface;
    numbers >> layer.thickness >> layer.youngsModulus >> layer.poissonRatio >> interface;
    layer.youngsModulus *= Modulus;
    layer.slips = interface == "slip-top";
    stack.layers.push_back(layer);
  }
  if (base != "rigid") // otherwise "(E, ν)"
  {
    stack.hasHalfSpace = true;
    char sign = 0;
    std::istringstream(base) >> sign >> stack.halfSpace.youngsModulus >> sign >>
      stack.halfSpace.poissonRatio;
    stack.halfSpace.youngsModulus *= Modulus;
  }
  return stack;
}

std::map<std::string, LayerStack> tabulatedStacks()
{
  const ReferenceTable table("deep/stack_definitions.csv");
  std::map<std::string, LayerStack> stacks;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    stacks[table.text(row, "stack")] =
      stackOf(table.text(row, "layers (h E nu [slip interface above])"), table.text(row, "base"));
  }
  return stacks;
}
} // namespace

TEST(LayerStack, EqualLayersAreOneLayerInClosedForm)
{
  for (const double nu : { 0.0, 0.3, 0.45, 0.5 })
  {
    for (const LayerBase base : { LayerBase::Bonded, LayerBase::Slip })
    {
      LayerStack stack;
      stack.base = base;
      stack.layers = { { 1.0, Modulus, nu, false }, { 0.7, Modulus, nu, false },
        { 0.3, Modulus, nu, false } };
      for (const double omega : { 1e-2, 0.1, 0.5, 2.0, 7.0 })
      {
        const double w = 2.0 * omega; // wave number times the total thickness
        const double k = 3.0 - 4.0 * nu;
        const double d = base == LayerBase::Bonded
          ? 2.0 * k * std::cosh(2.0 * w) + 4.0 * w * w + 1.0 + k * k
          : std::sinh(2.0 * w) + 2.0 * w;
        const double normal = base == LayerBase::Bonded
          ? (2.0 * k * std::sinh(2.0 * w) - 4.0 * w) / d
          : (std::cosh(2.0 * w) - 1.0) / d;
        const double radial = base == LayerBase::Bonded
          ? (2.0 * k * (1.0 - 2.0 * nu) * (std::cosh(2.0 * w) - 1.0) - 4.0 * w * w) /
            (2.0 * (1.0 - nu) * d)
          : ((1.0 - 2.0 * nu) * std::sinh(2.0 * w) - 2.0 * w) / (2.0 * (1.0 - nu) * d);
        const double limit = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
        const palpate::StackTransform found = stackTransform(stack, omega);
        // In double precision the closed forms suffer from cancellation at small ω.
        EXPECT_NEAR(found.normal, normal - 1.0, 1e-12) << nu << " at " << omega;
        EXPECT_NEAR(found.radial, radial - limit, 1e-10) << nu << " at " << omega;
      }
    }
  }
}

TEST(LayerStack, OnAHalfSpaceOfItsOwnNothingIsFelt)
{
  LayerStack stack;
  stack.layers = { { 1.0, Modulus, 0.3, false }, { 0.2, Modulus, 0.3, false } };
  stack.hasHalfSpace = true;
  stack.halfSpace = { 1.0, Modulus, 0.3, false };
  for (const double omega : { 1e-5, 1e-3, 0.1, 3.0 })
  {
    EXPECT_NEAR(stackTransform(stack, omega).normal, 0.0, 1e-9) << omega;
    EXPECT_NEAR(stackTransform(stack, omega).radial, 0.0, 1e-9) << omega;
  }
}

TEST(LayerStack, MomentsAsTabulated)
{
  const ReferenceTable table("deep/stack_definitions.csv");
  const auto stacks = tabulatedStacks();
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const std::string& name = table.text(row, "stack");
    // M(0) = ∫ (W-1) dω. The table has ten k per octave: an error of 1e-6.
    EXPECT_TRUE(agrees(LayerKernel(stacks.at(name)).normal(0.0), table.number(row, "M0"), 2e-5))
      << name;
  }
}

TEST(LayerStack, ForcesAsTabulated)
{
  const ReferenceTable table("deep/stack_force_ratio.csv");
  std::map<std::string, std::shared_ptr<const LayerKernel>> kernels;
  for (const auto& [name, stack] : tabulatedStacks())
  {
    kernels[name] = std::make_shared<const LayerKernel>(stack);
  }
  std::size_t compared = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const auto& kernel = kernels.at(table.text(row, "stack"));
    const std::string& kind = table.text(row, "tool");
    const double value = table.number(row, "value");
    const double wanted = table.number(row, "F_over_F_halfspace_of_top_layer");
    constexpr double thickness = 1.0;
    const bool isFlat = kind == "flat";
    const std::string text = isFlat ? "flat:" + std::to_string(value)
      : kind == "cone 60"           ? "cone:60"
                                    : "sphere:" + kind.substr(kind.find('=') + 1);
    const auto given = tool(text);
    const LayerContact contact(*given, kernel, thickness);
    const double depth = isFlat ? 0.1 : value;
    const double ratio = contact.evaluate(depth, 1.0).force / given->force(depth, 1.0);
    EXPECT_TRUE(agrees(ratio, wanted, 3e-5)) << table.text(row, "stack") << " " << text << " "
                                             << table.text(row, "coordinate") << " " << value;
    ++compared;
  }
  EXPECT_EQ(compared, table.size());
}

TEST(LayerStack, TheTableOfAKernelIsItsSolution)
{
  for (const auto& [name, stack] : tabulatedStacks())
  {
    const LayerKernel kernel(stack);
    for (const double ratio : { 0.05, 0.2, 0.9, 3.1, 8.0 })
    {
      const LayerKernel::Solution table = kernel.at(ratio);
      const LayerKernel::Solution direct = kernel.solve(ratio);
      EXPECT_LT((table.flat - direct.flat).abs().maxCoeff(), 1e-8 * direct.flat.abs().maxCoeff())
        << name << " at " << ratio;
    }
  }
}

TEST(LayerStack, NamesWhatMakesNoSense)
{
  LayerStack stack;
  EXPECT_NE(checkStack(stack).find("1 to 4 layers"), std::string::npos);
  stack.layers.assign(2, StackLayer());
  EXPECT_EQ(checkStack(stack), "");
  stack.layers[1].thickness = -2.0;
  EXPECT_NE(checkStack(stack).find("Layer 1: its thickness"), std::string::npos);
  stack.layers[1].thickness = 2.0;
  stack.layers[0].poissonRatio = 0.6;
  EXPECT_NE(checkStack(stack).find("Layer 0: Poisson"), std::string::npos);
  stack.layers[0].poissonRatio = 0.5;
  stack.hasHalfSpace = true;
  stack.halfSpace.youngsModulus = NAN;
  EXPECT_NE(checkStack(stack).find("half-space: Young"), std::string::npos);
}
