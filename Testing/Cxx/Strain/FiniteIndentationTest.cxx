// SPDX-License-Identifier: BSD-3-Clause
// Indentation at finite strain: against the exact laws at small strain, against tables of another
// code at large strain (Data/Reference/deep), and by general properties.
#include "Strain/FiniteIndentation.h"
#include "Strain/GradedMesh.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/ReducedModulus.h"

#include "Agreement.h"
#include "ReferenceTable.h"
#include "TestTools.h"

#include <algorithm>
#include <cmath>

using palpate::AxisymmetricTool;
using palpate::FiniteCurve;
using palpate::FiniteLayer;
using palpate::FinitePoint;
using palpate::FiniteProblem;
using palpate::StrainModel;
using palpate::ToolOutline;
using palpate::testing::agrees;
using palpate::testing::ReferenceTable;
using palpate::testing::tool;

namespace
{
/// A layer with E* = 1 MPa.
FiniteLayer unitLayer(double nu, StrainModel model = StrainModel::NeoHooke, double parameter = 0.0)
{
  FiniteLayer layer;
  layer.youngsModulus = 1.0 - nu * nu;
  layer.poissonRatio = nu;
  layer.model = model;
  layer.parameter = parameter;
  return layer;
}

FiniteCurve press(const AxisymmetricTool& given, const FiniteLayer& layer,
  const std::vector<double>& depths, double fillet = 0.1, double edge = 0.08)
{
  FiniteProblem problem;
  problem.layers = { layer };
  problem.depths = depths;
  problem.contactRadius = given.contactRadius(depths.back());
  problem.edge = edge;
  const ToolOutline outline(given, 3.0 * problem.contactRadius, fillet);
  return pressTool(outline, problem);
}

/// The force of the table row nearest to the depth, scaled to the depth by F ∝ δ^m. The nearest row
/// differs from the depth by about 0.01 %.
double tabulated(const ReferenceTable& table, const std::string& depthColumn,
  const std::string& forceColumn, double depth, double exponent, double nu, double second,
  const std::string& secondColumn)
{
  double best = HUGE_VAL;
  double force = NAN;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const bool isCase = table.number(row, "nu") == nu &&
      (secondColumn.empty() || table.number(row, secondColumn) == second);
    const double away = isCase ? std::abs(table.number(row, depthColumn) - depth) : HUGE_VAL;
    if (away < best)
    {
      best = away;
      const double at = table.number(row, depthColumn);
      force = table.number(row, forceColumn) * std::pow(depth / at, exponent);
    }
  }
  EXPECT_LT(best, 0.01 * depth);
  return force;
}
} // namespace

TEST(FiniteIndentation, AtSmallStrainItIsTheExactLaw)
{
  const auto sphere = tool("sphere:1");
  for (const double nu : { 0.0, 0.45, 0.495 })
  {
    const FiniteCurve curve =
      press(*sphere, unitLayer(nu, StrainModel::Linear), { 0.03, 0.09 }, 0.1, 0.05);
    ASSERT_EQ(curve.fault, "");
    // The boundary at a thousand contact radii has an error of 1e-3; the mesh adds the same.
    EXPECT_TRUE(agrees(curve.points[1].force, sphere->force(0.09, 1.0), 2e-3)) << nu;
    EXPECT_TRUE(agrees(curve.points[0].force, sphere->force(0.03, 1.0), 4e-3)) << nu;
  }
}

/// c - 1 is proportional to the contact radius: 0.087 a/R at ν = 0.3, computed by another code. In
/// the limit of zero depth the force is that of the exact law, to 0.1 %.
TEST(FiniteIndentation, ItsLimitAtNoDepthIsTheExactLaw)
{
  const auto sphere = tool("sphere:1");
  const auto factor = [&](double depth)
  {
    const FiniteCurve finite = press(*sphere, unitLayer(0.3), { depth }, 0.1, 0.05);
    const FiniteCurve linear =
      press(*sphere, unitLayer(0.3, StrainModel::Linear), { depth }, 0.1, 0.05);
    EXPECT_EQ(finite.fault + linear.fault, "");
    // Linear and finite solutions have the same error of mesh and far field. The linear solution
    // agrees with the exact law to 2e-3 (test above).
    return finite.points.at(0).force / linear.points.at(0).force;
  };
  const double near = factor(0.0025); // a/R = 0.05
  const double twice = factor(0.01);
  EXPECT_NEAR(2.0 * near - twice, 1.0, 1e-3);
  EXPECT_NEAR((twice - 1.0) / 0.1, 0.087, 0.01);
}

TEST(FiniteIndentation, OnALayerToo)
{
  const auto sphere = tool("sphere:1");
  for (const bool slips : { false, true })
  {
    FiniteLayer layer = unitLayer(0.45, StrainModel::Linear);
    layer.thickness = 0.8;
    FiniteProblem problem;
    problem.layers = { layer };
    problem.slipBase = slips;
    problem.depths = { 0.1 };
    const auto kernel = std::make_shared<const palpate::LayerKernel>(
      0.45, slips ? palpate::LayerBase::Slip : palpate::LayerBase::Bonded);
    const palpate::LayerContact exact(*sphere, kernel, layer.thickness);
    problem.contactRadius = exact.contactRadius(0.1);
    const FiniteCurve curve = pressTool(ToolOutline(*sphere, 0.99, 0.1), problem);
    ASSERT_EQ(curve.fault, "");
    EXPECT_TRUE(agrees(curve.points[0].force, exact.evaluate(0.1, 1.0).force, 2e-3));
  }
}

TEST(FiniteIndentation, LayersOfOneMaterialAreOneLayer)
{
  const auto sphere = tool("sphere:1");
  FiniteLayer whole = unitLayer(0.4);
  whole.thickness = 1.0;
  FiniteProblem problem;
  problem.layers = { whole };
  problem.depths = { 0.2 };
  problem.contactRadius = 0.45;
  problem.edge = 0.1;
  const ToolOutline outline(*sphere, 0.99, 0.1);
  const FiniteCurve one = pressTool(outline, problem);
  problem.layers.assign(2, whole);
  problem.layers[0].thickness = 0.4;
  problem.layers[1].thickness = 0.6;
  const FiniteCurve two = pressTool(outline, problem);
  ASSERT_EQ(one.fault + two.fault, "");
  // 5e-4: error of the different meshes
  EXPECT_TRUE(agrees(two.points[0].force, one.points[0].force, 5e-4));
  // A stiffer layer below increases the force.
  problem.layers[1].youngsModulus *= 3.0;
  EXPECT_GT(pressTool(outline, problem).points.at(0).force, 1.1 * one.points[0].force);
}

/// A ball pressed from two sides and a cavity pressed at one side, at small strain, against another
/// code.
TEST(FiniteIndentation, OnABallAndInACavityAsTabulated)
{
  const ReferenceTable table("deep/curvature_sphere_on_ball.csv");
  const auto sphere = tool("sphere:1");
  int rows = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double radius = table.number(row, "Rb_over_R(negative: cavity)");
    const double depth = table.number(row, "delta_over_R");
    if ((radius != 2.0 && radius != -5.0) || table.number(row, "nu") != 0.45 || depth < 0.085)
    {
      continue;
    }
    FiniteProblem problem;
    problem.layers = { unitLayer(0.45, StrainModel::Linear) };
    problem.layers[0].youngsModulus = 1.0;
    problem.bodyRadius = radius;
    problem.depths = { depth };
    problem.contactRadius = sphere->contactRadius(depth);
    problem.edge = 0.08;
    const FiniteCurve curve = pressTool(ToolOutline(*sphere, 0.99, 0.1), problem);
    ASSERT_EQ(curve.fault, "");
    // Two different meshes with an error of 0.2 % each.
    EXPECT_TRUE(agrees(curve.points[0].force, table.number(row, "F_fe_over_E"), 4e-3)) << radius;
    ++rows;
  }
  EXPECT_EQ(rows, 2);
}

TEST(FiniteIndentation, SphereOnAHalfSpaceAsTabulated)
{
  const ReferenceTable table("deep/finite_sphere_halfspace.csv");
  const auto sphere = tool("sphere:1");
  for (const double nu : { 0.3, 0.495 })
  {
    const FiniteCurve curve = press(*sphere, unitLayer(nu), { 0.2, 0.6, 1.0 });
    ASSERT_EQ(curve.fault, "");
    for (const FinitePoint& point : curve.points)
    {
      const double wanted =
        tabulated(table, "delta_over_R", "F_over_EstarR2", point.depth, 1.4, nu, 0.0, "");
      // Two meshes and two penalties have an error of 3e-4 each by refinement. The edges are longer
      // here.
      EXPECT_TRUE(agrees(point.force, wanted, 2e-3)) << nu << " at " << point.depth;
      EXPECT_GT(point.leastVolume, 0.4);
    }
  }
}

TEST(FiniteIndentation, SphereOnALayerAsTabulated)
{
  const ReferenceTable table("deep/finite_layer_sphere.csv");
  const auto sphere = tool("sphere:1");
  FiniteLayer layer = unitLayer(0.45);
  layer.thickness = 1.0;
  const FiniteCurve curve = press(*sphere, layer, { 0.1, 0.3, 0.5 });
  ASSERT_EQ(curve.fault, "");
  for (const FinitePoint& point : curve.points)
  {
    const double wanted =
      tabulated(table, "delta_over_h", "F_over_EstarR2", point.depth, 1.9, 0.45, 1.0, "h_over_R");
    EXPECT_TRUE(agrees(point.force, wanted, 2e-3)) << point.depth;
  }
}

TEST(FiniteIndentation, AFlatGetsSofterThanLinearWhereTheVolumeIsKept)
{
  const ReferenceTable table("deep/finite_flat_cone_halfspace.csv");
  const auto flat = tool("flat:1");
  const FiniteCurve curve = press(*flat, unitLayer(0.45), { 0.25, 0.5 });
  ASSERT_EQ(curve.fault, "");
  const std::string kind = "angle_deg(cone, tip 0.05)|0(flat a=1 fillet 0.1)";
  for (const FinitePoint& point : curve.points)
  {
    const double wanted =
      tabulated(table, "delta", "F_over_Estar", point.depth, 1.0, 0.45, 0.0, kind);
    EXPECT_TRUE(agrees(point.force, wanted, 2e-3)) << point.depth;
  }
}

TEST(FiniteIndentation, AConeIsWrongByTheSameFractionAtEveryDepth)
{
  const ReferenceTable table("deep/cone_selfsimilar.csv");
  const auto cone = tool("cone:75");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    if (table.number(row, "semi_angle_deg") != 75 || table.number(row, "nu") != 0.45)
    {
      continue;
    }
    const FiniteCurve curve = press(*cone, unitLayer(0.45), { 0.3 }, 0.15);
    ASSERT_EQ(curve.fault, "");
    // The missing apex has less effect at larger depths. The values of the table vary by 3e-3.
    EXPECT_NEAR(curve.points[0].force / cone->force(0.3, 1.0),
      table.number(row, "c=F/F_small (any depth)"), 6e-3);
  }
}

TEST(FiniteIndentation, OgdenAndDemirayAsTabulated)
{
  const ReferenceTable table("deep/stiffening_halfspace_sphere.csv");
  const auto sphere = tool("sphere:1");
  const std::vector<double> depths = { 0.25, 0.5 };
  const FiniteCurve neo = press(*sphere, unitLayer(0.495), depths);
  ASSERT_EQ(neo.fault, "");
  const auto ratioOf = [&](const std::string& model, double parameter, double depth)
  {
    double best = HUGE_VAL;
    double ratio = NAN;
    for (std::size_t row = 0; row < table.size(); ++row)
    {
      const bool isCase = table.text(row, "material(nu=0.495, small-strain mu equal)") == model &&
        table.number(row, "parameter") == parameter;
      const double away = isCase ? std::abs(table.number(row, "delta_over_R") - depth) : HUGE_VAL;
      if (away < best)
      {
        best = away;
        ratio = table.number(row, "F_over_F_neohooke");
      }
    }
    EXPECT_LT(best, 1e-3) << model;
    return ratio;
  };
  for (const double alpha : { 9.0, -5.0 })
  {
    const FiniteCurve curve = press(*sphere, unitLayer(0.495, StrainModel::Ogden, alpha), depths);
    ASSERT_EQ(curve.fault, "");
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      EXPECT_TRUE(agrees(
        curve.points[i].force / neo.points[i].force, ratioOf("ogden", alpha, depths[i]), 2e-3))
        << alpha << " at " << depths[i];
    }
  }
  // Ogden's model with α = 2 is the Neo-Hookean model.
  const FiniteCurve two = press(*sphere, unitLayer(0.495, StrainModel::Ogden, 2.0), { 0.25 });
  ASSERT_EQ(two.fault, "");
  const FiniteCurve same = press(*sphere, unitLayer(0.495), { 0.25 });
  EXPECT_TRUE(agrees(two.points[0].force, same.points[0].force, 1e-9));
}

TEST(FiniteIndentation, TheWorkDoneIsStored)
{
  const auto sphere = tool("sphere:1");
  std::vector<double> depths;
  for (int i = 1; i <= 8; ++i)
  {
    depths.push_back(0.4 * i * i / 64.0);
  }
  const FiniteCurve curve = press(*sphere, unitLayer(0.4), depths);
  ASSERT_EQ(curve.fault, "");
  // Simpson's rule over u = √δ. F dδ = 2 F u du is nearly proportional to u⁴: an error of 1e-4 with
  // eight steps.
  const double step = std::sqrt(0.4) / 8.0;
  double work = 0.0;
  for (int i = 1; i <= 8; ++i)
  {
    const double weight = i == 8 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    work +=
      weight * step / 3.0 * 2.0 * curve.points[static_cast<std::size_t>(i - 1)].force * (step * i);
  }
  EXPECT_TRUE(agrees(curve.points.back().energy, work, 2e-3));
}

TEST(FiniteIndentation, NamesWhatMakesNoSense)
{
  FiniteProblem problem;
  EXPECT_EQ(palpate::checkProblem(problem), "The body has no layer");
  problem.layers = { unitLayer(0.45), unitLayer(0.45) };
  EXPECT_NE(palpate::checkProblem(problem).find("Layer 0"), std::string::npos);
  problem.layers = { unitLayer(0.5) };
  EXPECT_NE(palpate::checkProblem(problem).find("Poisson"), std::string::npos);
  problem.layers = { unitLayer(0.45, StrainModel::Ogden, 0.0) };
  EXPECT_NE(palpate::checkProblem(problem).find("Layer 0: Ogden"), std::string::npos);
  problem.layers = { unitLayer(0.45) };
  problem.depths = { 0.2, 0.1 };
  EXPECT_NE(palpate::checkProblem(problem).find("0.1 follows 0.2"), std::string::npos);
  problem.depths = { NAN };
  EXPECT_NE(palpate::checkProblem(problem), "");
  for (const double edge : { 0.0, -1.0, 2.0, static_cast<double>(NAN) })
  {
    problem.edge = edge;
    problem.depths = { 0.1 };
    EXPECT_NE(palpate::checkProblem(problem).find("edge of the elements"), std::string::npos);
  }
  problem.edge = 0.05;
  problem.depths = { NAN };
  const ToolOutline outline(*tool("sphere:1"), 0.9, 0.1);
  EXPECT_TRUE(pressTool(outline, problem).points.empty());
  problem.depths = { 0.1, 0.2 };
  problem.contactRadius = 0.4;
  problem.edge = 0.2;
  int told = 0;
  const FiniteCurve ended = pressTool(outline, problem, [&told](double) { return ++told < 1; });
  EXPECT_EQ(ended.fault, "Aborted");
  EXPECT_EQ(ended.points.size(), 1U);
}

TEST(GradedDivision, IsFineWhereItIsAskedToBe)
{
  const std::vector<double> ends = palpate::gradedDivision(
    1000.0, { { 0.0, 1.0, 0.05 }, { 0.9, 1.1, 0.01 } }, 1.6, { 0.73, 40.0 });
  EXPECT_EQ(ends.front(), 0.0);
  EXPECT_EQ(ends.back(), 1000.0);
  EXPECT_NE(std::find(ends.begin(), ends.end(), 0.73), ends.end());
  EXPECT_NE(std::find(ends.begin(), ends.end(), 40.0), ends.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    const double size = ends[i + 1] - ends[i];
    EXPECT_GT(size, 0.0);
    if (ends[i + 1] <= 1.0)
    {
      EXPECT_LE(size, 0.051);
    }
    if (ends[i] >= 0.9 && ends[i + 1] <= 1.1)
    {
      EXPECT_LE(size, 0.0151); // the last element of a part may be half as long again
    }
  }
  EXPECT_LT(ends.size(), 100U);
}
