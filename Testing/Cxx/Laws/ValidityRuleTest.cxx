// SPDX-License-Identifier: BSD-3-Clause
// The validity of a law and the reason of its limit, by Hertz's contact radius.
#include "Laws/ValidityRule.h"

#include "Paraboloid.h"
#include "Laws/ResponseLaw.h"

#include <gtest/gtest.h>

namespace validity_rule
{
using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr double Range = 5.0; // mm
constexpr double Wide = 1000.0;

class Validity : public ::testing::Test
{
protected:
  ValidityRule::Answer at(
    const ContactSpot& spot, double curvature, double width = Wide, double range = Range) const
  {
    return ValidityRule(*this->Tool, this->Law, range, width).at(spot, curvature);
  }

  Paraboloid Shape;
  std::unique_ptr<AxisymmetricTool> Tool = Shape.make();
  ResponseLaw Law{ *Tool, Range, 8 };
  ContactSpot Flat{ 0.06, 0.45, 0.0, 0.0 };
};
} // namespace

TEST_F(Validity, StrainAtTwoFifthsOfTheRadius)
{
  const auto answer = this->at(this->Flat, 0.0);
  EXPECT_EQ(answer.limit, ResponseLimit::Strain);
  EXPECT_NEAR(answer.depth, this->Shape.depthAt(0.4 * this->Shape.radius), 1e-12);
}

TEST_F(Validity, CurvatureWhereTheNormalTurns)
{
  const auto answer = this->at(this->Flat, 0.2); // the normal turns by 0.2 rad within 1 mm
  EXPECT_EQ(answer.limit, ResponseLimit::Curvature);
  EXPECT_NEAR(answer.depth, this->Shape.depthAt(1.0), 1e-12);
}

TEST_F(Validity, EdgeWhereTheContactIsAsWideAsTheBody)
{
  const auto answer = this->at(this->Flat, 0.0, 2.0);
  EXPECT_EQ(answer.limit, ResponseLimit::Edge);
  EXPECT_NEAR(answer.depth, this->Shape.depthAt(1.0), 1e-12);
}

TEST_F(Validity, ThicknessAtAFifthOfALayer)
{
  this->Law.prepareLayers({ LayerBase::Bonded, 1.0, 1.0, { 0.45 } }, false);
  const auto answer = this->at({ 0.06, 0.45, 0.0, 1.0 }, 0.0);
  EXPECT_EQ(answer.limit, ResponseLimit::Thickness);
  EXPECT_NEAR(answer.depth, 0.2, 1e-12);
}

TEST_F(Validity, ACompliantBodyAddsItsOwnDeflection)
{
  const double local = this->Shape.depthAt(1.0);
  const auto answer = this->at({ 0.06, 0.45, 3.0, 0.0 }, 0.2);
  EXPECT_EQ(answer.limit, ResponseLimit::Curvature);
  EXPECT_NEAR(answer.depth, local + 3.0 * this->Shape.force(local, 0.06), 1e-12);
}

TEST_F(Validity, WithinTheRangeNothingBreaks)
{
  const auto answer = this->at(this->Flat, 0.0, Wide, 0.5);
  EXPECT_EQ(answer.limit, ResponseLimit::None);
  EXPECT_EQ(answer.depth, 0.5);
}
} // namespace validity_rule
