// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Relaxation/RelaxationStep.h"

#include "ReferenceTable.h"
#include "SampleSeries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using palpate::PronySeries;
using palpate::testing::ReferenceTable;
using palpate::testing::relaxation;

TEST(PronySeries, RelaxesFromTheInstantaneousToTheSlowModulus)
{
  const PronySeries series = relaxation("0.5 0.3", "0.1 2");
  EXPECT_DOUBLE_EQ(palpate::relaxationAt(series, 0.0), 1.8);
  EXPECT_DOUBLE_EQ(
    palpate::relaxationAt(series, 0.4), 1.0 + 0.5 * std::exp(-4.0) + 0.3 * std::exp(-0.2));
  EXPECT_DOUBLE_EQ(palpate::relaxationAt(series, 1e6), 1.0);
  EXPECT_DOUBLE_EQ(series.total(), 0.8);
}

// M(1; m+1; -x) against its closed forms, (1-e^-x)/x for m = 1 and 2(e^-x - 1 + x)/x² for m = 2,
// and against quadrature over ramps for m = 1.5. The sum changes its formula at x = 50.
TEST(PronySeries, RampsAsLeeAndRadokHaveThem)
{
  for (const double x : { 1e-6, 0.1, 1.0, 7.0, 49.9, 50.1, 300.0, 1e6 })
  {
    const PronySeries series = relaxation("1", "1");
    const double flat = -std::expm1(-x) / x;
    EXPECT_NEAR(palpate::rampFactor(series, 1.0, x), 1.0 + flat, 1e-14);
    if (x > 0.01) // the closed form suffers from cancellation
    {
      EXPECT_NEAR(
        palpate::rampFactor(series, 2.0, x), 1.0 + 2.0 * (std::exp(-x) - 1.0 + x) / (x * x), 1e-12);
    }
    // m ∫ e^(-x(1-v)) v^(m-1) dv with v = w², by Simpson's rule: an error of 1e-12 at x <= 50.
    constexpr int steps = 20000;
    double sum = 0.0;
    for (int i = 0; i <= steps && x < 60.0; ++i)
    {
      const double w = static_cast<double>(i) / steps;
      const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * 3.0 * w * w * std::exp(-x * (1.0 - w * w));
    }
    if (x < 60.0)
    {
      EXPECT_NEAR(palpate::rampFactor(series, 1.5, x), 1.0 + sum / (3.0 * steps), 1e-11) << x;
    }
  }
}

TEST(PronySeries, StiffensASampledLoopAsTheSheetHasIt)
{
  const ReferenceTable table("rate/stability_prony.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const PronySeries series = relaxation(table.text(row, "p"), table.text(row, "tau_s"));
    const double period = table.number(row, "T_s");
    const double passive = 2.0 * table.number(row, "b") / period;
    const double truth = table.number(row, "K_passive_closed");
    EXPECT_NEAR(
      passive / palpate::RelaxationStep(series, period).sampledStiffening(), truth, 1e-12 * truth);
  }
}

TEST(PronySeries, IsReadAndWritten)
{
  PronySeries series;
  EXPECT_EQ(palpate::parsePronySeries("0.5:0.1,0.3:2", series), "");
  ASSERT_EQ(series.count, 2U);
  EXPECT_EQ(series.strength[0], 0.5);
  EXPECT_EQ(series.time[0], 0.1);
  EXPECT_EQ(series.strength[1], 0.3);
  EXPECT_EQ(series.time[1], 2.0);
  EXPECT_EQ(palpate::textOf(series), "0.5:0.1,0.3:2");
  EXPECT_EQ(palpate::parsePronySeries("", series), "");
  EXPECT_EQ(series.count, 0U);
  for (const char* wrong : { "0.5", "0.5:", ":1", "0.5:0.1;0.3:2", "a:1", "1:0", "1:-1", "-1:1",
         "nan:1", "1:inf", "1:1,2:2,3:3,4:4,5:5", "1:1,,2:2" })
  {
    PronySeries kept = relaxation("7", "8");
    EXPECT_NE(palpate::parsePronySeries(wrong, kept), "") << wrong;
    EXPECT_EQ(kept.strength[0], 7.0) << wrong;
  }
}

TEST(PronySeries, FaultsAreNamed)
{
  PronySeries series = relaxation("0.5 0.3", "0.1 2");
  EXPECT_EQ(palpate::faultOfRelaxation(series), "");
  series.strength[1] = -0.1;
  EXPECT_NE(palpate::faultOfRelaxation(series).find("relaxation 2"), std::string::npos);
  EXPECT_NE(palpate::faultOfRelaxation(series).find("-0.1"), std::string::npos);
  series.strength[1] = 0.1;
  series.time[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(palpate::faultOfRelaxation(series).find("relaxation 1"), std::string::npos);
  series.count = 5;
  EXPECT_NE(palpate::faultOfRelaxation(series).find("5"), std::string::npos);
}
