// SPDX-License-Identifier: BSD-3-Clause
#include "ToolSpecification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

using palpate::parseTool;
using palpate::ToolShape;
using palpate::ToolSpecification;

namespace
{
std::string errorOf(const std::string& text)
{
  ToolSpecification specification{ ToolShape::Flat, 7.0 };
  std::string error;
  EXPECT_FALSE(parseTool(text, specification, error)) << text;
  // Nothing half-read.
  EXPECT_EQ(specification.Shape, ToolShape::Flat);
  EXPECT_EQ(specification.Parameter, 7.0);
  return error;
}

void expectNamed(const std::string& text, const std::string& part)
{
  EXPECT_NE(errorOf(text).find(part), std::string::npos)
    << "'" << part << "' is not in: " << errorOf(text);
}
} // namespace

TEST(ToolSpecification, ReadsEachShape)
{
  const std::pair<const char*, ToolSpecification> cases[] = {
    { "flat:1.6", { ToolShape::Flat, 1.6 } },
    { "paraboloid:6.35", { ToolShape::Paraboloid, 6.35 } },
    { "sphere:5e-1", { ToolShape::Sphere, 0.5 } },
    { "cone:60", { ToolShape::Cone, 60.0 } },
  };
  for (const auto& [text, expected] : cases)
  {
    ToolSpecification read;
    std::string error;
    EXPECT_TRUE(parseTool(text, read, error)) << error;
    EXPECT_TRUE(error.empty());
    EXPECT_EQ(read.Shape, expected.Shape);
    EXPECT_EQ(read.Parameter, expected.Parameter);
  }
}

TEST(ToolSpecification, RoundTripToTheBit)
{
  std::mt19937_64 random(20);
  const char* const names[] = { "flat", "paraboloid", "sphere", "cone" };
  int tried = 0;
  while (tried < 4000)
  {
    // Any bit pattern that is a legal parameter, over all magnitudes, denormal ones included.
    const std::uint64_t bits = random() & 0x7fffffffffffffffU;
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    const ToolSpecification given{ static_cast<ToolShape>(tried % 4), value };
    if (!palpate::checkTool(given).empty())
    {
      continue;
    }
    ++tried;
    const std::string text = palpate::makeTool(given)->specification();
    EXPECT_EQ(text, palpate::formatTool(names[(tried - 1) % 4], { value }));
    ToolSpecification read;
    std::string error;
    ASSERT_TRUE(parseTool(text, read, error)) << error;
    EXPECT_EQ(read.Shape, given.Shape);
    EXPECT_EQ(std::memcmp(&read.Parameter, &value, sizeof value), 0) << text;
  }
}

TEST(ToolSpecification, FormatsShortestDecimals)
{
  EXPECT_EQ(palpate::formatTool("sphere", { 6.35 }), "sphere:6.35");
  EXPECT_EQ(palpate::formatTool("truncated", { 0.1, 60.0 }), "truncated:0.1,60");
}

TEST(ToolSpecification, UnknownShapesAreNamed)
{
  for (const char* text : { "spehre:5", "", ":", "Sphere:5", "sphere", " sphere:5", "cone60" })
  {
    expectNamed(text, "'" + std::string(text) + "' is not known");
    expectNamed(text, "flat:R, sphere:R, paraboloid:R (mm) or cone:DEGREES");
  }
}

TEST(ToolSpecification, BadNumbersAreNamed)
{
  expectNamed("sphere:", "'' is not one number");
  expectNamed("sphere:5mm", "'5mm' is not one number");
  expectNamed("flat:1,6", "'1,6' is not one number");
  expectNamed("cone:sixty", "'sixty' is not one number");
  expectNamed("sphere: 5", "' 5' is not one number");
  expectNamed("sphere:1e999", "'1e999' is not one number");
}

TEST(ToolSpecification, ParametersOutOfRangeAreNamed)
{
  expectNamed("sphere:0", "radius of a sphere must be positive and finite (mm), but is 0");
  expectNamed("paraboloid:-2.5", "radius of a paraboloid");
  expectNamed("paraboloid:-2.5", "-2.5");
  expectNamed("flat:inf", "radius of a flat");
  expectNamed("flat:nan", "but is nan");
  expectNamed("cone:0", "half angle of a cone must lie between 0 and 90 degrees, but is 0");
  expectNamed("cone:90", "but is 90");
  expectNamed("cone:-10", "but is -10");
  expectNamed("cone:nan", "but is nan");
  // With the whole text, so that a list of tools tells which one.
  expectNamed("cone:95", "tool 'cone:95'");
}

TEST(ToolSpecification, MakesNothingOfWhatItRefuses)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    for (const auto shape :
      { ToolShape::Flat, ToolShape::Paraboloid, ToolShape::Sphere, ToolShape::Cone })
    {
      EXPECT_EQ(palpate::makeTool({ shape, value }), nullptr);
    }
  }
  EXPECT_NE(palpate::makeTool({ ToolShape::Cone, 89.9 }), nullptr);
}
