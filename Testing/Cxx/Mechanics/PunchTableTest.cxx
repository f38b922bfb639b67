// SPDX-License-Identifier: BSD-3-Clause
// Every row of punches.csv for a tool of the library: eight of the nine shapes, four depths each.
#include "Agreement.h"
#include "Quadrature.h"
#include "ReferenceTable.h"
#include "TestTools.h"

#include <algorithm>
#include <map>
#include <vector>

using palpate::Pi;
using palpate::testing::agrees;
using palpate::testing::ReferenceTable;
using palpate::testing::Rubber;

namespace
{
/// Converts the numbers of "rounded_flat b=1.2 Re=.4" to command-line form: "1.2,.4".
std::string numbersOf(const std::string& text)
{
  std::string numbers;
  std::size_t end = text.find(' ');
  while (true)
  {
    const std::size_t begin = text.find_first_of("0123456789.", end);
    if (begin == std::string::npos)
    {
      return numbers;
    }
    end = std::min(text.find_first_not_of("0123456789.", begin), text.size());
    numbers += (numbers.empty() ? "" : ",") + text.substr(begin, end - begin);
  }
}

/// Converts "cone 60deg" to "cone:60". Returns an empty text for the one shape that the library
/// does not have, a cone blunted by a paraboloid.
std::string commandLineName(const std::string& name)
{
  const std::map<std::string, std::string> shapes = { { "flat", "flat" },
    { "sphere_par", "paraboloid" }, { "sphere_exact", "sphere" }, { "cone", "cone" },
    { "trunc_cone", "truncated" }, { "blunt_cone_sph", "blunted" }, { "rounded_flat", "rounded" },
    { "power", "power" } };
  const auto shape = shapes.find(name.substr(0, name.find(' ')));
  return shape == shapes.end() ? std::string() : shape->second + ":" + numbersOf(name);
}

struct Row
{
  std::unique_ptr<palpate::AxisymmetricTool> tool;
  double depth;
  double a;
  std::size_t index;
};

/// Calls check(row) for every row, and requires that no row is missing.
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
  EXPECT_EQ(checked, 52); // all except the 4 rows of the cone blunted by a paraboloid
}

// The table has 14 digits. Its quadratures agree with closed forms to 3e-11.
constexpr double ClosedFormTolerance = 1e-10;
} // namespace

TEST(PunchTable, ContactRadiusForceAndStiffness)
{
  const ReferenceTable table("punches.csv");
  forEachRow(table,
    [&](const Row& row)
    {
      EXPECT_TRUE(agrees(row.tool->contactRadius(row.depth), row.a, ClosedFormTolerance));
      EXPECT_TRUE(agrees(row.tool->force(row.depth, Rubber),
        table.number(row.index, "F_N(E*=3.45MPa)"), ClosedFormTolerance));
      EXPECT_TRUE(agrees(row.tool->stiffness(row.depth, Rubber),
        table.number(row.index, "dFddelta=2E*a_N/mm"), ClosedFormTolerance));
    });
}

TEST(PunchTable, PressureHalfWayToTheRim)
{
  // For a flat end with an edge the table's quadrature of g' is inaccurate: an error of 5e-3 for
  // the truncated cone at 0.05 mm. The values here are (E*/π) ∫_0^q g'(x)/√(x²-r²) (t/x) dt, x² =
  // b² + t², to 30 digits (mpmath).
  const std::map<std::string, std::vector<double>> behindAnEdge = {
    { "trunc_cone b=1 60deg",
      { 0.06337659244143363, 0.2520995147578876, 0.6207490547514357, 1.352614322238627 } },
    { "rounded_flat b=1.2 Re=.4",
      { 0.05143930894512021, 0.1983881055572553, 0.4746252366776895, 0.9055486545766797 } },
  };
  const std::vector<double> depths = { 0.05, 0.2, 0.5, 1.0 };
  const ReferenceTable table("punches.csv");
  forEachRow(table,
    [&](const Row& row)
    {
      double expected = table.number(row.index, "p(a/2)_MPa");
      const auto exact = behindAnEdge.find(table.text(row.index, "tool"));
      if (exact != behindAnEdge.end())
      {
        const auto depth = std::find(depths.begin(), depths.end(), row.depth);
        ASSERT_NE(depth, depths.end());
        expected = exact->second[static_cast<std::size_t>(depth - depths.begin())];
      }
      EXPECT_TRUE(
        agrees(row.tool->pressure(0.5 * row.a, row.depth, Rubber), expected, ClosedFormTolerance));
    });
}

TEST(PunchTable, NormalDisplacementOutside)
{
  const ReferenceTable table("punches.csv");
  forEachRow(table,
    [&](const Row& row)
    {
      EXPECT_TRUE(agrees(row.tool->surfaceDisplacement(2.0 * row.a, row.depth, 0.3).normal,
        table.number(row.index, "uz(2a)_mm"), ClosedFormTolerance));
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
      EXPECT_TRUE(agrees(radial, table.number(row.index, "ur(a/2)_mm_nu0.3"), ClosedFormTolerance));
      // u_r = -(1-2ν)/(2π(1-ν)E*) F(r)/r, solved for the load F(r) inside r.
      const double load = -radial * 2.0 * Pi * (1.0 - nu) * Rubber * r / (1.0 - 2.0 * nu);
      EXPECT_TRUE(agrees(load, table.number(row.index, "Fin(a/2)_N"), ClosedFormTolerance));
    });
}
