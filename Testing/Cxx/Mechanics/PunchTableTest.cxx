// SPDX-License-Identifier: BSD-3-Clause
// Every row of punches.csv whose tool the library has.
#include "Agreement.h"
#include "Quadrature.h"
#include "ReferenceTable.h"
#include "TestTools.h"

using palpate::testing::agrees;
using palpate::testing::Pi;
using palpate::testing::ReferenceTable;
using palpate::testing::Rubber;

namespace
{
/// "cone 60deg" → "cone:60"; empty for shapes the library does not have yet.
std::string commandLineName(const std::string& name)
{
  const std::string shape = name.substr(0, name.find(' '));
  const std::string value = name.substr(name.find_first_of("0123456789", name.find(' ')));
  if (shape == "sphere_par")
  {
    return "paraboloid:" + value;
  }
  if (shape == "sphere_exact")
  {
    return "sphere:" + value;
  }
  if (shape == "flat")
  {
    return "flat:" + value;
  }
  return shape == "cone" ? "cone:" + value.substr(0, value.find("deg")) : "";
}

struct Row
{
  std::unique_ptr<palpate::AxisymmetricTool> tool;
  double depth;
  double a;
  std::size_t index;
};

/// Calls check(row) for every row, and demands that all of them were there.
template <class Check>
void forEachRow(const ReferenceTable& table, Check&& check)
{
  int checked = 0;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const std::string name = commandLineName(table.text(i, "tool"));
    if (!name.empty())
    {
      SCOPED_TRACE(table.text(i, "tool") + " at " + table.text(i, "delta_mm"));
      check(Row{
        palpate::testing::tool(name), table.number(i, "delta_mm"), table.number(i, "a_mm"), i });
      ++checked;
    }
  }
  EXPECT_EQ(checked, 28); // flat 4, paraboloids 8, spheres 8, cones 8
}

// The table prints 14 digits; its own quadratures agree with closed forms to 3e-11.
constexpr double Tolerance = 1e-10;
} // namespace

TEST(PunchTable, ContactRadiusForceAndStiffness)
{
  const ReferenceTable table("punches.csv");
  forEachRow(table,
    [&](const Row& row)
    {
      EXPECT_TRUE(agrees(row.tool->contactRadius(row.depth), row.a, Tolerance));
      EXPECT_TRUE(agrees(
        row.tool->force(row.depth, Rubber), table.number(row.index, "F_N(E*=3.45MPa)"), Tolerance));
      EXPECT_TRUE(agrees(row.tool->stiffness(row.depth, Rubber),
        table.number(row.index, "dFddelta=2E*a_N/mm"), Tolerance));
    });
}

TEST(PunchTable, PressureHalfWayToTheRim)
{
  const ReferenceTable table("punches.csv");
  forEachRow(table,
    [&](const Row& row)
    {
      EXPECT_TRUE(agrees(row.tool->pressure(0.5 * row.a, row.depth, Rubber),
        table.number(row.index, "p(a/2)_MPa"), Tolerance));
    });
}

TEST(PunchTable, NormalDisplacementOutside)
{
  const ReferenceTable table("punches.csv");
  forEachRow(table,
    [&](const Row& row)
    {
      EXPECT_TRUE(agrees(row.tool->surfaceDisplacement(2.0 * row.a, row.depth, 0.3).normal,
        table.number(row.index, "uz(2a)_mm"), Tolerance));
    });
}

TEST(PunchTable, RadialDisplacementAndLoadInside)
{
  const ReferenceTable table("punches.csv");
  const double nu = 0.3;
  forEachRow(table,
    [&](const Row& row)
    {
      const double r = 0.5 * row.a;
      const double radial = row.tool->surfaceDisplacement(r, row.depth, nu).radial;
      EXPECT_TRUE(agrees(radial, table.number(row.index, "ur(a/2)_mm_nu0.3"), Tolerance));
      // u_r = -(1-2ν)/(2π(1-ν)E*) F(r)/r, solved for the load inside r.
      const double load = -radial * 2.0 * Pi * (1.0 - nu) * Rubber * r / (1.0 - 2.0 * nu);
      EXPECT_TRUE(agrees(load, table.number(row.index, "Fin(a/2)_N"), Tolerance));
    });
}
