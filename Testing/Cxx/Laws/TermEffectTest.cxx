// SPDX-License-Identifier: BSD-3-Clause
// Change of the force by a term of a law, against closed forms.
#include "Laws/TermEffect.h"
#include "Laws/BodyMaterial.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include "Paraboloid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
BodyMaterial material(const BodyMaterial::Constants& constants)
{
  BodyMaterial made(constants);
  EXPECT_EQ(made.take({}, 100), "");
  return made;
}
BodyMaterial halfSpace(double poissonRatio = 0.45)
{
  return material({ 0.1, poissonRatio, 0.0, LayerBase::Bonded, false });
}

/// A shape whose curvature is twice the given one at every tenth point.
SurfaceShape dented(double curvature)
{
  return { 1e3, [](std::size_t) { return 0.0; },
    [curvature](std::size_t i)
    {
      const double own = i % 10 == 0 ? 2.0 * curvature : curvature;
      return SpotCurvature{ own, own, 0.0 };
    } };
}
} // namespace

/// Hertz on a ball: F ∝ 1/√(1/R + κ), so the law of a flat body has an error of √(1 + R κ) - 1 at
/// every depth.
TEST(TermEffect, OfCurvature)
{
  const Paraboloid shape;
  const auto tool = shape.make();
  const BodyMaterial body = halfSpace();
  const SurfaceShape surface = dented(0.02);
  const auto change = [&](double share)
  {
    return changeOfForce(
      { *tool, 1.0, 100, surface, share }, { body, true, nullptr }, { body, false, nullptr });
  };
  // 1e-5: error of a law stored at nodes.
  EXPECT_NEAR(change(0.9), std::sqrt(1.0 + shape.radius * 0.02) - 1.0, 1e-5);
  EXPECT_NEAR(change(0.95), std::sqrt(1.0 + shape.radius * 0.04) - 1.0, 1e-5);
}

/// One layer, split into two halves of the same material, is the same layer.
TEST(TermEffect, OfALayerInTwo)
{
  const auto tool = makeTool({ ToolShape::Sphere, 4.0 });
  BodyMaterial::Constants two{ 0.1, 0.45, 2.0, LayerBase::Bonded, false };
  two.deeper = { { 3.0, 0.1, 0.45 } };
  const BodyMaterial stack = material(two);
  const BodyMaterial one = material({ 0.1, 0.45, 5.0, LayerBase::Bonded, false });
  const SurfaceShape flat = dented(0.0);
  const PressedBody body{ *tool, 0.5, 100, flat };
  // 1e-5: error of the stack's kernels, which are interpolated between nodes.
  EXPECT_LT(changeOfForce(body, { stack }, { one }), 1e-5);
  // Without the base the body is much softer (Data/Reference: χ = a/h = 0.28, ν = 0.45).
  EXPECT_GT(changeOfForce(body, { stack }, { halfSpace() }), 0.1);
}

/// The factor c of a sphere at δ = R/2 is 1.070 at ν = 0.3 and 0.988 at ν = 0.45 (computed by
/// another code: Data/Reference/deep).
TEST(TermEffect, OfFiniteStrain)
{
  const auto tool = makeTool({ ToolShape::Sphere, 4.0 });
  const SurfaceShape flat = dented(0.0);
  const PressedBody body{ *tool, 2.0, 100, flat };
  for (const auto& [ratio, c] : { std::pair(0.3, 1.070), std::pair(0.45, 0.988) })
  {
    const BodyMaterial soft = halfSpace(ratio);
    std::unique_ptr<StrainCorrection> strain;
    ASSERT_EQ(makeStrainCorrection(*tool, { StrainModel::NeoHooke, 0.0 },
                { ratio, ratio, true, 0.0, 0.0, LayerBase::Bonded }, 2.0, {}, strain),
      "");
    const double change = changeOfForce(body, { soft, false, strain.get() }, { soft });
    EXPECT_NEAR(change, std::abs(1.0 / c - 1.0), 0.003); // the two tables differ by 0.2 % of F
    EXPECT_GE(boundOfStrain(body, { soft }), change);
  }
}

TEST(TermEffect, WhereNothingIsLookedAt)
{
  const auto tool = makeTool({ ToolShape::Sphere, 4.0 });
  const BodyMaterial body = halfSpace();
  const SurfaceShape none{ 1e3, [](std::size_t) { return -1.0; },
    [](std::size_t) { return SpotCurvature{}; } };
  EXPECT_EQ(changeOfForce({ *tool, 1.0, 5, none }, { body, true, nullptr }, { body }), 0.0);
  EXPECT_EQ(changeOfForce({ *tool, 1.0, 0, none }, { body, true, nullptr }, { body }), 0.0);
}
