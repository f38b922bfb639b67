// SPDX-License-Identifier: BSD-3-Clause
// One factor for all tools preserves the force ratios of the paper's three tools. A cap alone
// changes them.
#include "Haptics/Devices/DeviceFit.h"

#include "Contact/CappedResponse.h"
#include "RelaxingPlate.h"
#include "SampleResponses.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr double Rubber = 3.45; // E*, MPa
constexpr double Depth = 1.0;   // mm

/// A tool of the paper on rubber, with the curve that a body stores, up to 2 mm.
struct PaperTool
{
  explicit PaperTool(const std::string& text)
    : Store(3)
  {
    ToolSpecification specification;
    std::string error;
    EXPECT_TRUE(parseTool(text, specification, error)) << error;
    this->Law = makeTool(specification);
    for (std::size_t i = 0; i < 24; ++i)
    {
      const auto k = static_cast<double>(i % 8 + 1);
      const IndentationPoint point = this->Law->evaluate(2.0 * k * k / 64.0, Rubber);
      this->Store.force[i] = static_cast<float>(point.force);
      this->Store.stiffness[i] = static_cast<float>(point.stiffness);
    }
    this->Field = std::make_unique<ResponseField>(this->Store.arrays());
  }
  BlendedResponse response() const
  {
    return { *this->Field, TriangleCorners{ 0, 1, 2 }, Vector3(0.2, 0.3, 0.5) };
  }

  ResponseStore Store;
  std::unique_ptr<AxisymmetricTool> Law;
  std::unique_ptr<ResponseField> Field;
};

double spread(const std::array<double, 3>& values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return 1.0 - *least / *most;
}

DeviceSpecification device(double force, double stiffness)
{
  DeviceSpecification specification;
  specification.maximumForce = force;
  specification.maximumStiffness = stiffness;
  return specification;
}
} // namespace

TEST(DeviceFit, ThePapersToolsKeepTheirRatios)
{
  // Diameters in the paper: sphere 12.7 mm, flat 3.2 mm, sphere 3.2 mm.
  const std::array<PaperTool, 3> tools{ PaperTool("sphere:6.35"), PaperTool("flat:1.6"),
    PaperTool("sphere:1.6") };
  const double stiffest = 2.0; // N/mm
  DeviceFit fit(device(100.0, 1000.0 * stiffest));
  for (const PaperTool& tool : tools)
  {
    fit.include(*tool.Field, Depth);
  }
  // The large sphere has the largest stiffness at 1 mm, 2 E* a = 16.8 N/mm.
  EXPECT_NEAR(fit.peakForce(), 11.4, 0.05);
  EXPECT_NEAR(fit.peakStiffness(), tools[0].Law->evaluate(Depth, Rubber).stiffness, 2e-3);
  EXPECT_NEAR(fit.factor(), 0.12, 0.005);

  std::array<double, 3> ideal{};
  std::array<double, 3> capped{};
  std::array<double, 3> fitted{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const BlendedResponse response = tools[i].response();
    ideal[i] = response.evaluate(Depth).force;
    capped[i] = CappedResponse(response, stiffest).evaluate(Depth).force;
    // As in the chain, the cap applies after the factor, so it is larger by the inverse of the
    // factor.
    const CappedResponse after(response, stiffest / fit.factor());
    fitted[i] = fit.factor() * after.evaluate(Depth).force;
    EXPECT_LE(fit.factor() * after.evaluate(Depth).stiffness, stiffest * (1.0 + 1e-12));
  }
  // Tolerance: the digits of the reference, plus 0.0005 for the stored samples (4e-4 of the force).
  const std::array<double, 3> ofReference{ 11.4, 11.0, 5.45 };
  const std::array<double, 3> cappedOfReference{ 1.99, 2.00, 1.96 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(ideal[i], ofReference[i], 0.05);
    EXPECT_NEAR(capped[i], cappedOfReference[i], 0.0055);
    // The cap has no effect on forces that the factor has reduced to the limit.
    EXPECT_NEAR(fitted[i], fit.factor() * ideal[i], 1e-9);
  }
  EXPECT_NEAR(spread(capped), 0.02, 0.005);
  EXPECT_NEAR(spread(ideal), 0.52, 0.005);
  EXPECT_NEAR(spread(fitted), 0.52, 0.005);
}

TEST(DeviceFit, ForceOrStiffnessWhicheverIsShorter)
{
  DeviceFit fit(device(3.0, 2000.0));
  EXPECT_EQ(fit.factor(), 1.0); // no responses to fit
  fit.include(2.0, 1.0);
  EXPECT_EQ(fit.factor(), 1.0); // all responses are within the device's limits
  fit.include(12.0, 4.0);
  EXPECT_EQ(fit.factor(), 0.25);
  fit.include(1.0, 20.0);
  EXPECT_EQ(fit.factor(), 0.1);
  // With a scale of 2, the hand perceives twice the stiffness of the body, but the same force.
  DeviceFit large(device(3.0, 2000.0), 2.0);
  large.include(12.0, 20.0);
  EXPECT_EQ(large.factor(), 0.05);
  large.include(std::numeric_limits<double>::quiet_NaN(), 1.0);
  EXPECT_EQ(large.factor(), 0.0);
}

TEST(DeviceFit, TheReasonNamesTheLimitThatIsShorter)
{
  DeviceSpecification device;
  device.maximumForce = 10.0;
  device.maximumStiffness = 1500.0; // N/m
  DeviceFit weak(device);
  EXPECT_EQ(weak.reason(), "");
  weak.include(9.0, 1.0);
  EXPECT_EQ(weak.reason(), "");
  weak.include(52.34, 2.0);
  EXPECT_EQ(weak.reason(), "the device is too weak: 10 N of 52.3 N");
  DeviceFit soft(device);
  soft.include(20.0, 7.912);
  EXPECT_EQ(soft.reason(), "the device is too soft: 1.5 N/mm of 7.91 N/mm");
  // A simulated hand that renders no force has no limits.
  device.maximumForce = std::numeric_limits<double>::infinity();
  device.maximumStiffness = std::numeric_limits<double>::infinity();
  DeviceFit none(device);
  none.include(1e3, 1e3);
  EXPECT_EQ(none.factor(), 1.0);
  EXPECT_EQ(none.reason(), "");
}

TEST(DeviceFit, PeaksOfABodyAreThoseOfItsWorstPoint)
{
  constexpr std::size_t points = 30000; // several ranges of forRanges
  ResponseStore store(points);
  store.randomizeCurves(3);
  store.status[7] = 2; // point 7 has no valid response
  store.force[8 * 7] = 1e6F;
  const ResponseField field(store.arrays());
  DeviceFit fit(device(1.0, 1000.0));
  fit.include(field, 0.9);
  double force = 0.0;
  double stiffness = 0.0;
  for (std::size_t p = 0; p < points; p += 1)
  {
    if (p == 7)
    {
      continue;
    }
    const double range = field.range(static_cast<std::int32_t>(p));
    for (int j = 2; j <= 16; ++j)
    {
      const double depth = std::min(range * j * j / 256.0, 0.9);
      const ResponseValue value = field.evaluate(static_cast<std::int32_t>(p), depth);
      force = std::max(force, value.force);
      stiffness = std::max(stiffness, value.stiffness);
    }
  }
  // The maxima are at the same places, up to rounding.
  EXPECT_NEAR(fit.peakForce(), force, 1e-12 * force);
  EXPECT_NEAR(fit.peakStiffness(), stiffness, 1e-12 * stiffness);
}

TEST(DeviceFit, OfABodyThatRelaxesTheInstantaneousResponseCounts)
{
  RelaxingPlate plate(1.0, relaxation({ { 0.5, 0.1 }, { 1.0, 2.0 } }));
  DeviceFit fit(device(1.0, 1e9));
  fit.include(*plate.body(), 1.0);
  EXPECT_NEAR(fit.peakForce(), 2.5, 1e-6);
  EXPECT_NEAR(fit.peakStiffness(), 2.5, 1e-6);
  EXPECT_NEAR(fit.factor(), 0.4, 1e-6);
  std::vector<float> strength(2 * plate.surface.points.size(), 0.25F);
  strength[7] = 3.0F;
  plate.terms.strength = strength.data();
  DeviceFit strongest(device(1.0, 1e9));
  strongest.include(*plate.body(), 1.0);
  EXPECT_NEAR(strongest.peakForce(), 4.25, 1e-6);
}
