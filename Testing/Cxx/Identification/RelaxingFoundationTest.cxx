// SPDX-License-Identifier: BSD-3-Clause
// Forces of a relaxing body over a history, against Ting's integrals and tables made from them.
#include "Identification/RelaxationFit.h"

#include "Mechanics/Numerics/Constants.h"

#include "ClosedRelaxation.h"
#include "ReferenceTable.h"
#include "SampleSeries.h"
#include "TestTools.h"

#include <gtest/gtest.h>

#include <map>

using palpate::PressHistory;
using palpate::PronySeries;
using namespace palpate::testing;

namespace
{
/// A tool, and the modulus (E*, MPa) for which f = δ^m.
struct Unit
{
  const char* tool;
  double modulus;
};
const std::map<double, Unit> Units = { { 1.0, { "flat:1", 0.5 } },
  { 1.5, { "paraboloid:1", 0.75 } }, { 2.0, { "cone:45", 0.5 * palpate::Pi } } };

std::vector<double> forces(double m, const PressHistory& history, const PronySeries& series)
{
  const Unit& unit = Units.at(m);
  const auto tip = tool(unit.tool);
  EXPECT_NEAR(tip->force(0.7, unit.modulus), std::pow(0.7, m), 1e-12);
  PressHistory pressed = history;
  pressed.tool = tip.get();
  return palpate::forcesOver(
    pressed, { palpate::BodyModel::HalfSpace, unit.modulus, 0.0, 0.0 }, series, nullptr, 0.0);
}
} // namespace

TEST(RelaxingFoundation, MeetsTheStopAndGoOfTing)
{
  const ReferenceTable table("rate/oracle_stop_and_go.csv");
  const std::string depth =
    "delta(knots t=0,.05,.2,.25,.4,.42,.55,.6,.7,.75,.9,1 d=0,.5,.5,1,1,.6,.6,.9,.9,.3,.3,0)";
  const std::map<double, std::string> columns = { { 1.0, "F_flat(m=1)" },
    { 1.5, "F_paraboloid(m=1.5)" }, { 2.0, "F_cone(m=2); p=.5,.8,1.2 tau=.02,.2,2" } };
  const PronySeries series = relaxation({ { 0.5, 0.02 }, { 0.8, 0.2 }, { 1.2, 2.0 } });
  PressHistory history;
  for (int i = 0; i <= 1050; ++i)
  {
    const double knots[] = { 0, .05, .2, .25, .4, .42, .55, .6, .7, .75, .9, 1, 1.1 };
    const double depths[] = { 0, .5, .5, 1, 1, .6, .6, .9, .9, .3, .3, 0, 0 };
    const double t = 1e-3 * i;
    std::size_t k = 0;
    while (k + 2 < std::size(knots) && t > knots[k + 1])
    {
      ++k;
    }
    history.time.push_back(t);
    history.deflection.push_back(
      depths[k] + (depths[k + 1] - depths[k]) * (t - knots[k]) / (knots[k + 1] - knots[k]));
  }
  for (const auto& [m, column] : columns)
  {
    const std::vector<double> found = forces(m, history, series);
    double largest = 0.0;
    double worst = 0.0;
    for (std::size_t row = 0; row < table.size(); ++row)
    {
      const auto i = static_cast<std::size_t>(std::lround(1e3 * table.number(row, "t_s")));
      ASSERT_NEAR(history.deflection[i], table.number(row, depth), 1e-9);
      largest = std::max(largest, table.number(row, column));
      worst = std::max(worst, std::abs(found[i] - table.number(row, column)));
    }
    std::printf("  m = %g: %.1e of the largest force\n", m, worst / largest);
    // The error of n elements is of second order: 0.26 % for a cone with 16 elements, 7e-5 with 99.
    // Steps of 1 ms during lift-off add the same.
    EXPECT_LT(worst, 1.5e-4 * largest);
  }
}

TEST(RelaxingFoundation, MeetsTingInTables)
{
  const ReferenceTable table("rate/ting_golden.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const auto at = [&](const char* name) { return table.number(row, name); };
    const PronySeries series = relaxation(table.text(row, "p"), table.text(row, "tau_s"));
    const double up = at("t_up_end");
    const double hold = at("t_hold_end");
    PressHistory history;
    const int steps = 2000;
    for (int i = 0; i <= steps; ++i)
    {
      const double t = at("t_s") * i / steps;
      history.time.push_back(t);
      history.deflection.push_back(
        at("v_up") * std::min(t, up) - at("v_down") * std::max(0.0, t - hold));
    }
    ASSERT_NEAR(history.deflection.back(), at("delta"), 1e-9);
    const double m = at("m(f=delta^m)");
    const double found = forces(m, history, series).back();
    // Same error as for the stop-and-go history, relative to the largest force, which is at least
    // that of the slow curve.
    EXPECT_NEAR(found, at("F"), 1.5e-4 * std::pow(at("v_up") * up, m)) << row;
  }
}

/// The closed forms of the other tests agree with the same table.
TEST(RelaxingFoundation, ClosedFormsOfTheTestsMeetTheTable)
{
  const ReferenceTable table("rate/ting_golden.csv");
  int triangles = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const auto at = [&](const char* name) { return table.number(row, name); };
    const double m = at("m(f=delta^m)");
    const double depth = at("v_up") * at("t_up_end");
    const RampAndHold held{ relaxation(table.text(row, "p"), table.text(row, "tau_s")), m, 1.0,
      depth, at("t_up_end") };
    if (at("t_s") <= at("t_hold_end"))
    {
      EXPECT_NEAR(held.forceAt(at("t_s")), at("F"), 1e-8) << row; // error of Simpson's rule
    }
    if (at("t_hold_end") == at("t_up_end"))
    {
      ++triangles;
      const Triangle triangle{ at("p"), at("tau_s"), m, 1.0, depth, at("t_up_end") };
      EXPECT_NEAR(triangle.forceAt(at("t_s")), at("F"), 1e-8) << row;
    }
  }
  EXPECT_GT(triangles, 10);
}
