// SPDX-License-Identifier: BSD-3-Clause
// Settings given as text: every range is checked at both ends, and a fault names the invalid
// setting.
#include "Contact/SettingTable.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using palpate::ContactSettings;
using palpate::Infinity;
using palpate::NotANumber;
using palpate::SettingFault;
using palpate::SettingRow;
using palpate::SettingTable;

namespace
{
constexpr double Tiny = std::numeric_limits<double>::min();

void check(const char* name, const std::vector<double>& good, const std::vector<double>& bad)
{
  const SettingRow* row = palpate::findSetting(name);
  ASSERT_NE(row, nullptr) << name;
  for (const double value : good)
  {
    ContactSettings given;
    row->set(given, value);
    EXPECT_EQ(row->get(given), value);
    EXPECT_FALSE(palpate::faultOfContact(given)) << name << ' ' << value;
  }
  for (const double value : bad)
  {
    ContactSettings given;
    row->set(given, value);
    const SettingFault fault = palpate::faultOfContact(given);
    EXPECT_EQ(fault.name, name) << value;
    std::ostringstream said;
    said << "but is " << value;
    EXPECT_EQ(fault.remark.find("must "), 0U) << fault.remark;
    EXPECT_NE(fault.remark.find(said.str()), std::string::npos) << fault.remark;
  }
}
} // namespace

TEST(SettingTable, RangesAreKept)
{
  check("ForceForm", { 0, 1, 2 }, { -1, 3, 256 });
  check("ContactSurface", { 0, 1 }, { -1, 2, 256 });
  check("FrictionModel", { 0, 1, 2 }, { -1, 3, 258 });
  check("FrictionCoefficient", { 0.0, 0.5, 3.0 }, { -0.1, -Tiny, NotANumber, Infinity });
  check("TangentialStiffness", { 1e-9, 1e6 }, { 0.0, -1.0, NotANumber, Infinity });
  check("FrictionBreakaway", { 0.0, 0.9 }, { -0.1, 1.1, NotANumber, Infinity });
  check("FrictionStickRadius", { 0.8, 1.0, 2.0 }, { 0.79, 0.0, -1.0, NotANumber, Infinity });
  check("PoissonRatio", { 0.0, 0.5 }, { -0.1, 0.51, NotANumber, Infinity });
  check("RelaxationElements", { 0, 16, 32 }, { -1, 33 });
  ContactSettings creeping;
  creeping.friction.breakaway = 0.0;
  creeping.friction.stickRadius = 0.0;
  EXPECT_EQ(palpate::faultOfContact(creeping).name, "FrictionStickRadius");
}

TEST(SettingTable, FaultsAreWords)
{
  ContactSettings given;
  EXPECT_FALSE(palpate::faultOfContact(given));
  given.form = static_cast<palpate::ForceForm>(3);
  EXPECT_EQ(palpate::faultOfContact(given).remark,
    "must be 0 (Paper), 1 (NormalizedDirection) or 2 (EnergyConsistent), but is 3");
  given = {};
  given.surface = static_cast<palpate::ContactSurface>(std::numeric_limits<int>::max());
  EXPECT_EQ(
    palpate::faultOfContact(given).remark, "must be 0 (Facets) or 1 (Smooth), but is 2147483647");
  given = {};
  given.friction.tangentialStiffness = 0.0;
  EXPECT_EQ(palpate::faultOfContact(given).remark, "must be finite and positive (N/mm), but is 0");
  given = {};
  given.friction.stickRadius = 0.5;
  EXPECT_EQ(
    palpate::faultOfContact(given).remark, "must be no less than the breakaway, but is 0.5");
}

// Each row sets its own member, and the defaults are within the ranges.
TEST(SettingTable, EachReachesItsPlace)
{
  ContactSettings given;
  double value = 0.0;
  for (const SettingRow& row : SettingTable)
  {
    row.set(given, row.isEnumeration() ? row.range.most : value += 0.125);
  }
  EXPECT_EQ(given.form, palpate::ForceForm::EnergyConsistent);
  EXPECT_EQ(given.surface, palpate::ContactSurface::Smooth);
  EXPECT_EQ(given.friction.model, palpate::FrictionModel::ShapeDerived);
  EXPECT_EQ(given.friction.coefficient, 0.125);
  EXPECT_EQ(given.friction.tangentialStiffness, 0.25);
  EXPECT_EQ(given.friction.breakaway, 0.375);
  EXPECT_EQ(given.friction.stickRadius, 0.5);
  EXPECT_EQ(given.friction.poissonRatio, 0.625);
}

TEST(SettingTable, NamesAndOptionsAreFoundAndDiffer)
{
  std::set<std::string> names;
  for (const SettingRow& row : SettingTable)
  {
    EXPECT_TRUE(names.insert(row.text.name).second) << row.text.name;
    EXPECT_EQ(palpate::findSetting(row.text.name), &row);
    if (row.text.option)
    {
      EXPECT_TRUE(names.insert(row.text.option).second) << row.text.option;
      EXPECT_EQ(palpate::findSetting(row.text.option), &row);
    }
    EXPECT_EQ(row.isEnumeration(), row.range.what == nullptr) << row.text.name;
  }
  EXPECT_EQ(palpate::findSetting("Viscosity"), nullptr);
}
