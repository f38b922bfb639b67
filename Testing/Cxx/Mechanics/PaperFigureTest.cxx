// SPDX-License-Identifier: BSD-3-Clause
// The curves of Mahvash and Hayward 2002, figure 6: force over depth, and depth over force.
#include "Agreement.h"
#include "ReferenceTable.h"
#include "TestTools.h"

#include <array>
#include <utility>

using palpate::testing::agrees;
using palpate::testing::ReferenceTable;
using palpate::testing::Rubber;
using palpate::testing::tool;

namespace
{
// The tables have 12 digits: a relative rounding of up to 5e-12 in force or depth.
constexpr double Printed = 5e-12;
} // namespace

TEST(PaperFigure, ForceOfDepth)
{
  const std::array<std::pair<const char*, const char*>, 5> columns = { {
    { "F_sphere12.7mm_parab", "paraboloid:6.35" },
    { "F_flat3.2mm", "flat:1.6" },
    { "F_sphere3.2mm_parab", "paraboloid:1.6" },
    { "F_sphere12.7_exact", "sphere:6.35" },
    { "F_sphere3.2_exact", "sphere:1.6" },
  } };
  const ReferenceTable table("paper_fig6_F_of_delta.csv");
  ASSERT_EQ(table.size(), 20u);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double depth = table.number(i, "delta_mm");
    for (const auto& [column, name] : columns)
    {
      SCOPED_TRACE(std::string(name) + " at " + std::to_string(depth));
      EXPECT_TRUE(agrees(tool(name)->force(depth, Rubber), table.number(i, column), Printed));
    }
  }
}

TEST(PaperFigure, DepthOfForce)
{
  const std::array<std::pair<const char*, const char*>, 5> columns = { {
    { "delta_sphere12.7mm_parab", "paraboloid:6.35" },
    { "delta_flat3.2mm", "flat:1.6" },
    { "delta_sphere3.2mm_parab", "paraboloid:1.6" },
    { "delta_sphere12.7_exact", "sphere:6.35" },
    { "delta_sphere3.2_exact", "sphere:1.6" },
  } };
  const ReferenceTable table("paper_fig6_delta_of_F.csv");
  ASSERT_EQ(table.size(), 15u);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double force = table.number(i, "F_N");
    for (const auto& [column, name] : columns)
    {
      SCOPED_TRACE(std::string(name) + " at " + std::to_string(force));
      // F ∝ δ^m with m <= 1.5 multiplies the rounding of the printed depth by m.
      EXPECT_TRUE(agrees(tool(name)->force(table.number(i, column), Rubber), force, 1.5 * Printed));
    }
  }
}

TEST(PaperFigure, ContactRadiusOfForce)
{
  const ReferenceTable table("paper_fig6_delta_of_F.csv");
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const auto radius = [&](const char* name, const char* column)
    { return tool(name)->contactRadius(table.number(i, column)); };
    EXPECT_TRUE(agrees(radius("paraboloid:6.35", "delta_sphere12.7mm_parab"),
      table.number(i, "a_12.7_parab"), Printed));
    EXPECT_TRUE(agrees(radius("paraboloid:1.6", "delta_sphere3.2mm_parab"),
      table.number(i, "a_3.2_parab"), Printed));
    EXPECT_TRUE(agrees(
      radius("sphere:1.6", "delta_sphere3.2_exact"), table.number(i, "a_3.2_exact"), Printed));
  }
}
