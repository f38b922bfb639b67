// SPDX-License-Identifier: BSD-3-Clause
// Local and global deformation in series, against series_model.csv and against a bisection.
#include "Mechanics/SeriesCompliance.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "ReferenceTable.h"
#include "TestTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using palpate::seriesResponse;
using palpate::testing::agrees;
using palpate::testing::ReferenceTable;
using palpate::testing::Rubber;
using palpate::testing::tool;

namespace
{
/// A tool of the table (its spheres are paraboloids) with its size (radius or tan α) scaled.
std::unique_ptr<palpate::AxisymmetricTool> sizedTool(const std::string& name, double scale)
{
  const std::string shape = name.substr(0, name.find_first_of("0123456789"));
  const std::string size = name.substr(shape.size());
  return palpate::scaledTool(*tool((shape == "sphere" ? "paraboloid" : shape) + ":" + size), scale);
}
} // namespace

TEST(SeriesCompliance, Table)
{
  const ReferenceTable table("series_model.csv");
  ASSERT_EQ(table.size(), 40u);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const std::string name = table.text(i, "tool");
    const double compliance = table.number(i, "C_g_mm_per_N");
    const double depth = table.number(i, "delta_mm");
    SCOPED_TRACE(name + ", C = " + std::to_string(compliance));
    const auto point = seriesResponse(*sizedTool(name, 1.0), Rubber, compliance, depth);
    ASSERT_TRUE(point.stable);
    // The reference sheet guarantees F and λ to 1e-9 and the derivatives to 1e-7.
    EXPECT_TRUE(agrees(point.force, table.number(i, "F_N"), 1e-9));
    EXPECT_NEAR(1.0 - point.localDeflection / depth, table.number(i, "lambda"), 1e-9);
    EXPECT_TRUE(agrees(point.stiffness, table.number(i, "dFddelta"), 1e-7));
    const double h = 1e-4;
    const double bigger =
      seriesResponse(*sizedTool(name, std::exp(h)), Rubber, compliance, depth).force;
    const double smaller =
      seriesResponse(*sizedTool(name, std::exp(-h)), Rubber, compliance, depth).force;
    // Central difference: truncation h²/6 = 2e-9, rounding 1e-15/h.
    EXPECT_NEAR(std::log(bigger / smaller) / (2.0 * h), table.number(i, "dlnF_dlnsize"), 1e-7);
  }
}

TEST(SeriesCompliance, NoComplianceIsTheHalfSpace)
{
  for (const char* name : { "flat:1.6", "paraboloid:6.35", "sphere:1.6", "cone:60" })
  {
    const auto t = tool(name);
    for (const double depth : { 1e-9, 0.3, 2.0, 50.0 })
    {
      const auto point = seriesResponse(*t, Rubber, 0.0, depth);
      EXPECT_TRUE(point.stable);
      EXPECT_EQ(point.force, t->force(depth, Rubber));
      EXPECT_EQ(point.stiffness, t->stiffness(depth, Rubber));
      EXPECT_EQ(point.localDeflection, depth);
    }
  }
}

TEST(SeriesCompliance, SolvesItsEquationForAnySoftBody)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-6.0, 1.0);
  for (const char* name : { "flat:1.6", "paraboloid:6.35", "sphere:6.35", "sphere:1.6", "cone:60" })
  {
    const auto t = tool(name);
    for (int i = 0; i < 3000; ++i)
    {
      const double compliance = std::pow(10.0, exponent(random) + 2.0);
      const double depth = std::pow(10.0, exponent(random));
      const auto point = seriesResponse(*t, Rubber, compliance, depth);
      ASSERT_TRUE(point.stable) << name << ", C = " << compliance << ", depth " << depth;
      // δ = δ_local + C F with F = F(δ_local). The rounding of F is 2e-14 for the sphere near a/R =
      // 0.1.
      EXPECT_TRUE(agrees(point.localDeflection + compliance * point.force, depth, 5e-14));
      EXPECT_EQ(point.force, t->force(point.localDeflection, Rubber));
      // Compliances in series add up.
      EXPECT_TRUE(agrees(1.0 / point.stiffness,
        1.0 / t->stiffness(point.localDeflection, Rubber) + compliance, 1e-14));
    }
  }
}

TEST(SeriesCompliance, Edges)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto t = tool("sphere:5");
  for (const double depth : { 0.0, -1.0 })
  {
    const auto point = seriesResponse(*t, Rubber, 0.1, depth);
    EXPECT_TRUE(point.stable);
    EXPECT_EQ(point.force, 0.0);
    EXPECT_EQ(point.stiffness, 0.0);
    EXPECT_EQ(point.localDeflection, 0.0);
  }
  for (const auto& point : { seriesResponse(*t, Rubber, 0.1, nan),
         seriesResponse(*t, Rubber, nan, 1.0), seriesResponse(*t, nan, 0.1, 1.0),
         seriesResponse(*t, Rubber, std::numeric_limits<double>::infinity(), 1.0) })
  {
    EXPECT_FALSE(point.stable);
    EXPECT_TRUE(std::isnan(point.force));
    EXPECT_TRUE(std::isnan(point.stiffness));
  }
}

namespace
{
/// F = k √x: the stiffness falls with the depth, so that Newton steps overshoot.
class SofteningLaw final : public palpate::IndentationLaw
{
public:
  palpate::IndentationPoint evaluate(double deflection, double reducedModulus) const override
  {
    const double root = std::sqrt(std::max(0.0, deflection));
    return { reducedModulus * root, root > 0.0 ? 0.5 * reducedModulus / root : 0.0, 1.0 };
  }
};
} // namespace

TEST(SeriesCompliance, ALawThatSoftensIsSolvedWhereTangentsOvershoot)
{
  // x + c √x = δ is solved for √x without cancellation: √x = 2δ / (c + √(c² + 4δ)).
  for (const double c : { 1e-3, 0.3, 2.0, 50.0, 1e4 })
  {
    for (const double depth : { 1e-6, 0.02, 1.0, 30.0 })
    {
      SCOPED_TRACE(testing::Message() << "c = " << c << ", depth " << depth);
      const auto point = seriesResponse(SofteningLaw(), 1.0, c, depth);
      ASSERT_TRUE(point.stable);
      const double root = 2.0 * depth / (c + std::sqrt(c * c + 4.0 * depth));
      EXPECT_TRUE(agrees(point.force, root, 1e-12)); // rounding; at most a hundred steps
    }
  }
}
