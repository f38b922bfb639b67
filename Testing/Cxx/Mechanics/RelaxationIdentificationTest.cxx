// SPDX-License-Identifier: BSD-3-Clause
// Relaxation found again from loops and holds: from the tables of the reference sheet, and from the
// closed forms of Lee, Radok and Ting.
#include "Mechanics/Identification/MeasuredSite.h"

#include "Agreement.h"
#include "ClosedRelaxation.h"
#include "ReferenceTable.h"
#include "SyntheticCurves.h"
#include "TestTools.h"

#include <gtest/gtest.h>

#include <fstream>

using palpate::BodyIdentification;
using palpate::BodyModel;
using palpate::IdentificationOptions;
using palpate::IdentifiedBody;
using palpate::MeasuredCurve;
using palpate::MeasuredSite;
using palpate::PronySeries;
using namespace palpate::testing;

namespace
{
constexpr double R = 6.35;

PronySeries series(std::initializer_list<std::pair<double, double>> branches)
{
  PronySeries made;
  for (const auto& [p, tau] : branches)
  {
    made.add(p, tau);
  }
  return made;
}
const PronySeries SheetSeries = series({ { 0.6, 0.1 }, { 0.4, 2.0 } });

MeasuredSite siteOf(const char* specification, std::vector<MeasuredCurve> curves)
{
  MeasuredSite site;
  site.name = "A";
  for (MeasuredCurve& curve : curves)
  {
    site.curves.push_back({ specification, tool(specification), std::move(curve), {} });
  }
  return site;
}

MeasuredSite identified(const char* specification, std::vector<MeasuredCurve> curves,
  const IdentificationOptions& options = {}, const palpate::ElasticityLimits& limits = {})
{
  MeasuredSite site = siteOf(specification, std::move(curves));
  palpate::identifySite(limits, BodyIdentification(options), site);
  return site;
}

IdentificationOptions halfSpace()
{
  IdentificationOptions options;
  options.model = BodyModel::HalfSpace;
  options.largestStrain = 100.0; // the truth is linear at every depth
  return options;
}

/// The largest relative difference of E* ψ from the truth over the window that is told.
double worstRelaxation(const IdentifiedBody& body, double modulus, const PronySeries& truth)
{
  double worst = 0.0;
  for (double t = body.shortestTime; t <= body.longestTime; t *= 1.1)
  {
    const double found = body.reducedModulus.value * relaxationAt(body.relaxation, t);
    worst = std::max(worst, std::abs(found / (modulus * relaxationAt(truth, t)) - 1.0));
  }
  return worst;
}

bool holds(const palpate::Estimate& estimate, double truth)
{
  return estimate.lower <= truth && truth <= estimate.upper;
}

/// f = δ^1.5 of the paraboloid of 6.35 mm.
const double UnitModulus = 0.75 / std::sqrt(R);
} // namespace

TEST(RelaxationIdentification, RampAndHoldOfTheSheet)
{
  std::ifstream file(PALPATE_DATA_DIR "/Reference/rate/ident_ramp_hold_noisy.csv");
  std::string line;
  std::getline(file, line); // what it is
  std::getline(file, line); // t_s,F_clean_N,F_noisy_N
  MeasuredCurve curve;
  for (double t = 0.0, clean = 0.0, noisy = 0.0; std::getline(file, line);)
  {
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &t, &clean, &noisy), 3) << line;
    curve.time.push_back(t);
    curve.deflection.push_back(std::min(20.0 * t, 1.0));
    curve.force.push_back(noisy);
  }
  IdentificationOptions options = halfSpace();
  options.findContact = false;
  const IdentifiedBody body = identified("paraboloid:6.35", { curve }, options).body;
  ASSERT_EQ(body.refusal, "");
  ASSERT_EQ(body.relaxation.count, 2U);
  EXPECT_TRUE(body.withinNoise);
  const double worst = worstRelaxation(body, UnitModulus, SheetSeries);
  std::printf("  %s: %.2f %%; %s\n", textOf(body.relaxation).c_str(), 100.0 * worst,
    body.remark.c_str());
  // The sheet's own fits stay within 1.0 % (the median of the worst).
  EXPECT_LT(worst, 0.01);
  EXPECT_TRUE(holds(body.reducedModulus, UnitModulus));
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(holds(body.relaxationStrength[i], SheetSeries.strength[i])) << i;
    EXPECT_TRUE(holds(body.relaxationTime[i], SheetSeries.time[i])) << i;
  }
  EXPECT_NEAR(body.noise, 0.0189143, 2e-3); // of 500 readings: a tenth
  EXPECT_NEAR(body.shortestTime, 0.05 / 15.0, 2e-4); // 2 % of the depth is noise
  EXPECT_NEAR(body.longestTime, 10.0, 0.1);
}

TEST(RelaxationIdentification, TrianglesOfTheSheet)
{
  const ReferenceTable table("rate/ident_triangles_noisy.csv");
  std::vector<MeasuredCurve> curves;
  std::string up;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    if (table.text(row, "t_up_s") != up)
    {
      up = table.text(row, "t_up_s");
      curves.emplace_back();
    }
    curves.back().time.push_back(table.number(row, "t_s"));
    curves.back().deflection.push_back(table.number(row, "delta_mm"));
    curves.back().force.push_back(
      table.number(row, "F_noisy_N(1% of peak, seed 43; truth p=.6,.4 tau=.1,2, f=delta^1.5)"));
  }
  ASSERT_EQ(curves.size(), 3U);
  IdentificationOptions options = halfSpace();
  options.findContact = false;
  const IdentifiedBody body =
    identified("paraboloid:6.35", curves, options, { 0.05, 0.05 }).body; // small loops count
  ASSERT_EQ(body.refusal, "");
  ASSERT_EQ(body.relaxation.count, 2U);
  const double worst = worstRelaxation(body, UnitModulus, SheetSeries);
  std::printf("  %s: %.2f %%\n", textOf(body.relaxation).c_str(), 100.0 * worst);
  EXPECT_LT(worst, 0.03);
  EXPECT_TRUE(holds(body.reducedModulus, UnitModulus));
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_TRUE(holds(body.relaxationStrength[i], SheetSeries.strength[i])) << i;
    EXPECT_TRUE(holds(body.relaxationTime[i], SheetSeries.time[i])) << i;
  }
}
