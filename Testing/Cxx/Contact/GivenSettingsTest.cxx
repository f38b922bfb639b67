// SPDX-License-Identifier: BSD-3-Clause
// Settings from outside: every range has both its ends, and a fault names what is wrong.
#include "Contact/GivenSettings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

using palpate::ContactSettings;
using palpate::GivenSettings;
using palpate::SettingFault;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Tiny = std::numeric_limits<double>::min();

template <class Value>
struct Range
{
  const char* name;
  Value GivenSettings::*member;
  std::vector<Value> good;
  std::vector<Value> bad;
};

template <class Value>
void check(const Range<Value>& range)
{
  for (const Value value : range.good)
  {
    GivenSettings given;
    given.*range.member = value;
    EXPECT_FALSE(given.fault()) << range.name << ' ' << value;
  }
  for (const Value value : range.bad)
  {
    GivenSettings given;
    given.*range.member = value;
    const SettingFault fault = given.fault();
    EXPECT_EQ(fault.name, range.name) << value;
    std::ostringstream said;
    said << "but is " << value;
    EXPECT_EQ(fault.remark.find("must "), 0U) << fault.remark;
    EXPECT_NE(fault.remark.find(said.str()), std::string::npos) << fault.remark;
  }
}
} // namespace

TEST(GivenSettings, RangesAreKept)
{
  check<int>({ "ForceForm", &GivenSettings::forceForm, { 0, 1, 2 }, { -1, 3, 256 } });
  check<int>({ "ContactSurface", &GivenSettings::contactSurface, { 0, 1 }, { -1, 2, 256 } });
  check<int>({ "FrictionModel", &GivenSettings::frictionModel, { 0, 1, 2 }, { -1, 3, 258 } });
  check<double>({ "FrictionCoefficient", &GivenSettings::frictionCoefficient, { 0.0, 0.5, 3.0 },
    { -0.1, -Tiny, NaN, Infinity } });
  check<double>({ "TangentialStiffness", &GivenSettings::tangentialStiffness, { 1e-9, 1e6 },
    { 0.0, -1.0, NaN, Infinity } });
  check<double>({ "FrictionBreakaway", &GivenSettings::frictionBreakaway, { 0.0, 0.9 },
    { -0.1, 1.1, NaN, Infinity } });
  check<double>({ "FrictionStickRadius", &GivenSettings::frictionStickRadius, { 0.8, 1.0, 2.0 },
    { 0.79, 0.0, -1.0, NaN, Infinity } });
  check<double>(
    { "PoissonRatio", &GivenSettings::poissonRatio, { 0.0, 0.5 }, { -0.1, 0.51, NaN, Infinity } });
  GivenSettings creeping;
  creeping.frictionBreakaway = 0.0;
  creeping.frictionStickRadius = 0.0;
  EXPECT_EQ(creeping.fault().name, "FrictionStickRadius");
}

TEST(GivenSettings, DefaultsAreTheKernels)
{
  const ContactSettings usual;
  const ContactSettings given = GivenSettings().settings();
  EXPECT_FALSE(GivenSettings().fault());
  EXPECT_EQ(given.form, usual.form);
  EXPECT_EQ(given.surface, usual.surface);
  EXPECT_EQ(given.friction.model, usual.friction.model);
  EXPECT_EQ(given.friction.coefficient, usual.friction.coefficient);
  EXPECT_EQ(given.friction.tangentialStiffness, usual.friction.tangentialStiffness);
  EXPECT_EQ(given.friction.breakaway, usual.friction.breakaway);
  EXPECT_EQ(given.friction.stickRadius, usual.friction.stickRadius);
  EXPECT_EQ(given.friction.poissonRatio, usual.friction.poissonRatio);
}

TEST(GivenSettings, EachReachesItsPlace)
{
  GivenSettings given;
  given.forceForm = 2;
  given.contactSurface = 1;
  given.frictionModel = 2;
  given.frictionCoefficient = 0.1;
  given.tangentialStiffness = 0.2;
  given.frictionBreakaway = 0.3;
  given.frictionStickRadius = 0.4;
  given.poissonRatio = 0.45;
  EXPECT_FALSE(given.fault());
  const ContactSettings settings = given.settings();
  EXPECT_EQ(settings.form, palpate::ForceForm::EnergyConsistent);
  EXPECT_EQ(settings.surface, palpate::ContactSurface::Smooth);
  EXPECT_EQ(settings.friction.model, palpate::FrictionModel::ShapeDerived);
  EXPECT_EQ(settings.friction.coefficient, 0.1);
  EXPECT_EQ(settings.friction.tangentialStiffness, 0.2);
  EXPECT_EQ(settings.friction.breakaway, 0.3);
  EXPECT_EQ(settings.friction.stickRadius, 0.4);
  EXPECT_EQ(settings.friction.poissonRatio, 0.45);
}
