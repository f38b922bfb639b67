// SPDX-License-Identifier: BSD-3-Clause
// The stored law of a tool against Hertz's closed form, alone and with a compliance in series.
#include "Laws/ResponseLaw.h"

#include "Mechanics/Layers/LayerContact.h"
#include "Paraboloid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr double Range = 2.0; // mm
constexpr int SampleCount = 8;
constexpr double FloatStep = 1.2e-7; // relative rounding of a float

struct Sampled
{
  ResponseStatus status;
  std::array<float, SampleCount> force;
  std::array<float, SampleCount> stiffness;
};

Sampled sample(const ResponseLaw& law, const ContactSpot& spot)
{
  Sampled curve{};
  curve.status = law.sample(spot, curve.force.data(), curve.stiffness.data());
  return curve;
}

double depthOf(int sample)
{
  return Range * std::pow((sample + 1.0) / SampleCount, 2); // as in the data contract
}
} // namespace

TEST(ResponseLaw, SamplesHertzOnAHalfSpace)
{
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  const Sampled curve = sample(ResponseLaw(*tool, Range, SampleCount), { 0.06, 0.45, 0.0, 0.0 });
  ASSERT_EQ(curve.status, ResponseStatus::Valid);
  for (int i = 0; i < SampleCount; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    const double force = paraboloid.force(depthOf(i), 0.06);
    EXPECT_NEAR(static_cast<double>(curve.force[k]), force, FloatStep * force);
    const double stiffness = 1.5 * force / depthOf(i);
    EXPECT_NEAR(static_cast<double>(curve.stiffness[k]), stiffness, FloatStep * stiffness);
  }
}

TEST(ResponseLaw, InSeriesTheDepthsAdd)
{
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  const double compliance = 3.0; // mm/N
  const Sampled curve =
    sample(ResponseLaw(*tool, Range, SampleCount), { 0.06, 0.45, compliance, 0.0 });
  ASSERT_EQ(curve.status, ResponseStatus::Valid);
  for (int i = 0; i < SampleCount; ++i)
  {
    const auto force = static_cast<double>(curve.force[static_cast<std::size_t>(i)]);
    const double local = depthOf(i) - compliance * force;
    EXPECT_NEAR(
      // factor 1.5 from the power, 2 from storage
      paraboloid.force(local, 0.06), force, 3.0 * FloatStep * force);
  }
}

TEST(ResponseLaw, AFoldIsAStatusAndZeros)
{
  const auto tool = Paraboloid{}.make();
  const Sampled curve = sample(ResponseLaw(*tool, Range, SampleCount), { 0.06, 0.45, -20.0, 0.0 });
  EXPECT_EQ(curve.status, ResponseStatus::Folded);
  EXPECT_EQ(curve.force.back(), 0.0F);
  EXPECT_EQ(curve.stiffness.front(), 0.0F);
}

TEST(ResponseLaw, WhatAFloatDoesNotHoldIsNotFinite)
{
  const auto tool = Paraboloid{}.make();
  const ResponseLaw law(*tool, Range, SampleCount);
  EXPECT_EQ(sample(law, { 1e-39, 0.45, 0.0, 0.0 }).status, ResponseStatus::NotFinite);
  EXPECT_EQ(sample(law, { 1e39, 0.45, 0.0, 0.0 }).status, ResponseStatus::NotFinite);
}

TEST(ResponseLaw, AThickLayerIsAHalfSpaceAndAThinOneIsOutOfReach)
{
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  ResponseLaw law(*tool, Range, SampleCount);
  law.prepareLayers({ LayerBase::Bonded, 0.01, 1e5, { 0.45 } }, false);
  const Sampled thick = sample(law, { 0.06, 0.45, 0.0, 1e5 });
  ASSERT_EQ(thick.status, ResponseStatus::Valid);
  const double force = paraboloid.force(Range, 0.06);
  // The first term of the layer's series is of the order of a/h, which is 3e-5.
  EXPECT_NEAR(static_cast<double>(thick.force.back()), force, 1e-4 * force);
  EXPECT_EQ(sample(law, { 0.06, 0.45, 0.0, 0.01 }).status, ResponseStatus::OutOfReach);
}

/// The relative difference of two forces, each from its own solution of a layer.
TEST(ResponseLaw, AnErrorOfTheThicknessChangesTheForceAsAThinnerLayerDoes)
{
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  ResponseLaw law(*tool, Range, SampleCount);
  law.prepareLayers({ LayerBase::Bonded, 4.0, 20.0, { 0.45 } }, false);
  law.prepareUncertain({ LayerBase::Bonded, 0.01, 20.0, { 0.45 } });
  const auto kernel = LayerKernel::shared(0.45, LayerBase::Bonded);
  const auto forceAt = [&](double thickness, int sample)
  {
    return thickness > 0.0
      ? LayerContact(*tool, kernel, thickness).evaluate(depthOf(sample), 1.0).force
      : paraboloid.force(depthOf(sample), 1.0);
  };
  std::array<double, SampleCount> change{};
  ContactSpot spot{ 0.06, 0.45, 0.0, 8.0 };
  const auto expectChange = [&](double thinner)
  {
    law.thicknessEffect(spot, change.data());
    for (int i = 0; i < SampleCount; ++i)
    {
      const double expected = forceAt(thinner, i) / forceAt(spot.thickness, i) - 1.0;
      EXPECT_GT(expected, 0.0);
      // Both tables agree with LayerContact to 1e-7 of the force.
      EXPECT_NEAR(change[static_cast<std::size_t>(i)], expected, 4e-7);
    }
  };
  spot.thicknessError = 1.0 / 8.0;
  expectChange(4.0);
  spot.thickness = 0.0;
  expectChange(8.0);
  spot.thicknessError = 100.0; // a hundredth of a millimetre: too thin for the range
  law.thicknessEffect(spot, change.data());
  EXPECT_EQ(change.front(), 1.0);
}

TEST(ResponseLaw, ContactRadiusAndTotalDeflection)
{
  const Paraboloid paraboloid;
  const auto tool = paraboloid.make();
  const ResponseLaw law(*tool, Range, SampleCount);
  const ContactSpot soft{ 0.06, 0.45, 3.0, 0.0 };
  const double local = paraboloid.depthAt(1.5);
  const double total = local + 3.0 * paraboloid.force(local, 0.06);
  EXPECT_NEAR(law.deflectionAtContactRadius(soft, 1.5), total, 1e-12);
  EXPECT_NEAR(law.totalDeflection(soft, local), total, 1e-12);
  EXPECT_NEAR(law.evaluate(soft, total).force, paraboloid.force(local, 0.06), 1e-10);
}

TEST(ResponseLaw, APowerOfTheDepthIsStoredToRounding)
{
  const auto tool = Paraboloid{}.make();
  const ResponseLaw law(*tool, Range, SampleCount);
  const ContactSpot spot{ 0.06, 0.45, 0.0, 0.0 };
  EXPECT_LT(law.storageError(1.5, spot), FloatStep); // r(s) is constant
  EXPECT_LT(law.storageError(1.0, spot), FloatStep); // r(s) is proportional to s
  EXPECT_GT(law.storageError(1.2, spot), FloatStep);
}
