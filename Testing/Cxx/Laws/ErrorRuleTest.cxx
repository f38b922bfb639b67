// SPDX-License-Identifier: BSD-3-Clause
// The estimated error of a law: its parts against their formulas, their sum over the depth, and the
// validity that follows.
#include "Laws/ErrorRule.h"
#include "Laws/BodyMaterial.h"
#include "Laws/LocalContact.h"
#include "Laws/ResponseFiller.h"
#include "Laws/ResponseLaw.h"
#include "Mechanics/FiniteStrain/SmallStrainError.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include "Paraboloid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr double Wide = 1000.0;

class ErrorOfALaw : public ::testing::Test
{
protected:
  LocalState stateAt(double depth) const
  {
    const double a = std::sqrt(this->Shape.radius * depth);
    return { depth, this->Shape.force(depth, 1.0), 2.0 * a, a };
  }
  ErrorParts parts(const SpotCurvature& curvature, const LocalState& state, bool corrected = false,
    double compliance = 0.0, double width = Wide) const
  {
    const ErrorRule rule(*this->Tool, { corrected, nullptr, width, 0.001 });
    return rule.at({ 0.5, 0.45, compliance, 0.0, {} }, { curvature, {} }, state);
  }

  Paraboloid Shape;
  std::unique_ptr<AxisymmetricTool> Tool = Shape.make();
};
} // namespace

/// ΔF/F = -R κ_m/2 for a paraboloid, at every depth; the compliance of the ball adds 0.46 a κ_m.
TEST_F(ErrorOfALaw, CurvatureLeftOut)
{
  for (const double depth : { 0.01, 0.5 })
  {
    const LocalState state = this->stateAt(depth);
    const double part = this->parts({ 0.02, 0.02, 0.0 }, state)[ResponseLimit::Curvature];
    const double sag = 0.5 * 4.0 * 0.02;
    const double whole = 0.46 * state.radius * 0.02;
    EXPECT_NEAR(part, sag + whole + sag * whole, 1e-12); // the two effects multiply
  }
}

TEST_F(ErrorOfALaw, CurvatureInTheLawLeavesTheEllipseTheBallAndItsOwnError)
{
  const LocalState state = this->stateAt(0.25); // contact radius a = 1 mm
  const double part = this->parts({ 0.0, 0.25, 0.01 }, state, true)[ResponseLimit::Curvature];
  const double ratio = std::log(2.0);
  EXPECT_NEAR(part, ratio * ratio / 48.0 + 0.46 * 0.125 + 0.5 * 4.0 * 0.01, 1e-12);
}

TEST_F(ErrorOfALaw, StrainIsThatOfThePressure)
{
  const LocalState state = this->stateAt(0.3);
  const double pressure = state.force / (Pi * state.radius * state.radius);
  EXPECT_DOUBLE_EQ(
    this->parts({}, state)[ResponseLimit::Strain], smallStrainError(pressure, 0.45, 0.0, 0.0));
}

/// The fraction of the local part of the series is 1/(1 + C E* k).
TEST_F(ErrorOfALaw, AnUncertainThicknessIsAPartOfTheLocalForce)
{
  const LocalState state = this->stateAt(0.3);
  const ErrorRule rule(*this->Tool, { false, nullptr, Wide, 0.0 });
  for (const double compliance : { 0.0, 2.0 })
  {
    const ContactSpot spot{ 0.5, 0.45, compliance, 0.0 };
    const auto partOf = [&](double thickness)
    { return rule.at(spot, {}, rule.strain(spot), state, thickness)[ResponseLimit::Thickness]; };
    EXPECT_NEAR(partOf(0.2) - partOf(0.0), 0.2 / (1.0 + compliance * 0.5 * state.stiffness), 1e-15);
  }
}

TEST_F(ErrorOfALaw, InSeriesTheLocalPartCounts)
{
  const LocalState state = this->stateAt(0.3);
  const double alone = this->parts({}, state)[ResponseLimit::Strain];
  const double inSeries = this->parts({}, state, false, 2.0)[ResponseLimit::Strain];
  EXPECT_NEAR(inSeries, alone / (1.0 + 2.0 * 0.5 * state.stiffness), 1e-15);
}

TEST_F(ErrorOfALaw, WiderThanTheBodyAllIsError)
{
  const LocalState state = this->stateAt(1.0); // contact radius a = 2 mm
  EXPECT_EQ(this->parts({}, state, false, 0.0, 4.1)[ResponseLimit::Edge], 0.0);
  EXPECT_EQ(this->parts({}, state, false, 0.0, 3.9)[ResponseLimit::Edge], 1.0);
  EXPECT_EQ(this->parts({}, state, false, 0.0, 3.9).largest(), ResponseLimit::Edge);
}

/// Validity is the depth at which the error exceeds the tolerance. The error is given for each
/// sample.
TEST_F(ErrorOfALaw, OfAWholeResponse)
{
  constexpr int samples = 16;
  std::vector<float> force(samples);
  std::vector<float> stiffness(samples);
  std::vector<float> range(1);
  std::vector<float> validity(1);
  std::vector<float> error(samples);
  std::vector<unsigned char> status(1, 0);
  std::vector<unsigned char> limit(1);
  BodyMaterial material({ 0.06, 0.3, 0.0, LayerBase::Bonded, false });
  ASSERT_EQ(material.take({}, 1), "");
  const SurfaceShape shape{ Wide, [](std::size_t) { return 0.0; },
    [](std::size_t) { return SpotCurvature{}; } };
  response(*this->Tool, material, 2.0, 1, shape, { false, nullptr, 0.05 },
    { samples, force.data(), stiffness.data(), range.data(), validity.data(), status.data(),
      limit.data(), error.data() });
  EXPECT_EQ(limit[0], static_cast<unsigned char>(ResponseLimit::Strain));
  // Hertz: s = 4/(3π) a/R. The law is stored exactly.
  const auto strain = [](double depth)
  { return smallStrainError(4.0 / (3.0 * Pi) * std::sqrt(depth / 4.0), 0.3, 0.0, 0.0); };
  // validity is interpolated linearly between samples
  EXPECT_NEAR(strain(static_cast<double>(validity[0])), 0.05, 5e-4);
  for (int i = 0; i < samples; ++i)
  {
    const double depth = 2.0 * (i + 1) * (i + 1) / (samples * samples);
    EXPECT_NEAR(static_cast<double>(error[static_cast<std::size_t>(i)]), strain(depth), 1e-5);
  }
}
