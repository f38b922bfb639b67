// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/ToolSpecification.h"

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
using S = ToolSpecification;

ToolSpecification shaped(ToolShape shape)
{
  ToolSpecification specification;
  specification.Shape = shape;
  return specification;
}

std::string errorOf(const std::string& text)
{
  ToolSpecification specification = shaped(ToolShape::Flat);
  specification.Radius = 7.0;
  specification.Profile = { { 0.0, 0.0 } };
  std::string error;
  EXPECT_FALSE(parseTool(text, specification, error)) << text;
  // A rejected text leaves the specification unchanged.
  EXPECT_EQ(specification.Shape, ToolShape::Flat);
  EXPECT_EQ(specification.Radius, 7.0);
  EXPECT_EQ(specification.HalfAngle, 60.0);
  EXPECT_EQ(specification.EdgeRadius, 1.0);
  EXPECT_EQ(specification.Exponent, 2.0);
  EXPECT_EQ(specification.Coefficient, 0.1);
  EXPECT_EQ(specification.Profile.size(), 1U);
  return error;
}

void expectNamed(const std::string& text, const std::string& part)
{
  EXPECT_NE(errorOf(text).find(part), std::string::npos)
    << "'" << part << "' is not in: " << errorOf(text);
}

struct NamedShape
{
  const char* name;
  ToolShape shape;
  std::vector<double S::*> parameters;
};
const NamedShape Shapes[] = { { "flat", ToolShape::Flat, { &S::Radius } },
  { "paraboloid", ToolShape::Paraboloid, { &S::Radius } },
  { "sphere", ToolShape::Sphere, { &S::Radius } }, { "cone", ToolShape::Cone, { &S::HalfAngle } },
  { "truncated", ToolShape::TruncatedCone, { &S::Radius, &S::HalfAngle } },
  { "blunted", ToolShape::BluntedCone, { &S::Radius, &S::HalfAngle } },
  { "rounded", ToolShape::RoundedFlat, { &S::Radius, &S::EdgeRadius } },
  { "power", ToolShape::PowerLaw, { &S::Exponent, &S::Coefficient } } };
} // namespace

TEST(ToolSpecification, ReadsEachParameterToItsPlace)
{
  for (const NamedShape& each : Shapes)
  {
    const std::string text =
      std::string(each.name) + (each.parameters.size() == 1 ? ":1.6" : ":1.6,3e1");
    ToolSpecification read;
    std::string error;
    EXPECT_TRUE(parseTool(text, read, error)) << error;
    EXPECT_TRUE(error.empty());
    EXPECT_EQ(read.Shape, each.shape);
    EXPECT_EQ(read.*each.parameters[0], 1.6);
    EXPECT_EQ(read.*each.parameters.back(), each.parameters.size() == 1 ? 1.6 : 30.0);
  }
}

TEST(ToolSpecification, RoundTripToTheBit)
{
  std::mt19937_64 random(20);
  const auto anyNumber = [&random]
  {
    // Any bit pattern: all magnitudes, including denormal numbers.
    const std::uint64_t bits = random() & 0x7fffffffffffffffU;
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  };
  std::uniform_real_distribution<double> angle(0.0, 90.0);
  std::uniform_real_distribution<double> exponent(1.0, 100.0);
  for (int tried = 0; tried < 4000;)
  {
    const NamedShape& each = Shapes[tried % 8];
    ToolSpecification given = shaped(each.shape);
    for (const auto parameter : each.parameters)
    {
      given.*parameter = parameter == &S::HalfAngle ? angle(random)
        : parameter == &S::Exponent                 ? exponent(random)
                                                    : anyNumber();
    }
    if (!palpate::checkTool(given).empty())
    {
      continue;
    }
    ++tried;
    const std::string text = palpate::makeTool(given)->specification();
    ToolSpecification read;
    std::string error;
    ASSERT_TRUE(parseTool(text, read, error)) << error;
    EXPECT_EQ(read.Shape, given.Shape);
    for (const auto parameter : each.parameters)
    {
      EXPECT_EQ(std::memcmp(&(read.*parameter), &(given.*parameter), sizeof(double)), 0) << text;
    }
  }
}

TEST(ToolSpecification, FormatsShortestDecimals)
{
  EXPECT_EQ(palpate::formatTool("sphere", { 6.35 }), "sphere:6.35");
  EXPECT_EQ(palpate::formatTool("truncated", { 0.1, 60.0 }), "truncated:0.1,60");
}

TEST(ToolSpecification, UnknownShapesAreNamed)
{
  for (const char* text : { "spehre:5", "", ":", "Sphere:5", " sphere:5", "cone60", "trunc:1,60" })
  {
    expectNamed(text, "'" + std::string(text) + "' is not known");
    expectNamed(text, palpate::toolSyntax());
  }
  for (const NamedShape& each : Shapes)
  {
    EXPECT_NE(
      std::string(palpate::toolSyntax()).find(std::string(each.name) + ":"), std::string::npos);
  }
}

TEST(ToolSpecification, AShapeWithoutItsSizeIsNamed)
{
  for (const char* text : { "sphere", "cone", "profile" })
  {
    expectNamed(text, "'" + std::string(text) + "' needs a colon and its size; give ");
    expectNamed(text, palpate::toolSyntax());
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
  expectNamed("truncated:1", "'1' is not two numbers");
  expectNamed("blunted:1;60", "'1;60' is not two numbers");
  expectNamed("rounded:1,", "'1,' is not two numbers");
  expectNamed("power:2,0.1,3", "'2,0.1,3' is not two numbers");
  expectNamed("power:,0.1", "',0.1' is not two numbers");
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
  expectNamed("truncated:0,60", "radius of a truncated cone");
  expectNamed("truncated:1,90", "half angle of a truncated cone");
  expectNamed("blunted:-1,60", "radius of a blunted cone");
  expectNamed("blunted:1,0", "half angle of a blunted cone");
  expectNamed("rounded:0,1", "the radius of a rounded flat");
  expectNamed("rounded:1,-0.5", "the edge radius of a rounded flat");
  expectNamed("rounded:1,-0.5", "but is -0.5");
  expectNamed("power:0.5,1", "exponent of a power law must lie between 1 and 100, but is 0.5");
  expectNamed("power:101,1", "but is 101");
  expectNamed("power:nan,1", "but is nan");
  expectNamed("power:2,0", "coefficient of a power law");
  // The error contains the whole text, so that it identifies the tool in a list.
  expectNamed("cone:95", "tool 'cone:95'");
}

TEST(ToolSpecification, MakesNothingOfWhatItRefuses)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    for (const NamedShape& each : Shapes)
    {
      for (const auto parameter : each.parameters)
      {
        ToolSpecification wrong = shaped(each.shape);
        EXPECT_NE(palpate::makeTool(wrong), nullptr);
        wrong.*parameter = value;
        EXPECT_EQ(palpate::makeTool(wrong), nullptr) << each.name;
      }
    }
  }
  // the profile has no points yet
  EXPECT_EQ(palpate::makeTool(shaped(ToolShape::Profile)), nullptr);
}
