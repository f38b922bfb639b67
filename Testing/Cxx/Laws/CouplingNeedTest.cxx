// SPDX-License-Identifier: BSD-3-Clause
// Distance within which a second tool changes the force: closed forms of a half-space, the law of a
// layer.
#include "Laws/CouplingNeed.h"
#include "Mechanics/Coupling/CouplingLaw.h"
#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/Numerics/Constants.h"

#include "gtest/gtest.h"

#include <cmath>
#include <vector>

namespace
{
using namespace palpate;

constexpr double Modulus = 0.2; // E*, MPa
constexpr double Radius = 2.0;  // radius of the flat end, mm
constexpr double Tolerance = 0.01;
constexpr double InFloats = 1e-6;

/// One point under a flat end on a half-space: F = 2E*a δ.
struct FlatEnd
{
  std::vector<float> force;
  std::vector<float> stiffness;
  std::vector<float> normal{ 0.0F, 0.0F, 1.0F };
  std::vector<float> range{ 1.0F };
  std::vector<std::uint8_t> status{ 0 };
  ResponseArrays arrays;

  explicit FlatEnd(double stiff = 2.0 * Modulus * Radius)
  {
    for (const double depth : { 0.25, 1.0 })
    {
      this->force.push_back(static_cast<float>(stiff * depth));
      this->stiffness.push_back(static_cast<float>(stiff));
    }
    this->arrays.points = 1;
    this->arrays.samples = 2;
    this->arrays.force = this->force.data();
    this->arrays.stiffness = this->stiffness.data();
    this->arrays.normal = this->normal.data();
    this->arrays.range = this->range.data();
    this->arrays.status = this->status.data();
    this->arrays.coupling.modulus = Modulus;
  }
};

TEST(CouplingNeed, OnAHalfSpaceItIsThatOfBoussinesq)
{
  const FlatEnd flat;
  const CouplingNeed need = couplingNeed(flat.arrays, Tolerance);
  EXPECT_TRUE(need.isFelt);
  EXPECT_NEAR(need.apart, 2.0 * Radius, InFloats * Radius);
  EXPECT_NEAR(need.change, 1.0 / Pi, InFloats); // 2E*a/(πE* 2a)
  EXPECT_NEAR(
    need.reach, 2.0 * Radius / (Pi * Tolerance), 0.02 * need.reach); // 2 %: a step of the search
  const std::string words = couplingReason(need, flat.arrays.coupling, Tolerance);
  EXPECT_NE(words.find("127.4 mm change the force by more than 1 %"), std::string::npos) << words;
  EXPECT_NE(words.find("side by side (4 mm) by up to 32 %"), std::string::npos) << words;
}

TEST(CouplingNeed, ATolerantUserNeedsNone)
{
  const FlatEnd flat;
  const CouplingNeed need = couplingNeed(flat.arrays, 0.4);
  EXPECT_FALSE(need.isFelt);
  EXPECT_NE(couplingReason(need, flat.arrays.coupling, 0.4).find("left out"), std::string::npos);
}

TEST(CouplingNeed, ALayerEndsItSooner)
{
  constexpr double thickness = 5.0;
  const CouplingLaw law(LayerKernel(0.45, LayerBase::Bonded));
  FlatEnd flat;
  flat.arrays.coupling.thickness = thickness;
  flat.arrays.coupling.knots = law.knots().data();
  const CouplingNeed need = couplingNeed(flat.arrays, Tolerance);
  EXPECT_LT(need.reach, 20.0 * Radius);
  const auto change = [&](double distance)
  { return 2.0 * Radius * std::abs(law.at(distance / thickness).value) / (Pi * distance); };
  EXPECT_GT(change(need.reach), 0.95 * Tolerance);
  for (double distance = need.reach + 0.2; distance < 100.0; distance += 0.1)
  {
    EXPECT_LE(change(distance), Tolerance) << distance;
  }
}

TEST(CouplingNeed, ABodyThatGivesWayCouplesAtAnyDistance)
{
  FlatEnd flat;
  const std::vector<float> mode{ 0.2F }; // mode² = C = 0.04 mm/N, times 0.8 N/mm: 3.2 %
  flat.arrays.coupling.modes = mode.data();
  flat.arrays.coupling.modeCount = 1;
  const CouplingNeed need = couplingNeed(flat.arrays, Tolerance);
  EXPECT_TRUE(std::isinf(need.reach));
  EXPECT_NEAR(need.change, 1.0 / Pi + 0.032, 1e-5);
  EXPECT_NE(couplingReason(need, flat.arrays.coupling, Tolerance).find("at any distance"),
    std::string::npos);
}

TEST(CouplingNeed, WithoutCouplingThereIsNoSentence)
{
  FlatEnd flat;
  flat.arrays.coupling = {};
  const CouplingNeed need = couplingNeed(flat.arrays, Tolerance);
  EXPECT_FALSE(need.isFelt);
  EXPECT_EQ(couplingReason(need, flat.arrays.coupling, Tolerance), "");
}
} // namespace
