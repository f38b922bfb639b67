// SPDX-License-Identifier: BSD-3-Clause
// The error of a relaxing contact with few elements, against the reference runs from which it is
// derived, and the number of elements that meets a tolerance.
#include "Laws/RelaxationError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using palpate::PronySeries;
using palpate::relaxationError;
using palpate::RelaxationNeed;
using palpate::relaxationNeed;
using palpate::relaxationReason;
using palpate::RelaxationTerms;

namespace
{
/// Largest error of each column over all full-depth runs of a tool.
std::map<std::string, double> worstOf(const std::string& tool)
{
  std::ifstream file(PALPATE_DATA_DIR "/Reference/rate/tick_variants.csv");
  const auto split = [](const std::string& line)
  {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');)
    {
      cells.push_back(cell);
    }
    return cells;
  };
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = split(line);
  std::map<std::string, double> worst;
  while (std::getline(file, line))
  {
    const std::vector<std::string> cells = split(line);
    if (cells[0] == "1" && cells[1] == tool)
    {
      for (std::size_t k = 5; k < cells.size(); ++k)
      {
        worst[names[k]] = std::max(worst[names[k]], std::stod(cells[k]));
      }
    }
  }
  return worst;
}

RelaxationTerms termsOf(double total, double exponent)
{
  RelaxationTerms terms;
  terms.series.add(0.5 * total, 0.1);
  terms.series.add(0.5 * total, 2.0);
  terms.exponent = exponent;
  return terms;
}
} // namespace

TEST(RelaxationError, IsThatOfTheReference)
{
  const struct
  {
    const char* tool;
    double exponent;
  } tools[] = { { "flat", 1.0 }, { "paraboloid", 1.5 }, { "cone", 2.0 } };
  for (const auto& each : tools)
  {
    const std::map<std::string, double> worst = worstOf(each.tool);
    ASSERT_FALSE(worst.empty());
    // The table states three digits.
    const std::map<int, std::string> columns = { { 0, "QLV_U" }, { 4, "C4^2" }, { 8, "C8^2" },
      { 16, "C16^2" } };
    for (const auto& [elements, column] : columns)
    {
      EXPECT_NEAR(relaxationError(elements, each.exponent) / worst.at(column), 1.0, 0.02)
        << each.tool << ' ' << elements;
    }
  }
  // The error of the exact sphere is at most that of the paraboloid.
  EXPECT_LT(worstOf("sphere R=1.6 exact").at("C8^2"), relaxationError(8, 1.5));
}

TEST(RelaxationError, FallsWithElementsAndRisesWithTheExponent)
{
  for (double m = 0.5; m < 4.0; m += 0.25)
  {
    for (int elements = 0; elements < 32; ++elements)
    {
      if (m <= 2.0) // for larger exponents, outside the table, 4 elements are worse than one
      {
        EXPECT_LE(relaxationError(elements + 1, m), relaxationError(elements, m) * (1.0 + 1e-12));
      }
      EXPECT_LE(relaxationError(elements, m), relaxationError(elements, m + 0.25) * (1.0 + 1e-12));
      EXPECT_GT(relaxationError(elements, m), 0.0);
    }
  }
}

TEST(RelaxationError, ANeedKeepsTheTolerance)
{
  for (const double m : { 1.0, 1.3, 1.5, 1.8, 2.0 })
  {
    for (const double tolerance : { 0.2, 0.11, 0.05, 0.02, 0.01, 0.005 })
    {
      const RelaxationNeed need = relaxationNeed(termsOf(2.0, m), 0, tolerance);
      EXPECT_TRUE(need.isFelt);
      EXPECT_LE(need.error, tolerance);
      if (need.elements > 0)
      {
        const int fewer = need.elements == 4 ? 0 : need.elements / 2;
        EXPECT_GT(relaxationError(fewer, m), tolerance);
      }
    }
  }
}

TEST(RelaxationError, WhatIsNotFeltIsDeclined)
{
  const RelaxationTerms terms = termsOf(0.009, 1.5);
  const RelaxationNeed need = relaxationNeed(terms, 0, 0.01);
  EXPECT_FALSE(need.isFelt);
  EXPECT_EQ(need.elements, 0);
  EXPECT_EQ(relaxationReason(need, terms.series, 0.01),
    "relaxation is left out: it adds 0.9 % to the force at most, within 1 %");
  EXPECT_EQ(relaxationReason({}, PronySeries(), 0.01), "");
}

TEST(RelaxationError, OfStrengthsPerPointTheLargestCounts)
{
  RelaxationTerms terms = termsOf(0.001, 1.5);
  const std::vector<float> strength = { 0.0F, 0.0F, 0.25F, 0.5F, 0.5F, 0.125F };
  terms.strength = strength.data();
  const RelaxationNeed need = relaxationNeed(terms, 3, 0.01);
  EXPECT_EQ(need.strength, 0.75);
  EXPECT_TRUE(need.isFelt);
  const std::string words = relaxationReason(need, terms.series, 0.01);
  EXPECT_NE(words.find("16 elements"), std::string::npos) << words;
  EXPECT_NE(words.find("not known"), std::string::npos) << words;
  EXPECT_NE(words.find("75 % larger"), std::string::npos) << words;
}
