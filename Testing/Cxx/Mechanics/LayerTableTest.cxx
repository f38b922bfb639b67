// SPDX-License-Identifier: BSD-3-Clause
// The layer on a rigid base, against the reference tables (Nyström solutions of another code,
// printed with 12 digits). The spheres of the tables are paraboloids.
#include "Mechanics/Layers/LayerContact.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "ReferenceTable.h"
#include "TestTools.h"

using palpate::LayerBase;
using palpate::LayerContact;
using palpate::LayerKernel;
using palpate::testing::agrees;
using palpate::testing::ReferenceTable;
using palpate::testing::tool;

namespace
{
// Required accuracy; the printed digits would allow 1e-11.
constexpr double Tolerance = 1e-7;

const std::vector<std::string> FlatRatios = { "0.01", "0.02", "0.05", "0.1", "0.15", "0.2", "0.3",
  "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.0", "1.25", "1.5", "1.75", "2.0", "2.5", "3.0",
  "4.0", "5.0" };
const std::vector<std::string> DepthRatios = { "0.01", "0.02", "0.05", "0.1", "0.15", "0.2", "0.25",
  "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.0", "1.2", "1.5", "2.0", "2.5", "3.0" };

/// Force on the layer / force on the half-space.
double forceRatio(const std::string& name, std::shared_ptr<const LayerKernel> kernel,
  double thickness, double depth)
{
  const auto pressed = tool(name);
  const LayerContact layer(*pressed, std::move(kernel), thickness);
  return layer.evaluate(depth, 1.0).force / pressed->force(depth, 1.0);
}

/// Calls check(row, ν, kernel) for each row of a table of a bonded layer.
template <class Check>
void forEachRatio(const ReferenceTable& table, const std::string& head, Check&& check)
{
  ASSERT_EQ(table.size(), 11u);
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double nu = table.number(row, head);
    SCOPED_TRACE("nu = " + std::to_string(nu));
    check(row, std::make_shared<const LayerKernel>(nu, LayerBase::Bonded));
  }
}
} // namespace

TEST(LayerTable, BondedFlat)
{
  const ReferenceTable table("layer_bonded_flat_kappa.csv");
  forEachRatio(table, "nu\\a_over_h",
    [&](std::size_t row, const std::shared_ptr<const LayerKernel>& kernel)
    {
      for (const std::string& ratio : FlatRatios)
      {
        // The ratio must not depend on h = 2 mm and δ = 0.3 mm.
        const double a = 2.0 * std::stod(ratio);
        const auto flat = tool("flat:" + std::to_string(a));
        const LayerContact layer(*flat, kernel, 2.0);
        const auto point = layer.evaluate(0.3, 5.0);
        const double kappa = table.number(row, ratio);
        EXPECT_TRUE(agrees(point.stiffness, 2.0 * 5.0 * a * kappa, Tolerance)) << ratio;
        // the force is linear in δ
        EXPECT_TRUE(agrees(point.force, 0.3 * point.stiffness, 1e-14)) << ratio;
        EXPECT_EQ(point.contactRadius, a);
      }
    });
}

TEST(LayerTable, BondedSphere)
{
  const ReferenceTable table("layer_bonded_sphere_ratio.csv");
  forEachRatio(table, "nu\\chi=sqrt(R*delta)/h",
    [&](std::size_t row, const std::shared_ptr<const LayerKernel>& kernel)
    {
      for (const std::string& ratio : DepthRatios)
      {
        const double chi = std::stod(ratio);
        const double depth = chi * chi * 9.0 / 4.0; // R = 4 mm, h = 3 mm
        EXPECT_TRUE(agrees(
          forceRatio("paraboloid:4", kernel, 3.0, depth), table.number(row, ratio), Tolerance))
          << ratio;
      }
    });
}

TEST(LayerTable, BondedCone)
{
  const ReferenceTable table("layer_bonded_cone_ratio.csv");
  const double tangent = std::tan(palpate::Pi / 3.0);
  forEachRatio(table, "nu\\eta=delta*tan(alpha)/h",
    [&](std::size_t row, const std::shared_ptr<const LayerKernel>& kernel)
    {
      for (const std::string& ratio : DepthRatios)
      {
        const double depth = std::stod(ratio) * 3.0 / tangent;
        EXPECT_TRUE(
          agrees(forceRatio("cone:60", kernel, 3.0, depth), table.number(row, ratio), Tolerance))
          << ratio;
      }
    });
}

TEST(LayerTable, SlipFlat)
{
  const ReferenceTable table("layer_slip_flat_kappa.csv");
  for (const double nu : { 0.0, 0.3, 0.5 }) // the ratio does not depend on ν on a slip base
  {
    const auto kernel = std::make_shared<const LayerKernel>(nu, LayerBase::Slip);
    for (const std::string& ratio : FlatRatios)
    {
      EXPECT_TRUE(
        agrees(forceRatio("flat:" + ratio, kernel, 1.0, 0.1), table.number(0, ratio), Tolerance))
        << ratio;
    }
  }
}

TEST(LayerTable, SlipSphereAndCone)
{
  const ReferenceTable table("layer_slip_sphere_cone_ratio.csv");
  const auto kernel = std::make_shared<const LayerKernel>(0.45, LayerBase::Slip);
  ASSERT_EQ(table.size(), 20u);
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double ratio = table.number(row, "chi_or_eta");
    EXPECT_TRUE(agrees(forceRatio("paraboloid:2", kernel, 1.0, 0.5 * ratio * ratio),
      table.number(row, "sphere"), Tolerance));
    EXPECT_TRUE(
      agrees(forceRatio("cone:45", kernel, 1.0, ratio), table.number(row, "cone"), Tolerance));
  }
}

TEST(LayerTable, LiverSlab)
{
  const ReferenceTable table("liver_slab_h10.csv");
  ASSERT_EQ(table.size(), 36u);
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const auto kernel =
      std::make_shared<const LayerKernel>(table.number(row, "nu"), LayerBase::Bonded);
    const auto sphere = tool("paraboloid:" + table.text(row, "R_mm"));
    const LayerContact layer(*sphere, kernel, 10.0);
    const double depth = table.number(row, "delta_mm");
    const auto point = layer.evaluate(depth, 1.0);
    EXPECT_TRUE(agrees(point.contactRadius, table.number(row, "a_mm"), Tolerance));
    EXPECT_TRUE(
      agrees(point.force / sphere->force(depth, 1.0), table.number(row, "F/F_Hertz"), Tolerance));
  }
}
