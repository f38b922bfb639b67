// SPDX-License-Identifier: BSD-3-Clause
// The law of a contact near a sharp edge, against Hetényi's quarter space and by general
// properties.
#include "Contact/Edges/EdgeLaw.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include "ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

using namespace palpate;
using palpate::testing::ReferenceTable;

namespace
{
EdgeLaw lawOf(double exponent, double poissonRatio, bool isInCurves = false)
{
  return EdgeLaw({ exponent, 1.0, poissonRatio, 0.0, isInCurves });
}

double distance(double x, double y)
{
  return std::abs(x - y);
}
} // namespace

/// ψ of Hetényi's quarter space at Poisson's ratios between those of the table: 1/ψ = 0.809 - 0.890
/// ν, to 0.15 % from ν = 0.3 on.
TEST(EdgeLaw, PointLoadSoftnessBetweenTheTablesRatios)
{
  for (const double nu : { 0.32, 0.36, 0.4, 0.43, 0.47 })
  {
    EXPECT_NEAR(palpate::pointLoadSoftness(nu) * (0.809 - 0.890 * nu), 1.0, 0.002) << nu;
  }
}

/// The forces of the table were computed independently. W and the side force are computed from the
/// pressure.
TEST(EdgeLaw, ForceAndSideForceAreThoseOfAQuarterSpace)
{
  const ReferenceTable table("edges/edge_law.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double m = table.number(row, "m");
    const double u = table.number(row, "u=d/a0");
    const EdgeLaw::Value law = lawOf(m, table.number(row, "nu")).at(u, 1.0);
    // The digits of the table allow 1e-5. The spline has different nodes.
    EXPECT_NEAR(law.share, table.number(row, "Psi=W/W0"), 2e-3) << row;
    // F = F0 Ψ - W0 Ψ' u a0'/a0 with W0 = F0 δ/(m+1) and a0 ∝ δ^(m-1). The table states errors of
    // 0.5 % for u > 0 and of 1 to 3 % beyond the edge. The side force from the pressure agrees to
    // 0.5 %. The slope at u = 8 is that of the tail and is not compared.
    const double force = law.share - (m - 1.0) / (m + 1.0) * u * law.slope;
    EXPECT_NEAR(force, table.number(row, "Phi=F/F0"), 8e-3) << row;
    if (u < 8.0)
    {
      EXPECT_NEAR(law.slope / (m + 1.0), table.number(row, "chi=F_side*a0/(F0*delta)"),
        u < -0.8 ? 2e-2 : 4e-3)
        << row;
    }
  }
}

TEST(EdgeLaw, NothingIsLeftAtItsEnd)
{
  for (const double m : { 1.0, 1.2, 1.5, 1.7, 2.0 })
  {
    for (const double sharpness : { 0.2, 1.0, 6.0 })
    {
      const EdgeLaw law = lawOf(m, 0.45);
      for (const double beyond : { 0.0, 1e-9, 0.5, 1e9 })
      {
        const EdgeLaw::Value none = law.at(-law.end() - beyond, sharpness);
        EXPECT_EQ(none.share, 0.0);
        EXPECT_EQ(none.slope, 0.0);
      }
      EXPECT_LT(law.at(-law.end() + 1e-4, sharpness).share, 1e-6);
    }
  }
  EXPECT_NEAR(lawOf(1.5, 0.45).end(), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(lawOf(2.0, 0.45).end(), 0.5 * Pi, 1e-12);
}

TEST(EdgeLaw, RisesWithoutAKinkToAllOfIt)
{
  constexpr double h = 1e-5;
  for (const double m : { 1.0, 1.3, 1.5, 1.9, 2.0 })
  {
    for (const double nu : { 0.0, 0.2, 0.3, 0.4, 0.5 })
    {
      for (const double sharpness : { 0.3, 1.0, 3.0 })
      {
        const EdgeLaw law = lawOf(m, nu);
        double last = 0.0;
        for (double u = -law.end() + 2.0 * h; u < 40.0; u += 0.0317)
        {
          const EdgeLaw::Value here = law.at(u, sharpness);
          EXPECT_GE(here.share, last - 1e-12);
          EXPECT_GE(here.slope, -1e-12);
          last = here.share;
          const EdgeLaw::Value before = law.at(u - h, sharpness);
          const EdgeLaw::Value after = law.at(u + h, sharpness);
          // Error of the difference: h² Ψ'''/6, or h Ψ'' if a node is in between.
          EXPECT_NEAR(here.slope, (after.share - before.share) / (2.0 * h), 1e-4);
          // At a kink the slope would change by about its own value.
          EXPECT_LT(distance(after.slope, before.slope), 2e-3);
        }
        EXPECT_GT(law.at(1e6, sharpness).share, 1.0 - 1e-5);
      }
    }
  }
}

TEST(EdgeLaw, FarAwayItIsAPointLoads)
{
  // Far away 1 - Ψ of a flat end is ψ a/(πd). The last value of the table, at u = 8, is 1 % below
  // this.
  for (const double nu : { 0.3, 0.45, 0.5 })
  {
    const double left = 1.0 - lawOf(1.0, nu).at(1000.0, 1.0).share;
    EXPECT_NEAR(left * 1000.0 * Pi / pointLoadSoftness(nu), 1.0, 0.06);
  }
}

TEST(EdgeLaw, OfRatiosAndToolsBetween)
{
  const double left = lawOf(1.5, 0.3).at(0.0, 1.0).share;
  const double middle = lawOf(1.5, 0.38).at(0.0, 1.0).share;
  const double right = lawOf(1.5, 0.45).at(0.0, 1.0).share;
  EXPECT_GT(left, middle);
  EXPECT_GT(middle, right);
  EXPECT_GT(lawOf(1.5, 0.0).at(0.0, 1.0).share, left);
  const EdgeLaw between = lawOf(1.75, 0.45);
  EXPECT_NEAR(between.at(1.0, 1.0).share,
    0.5 * (lawOf(1.5, 0.45).at(1.0, 1.0).share + lawOf(2.0, 0.45).at(1.0, 1.0).share), 1e-3);
  // Beyond the table the values at its end are used.
  EXPECT_EQ(lawOf(4.0, 0.45).at(0.5, 1.0).share, lawOf(2.0, 0.45).at(0.5, 1.0).share);
}

TEST(EdgeLaw, CurvesThatKnowTheEdgeLackOnlyWhatIsBeyond)
{
  const EdgeLaw law = lawOf(1.5, 0.45, true);
  for (const double u : { 0.0, 0.3, 5.0 })
  {
    EXPECT_EQ(law.at(u, 1.0).share, 1.0);
    EXPECT_EQ(law.at(u, 1.0).slope, 0.0);
  }
  EXPECT_NEAR(law.at(-0.5 * law.end(), 1.0).share, 0.5, 1e-12);
  EXPECT_EQ(law.at(-law.end(), 1.0).share, 0.0);
  EXPECT_LT(law.at(-1e-6, 1.0).slope, 1e-5);
}

TEST(EdgeTermsOf, ToolsAreThoseOfTheirContacts)
{
  struct Case
  {
    const char* tool;
    double exponent;
    double radiusAtOne;
  };
  for (const Case& one :
    { Case{ "flat:1.6", 1.0, 1.6 }, Case{ "paraboloid:5", 1.5, std::sqrt(5.0) },
      Case{ "cone:60", 2.0, 2.0 / Pi * std::tan(Pi / 3.0) } })
  {
    std::string fault;
    ToolSpecification specification;
    ASSERT_TRUE(parseTool(one.tool, specification, fault)) << fault;
    const std::unique_ptr<AxisymmetricTool> tool = makeTool(specification);
    for (const double deflection : { 0.1, 2.0 })
    {
      const EdgeTerms terms = edgeTermsOf(*tool, deflection, 0.45);
      EXPECT_NEAR(terms.exponent, one.exponent, 1e-9) << one.tool;
      EXPECT_NEAR(terms.radius, one.radiusAtOne, 1e-9) << one.tool;
      EXPECT_EQ(faultOfEdges(terms), "");
    }
  }
}

TEST(EdgeTermsFault, NamesWhatIsWrong)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto says = [](const EdgeTerms& terms, const char* word)
  { return faultOfEdges(terms).find(word) != std::string::npos; };
  EXPECT_TRUE(says({ nan, 1.0, 0.4, 0.0, false }, "exponent"));
  EXPECT_TRUE(says({ -1.0, 1.0, 0.4, 0.0, false }, "exponent"));
  EXPECT_TRUE(says({ 1.5, 0.0, 0.4, 0.0, false }, "radius"));
  EXPECT_TRUE(says({ 1.5, nan, 0.4, 0.0, false }, "radius"));
  EXPECT_TRUE(says({ 1.5, 1.0, 0.6, 0.0, false }, "Poisson"));
  EXPECT_TRUE(says({ 1.5, 1.0, 0.4, -1.0, false }, "extent"));
}
