// SPDX-License-Identifier: BSD-3-Clause
// Finite strain on stacked layers, by properties that hold for any solver: equal layers are one
// layer, equal layers on a half-space of the same material are that half-space, and a small depth
// gives the exact law.
#include "Strain/FiniteIndentation.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/ThreadCount.h"

#include "TestTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

using namespace palpate;
using palpate::testing::tool;

namespace
{
constexpr double Ratio = 0.45;
const StrainLaw NeoHooke{ StrainModel::NeoHooke, 0.0 };

/// Disables the cache, so that every tested value is solved.
class StrainStack : public ::testing::Test
{
protected:
  void SetUp() override { setenv("PALPATE_CACHE", "", 1); }
  void TearDown() override { unsetenv("PALPATE_CACHE"); }
};

StrainBodies stackOf(std::vector<StackLayer> layers, LayerBase base = LayerBase::Bonded)
{
  StrainBodies bodies;
  bodies.hasHalfSpace = false;
  bodies.leastRatio = bodies.mostRatio = layers.front().poissonRatio;
  bodies.thinnest = bodies.thickest = layers.front().thickness;
  bodies.base = base;
  bodies.stack.base = base;
  if (layers.size() > 1)
  {
    bodies.second = { layers[1].thickness, layers[1].thickness };
  }
  bodies.stack.layers = std::move(layers);
  return bodies;
}

StrainBodies layerOf(double thickness, double ratio, LayerBase base = LayerBase::Bonded)
{
  return { ratio, ratio, false, thickness, thickness, base };
}

std::unique_ptr<StrainCorrection> correction(const AxisymmetricTool& given, double deepest,
  const StrainBodies& bodies, const StrainLaw& law = NeoHooke)
{
  std::unique_ptr<StrainCorrection> made;
  EXPECT_EQ(makeStrainCorrection(given, law, bodies, deepest, {}, made), "");
  return made;
}
} // namespace

TEST_F(StrainStack, EqualLayersAreOneLayer)
{
  const auto sphere = tool("sphere:2");
  for (const double nu : { 0.3, 0.495 })
  {
    const auto two = correction(*sphere, 0.9, stackOf({ { 0.8, 0.1, nu }, { 1.2, 0.1, nu } }));
    // The table is from another mesh, with a stated error of 0.003; the solution adds the same.
    const auto one = correction(*sphere, 0.9, layerOf(2.0, nu));
    for (const double depth : { 0.1, 0.3, 0.6, 0.9 })
    {
      EXPECT_NEAR(two->at(depth, nu, 0.8, 1.2).factor, one->at(depth, nu, 2.0).factor, 0.006)
        << "nu " << nu << ", depth " << depth;
    }
  }
}

TEST_F(StrainStack, EqualLayersOnASlipperyBaseAreOneLayer)
{
  const auto sphere = tool("sphere:2");
  const auto two = correction(
    *sphere, 0.6, stackOf({ { 0.8, 0.1, Ratio }, { 1.2, 0.1, Ratio } }, LayerBase::Slip));
  const auto one = correction(*sphere, 0.6, layerOf(2.0, Ratio, LayerBase::Slip));
  const auto bonded = correction(*sphere, 0.6, layerOf(2.0, Ratio));
  for (const double depth : { 0.1, 0.3, 0.6 })
  {
    // The meshes differ by one line of nodes.
    EXPECT_NEAR(two->at(depth, Ratio, 0.8, 1.2).factor, one->at(depth, Ratio, 2.0).factor, 1e-3);
  }
  EXPECT_GT(std::abs(one->at(0.6, Ratio, 2.0).factor - bonded->at(0.6, Ratio, 2.0).factor), 0.01);
}

TEST_F(StrainStack, EqualToItsHalfSpaceItIsThat)
{
  const auto sphere = tool("sphere:2");
  for (const double nu : { 0.3, 0.45 })
  {
    StrainBodies bodies = stackOf({ { 1.0, 0.1, nu }, { 2.0, 0.1, nu } });
    bodies.stack.hasHalfSpace = true;
    bodies.stack.halfSpace = { 0.0, 0.1, nu };
    const auto stack = correction(*sphere, 1.5, bodies);
    const auto halfSpace = correction(*sphere, 1.5, { nu, nu, true, 0.0, 0.0, LayerBase::Bonded });
    for (const double depth : { 0.2, 0.7, 1.5 })
    {
      EXPECT_NEAR(
        stack->at(depth, nu, 1.0, 2.0).factor, halfSpace->at(depth, nu, 0.0).factor, 0.006)
        << "nu " << nu << ", depth " << depth;
    }
  }
}

TEST_F(StrainStack, ToSmallDepthsItIsTheExactLaw)
{
  // Skin on fat, soft on stiff, and a film on a soft half-space.
  LayerStack skin;
  skin.layers = { { 1.0, 1.0, 0.45 }, { 5.0, 0.1, 0.45 } };
  LayerStack soft;
  soft.layers = { { 1.0, 0.1, 0.49 }, { 2.0, 0.5, 0.49 } };
  LayerStack film;
  film.layers = { { 1.0, 1.0, 0.45 } };
  film.hasHalfSpace = true;
  film.halfSpace = { 0.0, 0.1, 0.45 };
  const auto sphere = tool("sphere:5");
  for (const LayerStack& stack : { skin, soft, film })
  {
    const StackLayer& top = stack.layers.front();
    const LayerContact contact(*sphere, std::make_shared<const LayerKernel>(stack), 1.0);
    const auto solve = [&](double depth, StrainModel model)
    {
      FiniteProblem problem;
      for (const StackLayer& layer : stack.layers)
      {
        problem.layers.push_back(
          { layer.thickness, layer.youngsModulus, layer.poissonRatio, model });
      }
      if (stack.hasHalfSpace)
      {
        problem.layers.push_back({ INFINITY, 0.1, 0.45, model });
      }
      problem.contactRadius = contact.contactRadius(depth);
      problem.depths = { depth };
      const FiniteCurve found =
        pressTool(ToolOutline(*sphere, 3.0 * problem.contactRadius, 0.01), problem);
      EXPECT_EQ(found.fault, "");
      return found.fault.empty() ? found.points[0].force : static_cast<double>(NAN);
    };
    // A linear model must give the exact law at any depth. The elements grow with the distance from
    // the contact; they resolve a contact that is half as wide as a layer.
    const double exact =
      contact.evaluate(0.1, reducedModulus(top.youngsModulus, top.poissonRatio)).force;
    // The far field of a half-space adds an error of 1e-3.
    EXPECT_NEAR(solve(0.1, StrainModel::Linear) / exact, 1.0, stack.hasHalfSpace ? 2e-3 : 1e-3);
    // Finite strain at a depth of 1e-4 radii: the remaining effect is about 0.05 a/R, and a/R =
    // 0.01.
    EXPECT_NEAR(solve(5e-4, StrainModel::NeoHooke) / solve(5e-4, StrainModel::Linear), 1.0, 1e-3);
  }
}

TEST_F(StrainStack, BitsDoNotDependOnTheNumberOfThreads)
{
  const auto sphere = tool("sphere:2");
  StrainBodies bodies = stackOf({ { 1.0, 0.5, 0.4 }, { 2.0, 0.1, 0.3 } });
  bodies.second = { 2.0, 3.0 };
  std::array<double, 2> factor{};
  for (const std::size_t threads : { 1, 2 })
  {
    const ThreadLimit limit(threads);
    factor[threads - 1] = correction(*sphere, 0.1, bodies)->at(0.07, 0.4, 1.0, 2.6).factor;
  }
  EXPECT_EQ(factor[0], factor[1]);
  EXPECT_NE(factor[0], 1.0);
}

TEST_F(StrainStack, LayersThatSlipAreRefused)
{
  std::unique_ptr<StrainCorrection> made;
  const auto sphere = tool("sphere:2");
  const auto refusal = [&](const StrainBodies& bodies)
  { return makeStrainCorrection(*sphere, NeoHooke, bodies, 0.5, {}, made); };
  EXPECT_NE(refusal(stackOf({ { 1.0, 0.1, 0.4 }, { 1.0, 0.1, 0.4, true } })).find("Layer 1 slips"),
    std::string::npos);
  StrainBodies floating = stackOf({ { 1.0, 0.1, 0.4 } });
  floating.stack.hasHalfSpace = true;
  floating.stack.halfSpace.slips = true;
  EXPECT_NE(refusal(floating).find("slip on their half-space"), std::string::npos);
  EXPECT_EQ(made, nullptr);
}
