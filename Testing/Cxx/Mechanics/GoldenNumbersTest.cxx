// SPDX-License-Identifier: BSD-3-Clause
// The single numbers of golden.csv for tools of the library.
#include "Agreement.h"
#include "ReferenceTable.h"
#include "TestTools.h"

#include <functional>
#include <map>

using palpate::testing::agrees;
using palpate::testing::ReferenceTable;
using palpate::testing::Rubber;
using palpate::testing::tool;

TEST(GoldenNumbers, OfThisLibrarysTools)
{
  const auto force = [](const char* name, double depth)
  { return [=] { return tool(name)->force(depth, Rubber); }; };
  const auto radius = [](const char* name, double depth)
  { return [=] { return tool(name)->contactRadius(depth); }; };
  const std::map<std::string, std::function<double()>> computed = {
    { "flat_F(a=1.6,E*=3.45,d=0.5)", force("flat:1.6", 0.5) },
    { "sphere_F(R=6.35,d=0.5)", force("paraboloid:6.35", 0.5) },
    { "sphere_a(R=6.35,d=0.5)", radius("paraboloid:6.35", 0.5) },
    { "sphere_p0(R=6.35,d=0.5)",
      [] { return tool("paraboloid:6.35")->pressure(0.0, 0.5, Rubber); } },
    { "cone60_F(d=0.5)", force("cone:60", 0.5) },
    { "cone60_a(d=0.5)", radius("cone:60", 0.5) },
    { "sphere_exact_R1.6_F(d=0.2)", force("sphere:1.6", 0.2) },
    { "sphere_exact_R1.6_a(d=0.2)", radius("sphere:1.6", 0.2) },
    { "sphere_exact_R1.6_F(d=1.0)", force("sphere:1.6", 1.0) },
    { "sphere_exact_R1.6_a(d=1.0)", radius("sphere:1.6", 1.0) },
    { "sphere_exact_R6.35_F(d=0.2)", force("sphere:6.35", 0.2) },
    { "sphere_exact_R6.35_a(d=0.2)", radius("sphere:6.35", 0.2) },
    { "sphere_exact_R6.35_F(d=1.0)", force("sphere:6.35", 1.0) },
    { "sphere_exact_R6.35_a(d=1.0)", radius("sphere:6.35", 1.0) },
    { "power_n4_B0.01_F(d=0.2)", force("power:4,0.01", 0.2) },
    { "power_n4_B0.01_a(d=0.2)", radius("power:4,0.01", 0.2) },
    { "power_n4_B0.01_F(d=1.0)", force("power:4,0.01", 1.0) },
    { "power_n4_B0.01_a(d=1.0)", radius("power:4,0.01", 1.0) },
    { "trunc_cone_b1_60_F(d=0.2)", force("truncated:1,60", 0.2) },
    { "trunc_cone_b1_60_a(d=0.2)", radius("truncated:1,60", 0.2) },
    { "trunc_cone_b1_60_F(d=1.0)", force("truncated:1,60", 1.0) },
    { "trunc_cone_b1_60_a(d=1.0)", radius("truncated:1,60", 1.0) },
    { "blunt_cone_sph_R1_60_F(d=0.2)", force("blunted:1,60", 0.2) },
    { "blunt_cone_sph_R1_60_a(d=0.2)", radius("blunted:1,60", 0.2) },
    { "blunt_cone_sph_R1_60_F(d=1.0)", force("blunted:1,60", 1.0) },
    { "blunt_cone_sph_R1_60_a(d=1.0)", radius("blunted:1,60", 1.0) },
    { "rounded_flat_b1.2_Re0.4_F(d=0.2)", force("rounded:1.2,0.4", 0.2) },
    { "rounded_flat_b1.2_Re0.4_a(d=0.2)", radius("rounded:1.2,0.4", 0.2) },
    { "rounded_flat_b1.2_Re0.4_F(d=1.0)", force("rounded:1.2,0.4", 1.0) },
    { "rounded_flat_b1.2_Re0.4_a(d=1.0)", radius("rounded:1.2,0.4", 1.0) },
  };
  const ReferenceTable table("golden.csv");
  std::size_t checked = 0;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const auto found = computed.find(table.text(i, "name"));
    if (found != computed.end())
    {
      SCOPED_TRACE(found->first);
      // Closed forms with 15 printed digits. The root search finds the radii to 2e-12 mm.
      EXPECT_TRUE(agrees(found->second(), table.number(i, "value"), 5e-12));
      ++checked;
    }
  }
  EXPECT_EQ(checked, computed.size());
}

TEST(GoldenNumbers, TheTwoToolsOfThePaperCross)
{
  const ReferenceTable table("golden.csv");
  std::map<std::string, double> golden;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    golden[table.text(i, "name")] = table.number(i, "value");
  }
  const double depth = golden.at("fig6_cross_sphere12.7_vs_flat3.2_delta");
  const double force = golden.at("fig6_cross_force");
  const auto sphere = tool("paraboloid:6.35");
  const auto flat = tool("flat:1.6");
  // The depth has the closed form δ = 9a²/4R. The force has 15 printed digits.
  EXPECT_TRUE(agrees(sphere->force(depth, Rubber), force, 1e-14));
  EXPECT_TRUE(agrees(flat->force(depth, Rubber), force, 1e-14));
  EXPECT_LT(sphere->force(0.999 * depth, Rubber), flat->force(0.999 * depth, Rubber));
  EXPECT_GT(sphere->force(1.001 * depth, Rubber), flat->force(1.001 * depth, Rubber));
}
