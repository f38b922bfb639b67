// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/SettingTable.h"

#include <cmath>
#include <cstdint>
#include <sstream>

namespace palpate
{
namespace
{
/// Returns the requirement for a setting: "be 0 (Facets) or 1 (Smooth)", "be finite and positive
/// (N/mm)", "lie between 0 and 1".
std::string demandOf(const SettingRow& row)
{
  std::ostringstream demand;
  if (row.isEnumeration())
  {
    const int last = static_cast<int>(row.range.most);
    demand << "be ";
    for (int i = 0; i <= last; ++i)
    {
      demand << (i == 0         ? ""
                    : i == last ? " or "
                                : ", ")
             << i << " (" << row.words[static_cast<std::size_t>(i)].name << ")";
    }
  }
  else if (std::isfinite(row.range.most))
  {
    demand << "lie between " << row.range.least << " and " << row.range.most;
  }
  else
  {
    demand << "be finite and " << (row.range.includesLeast ? "not negative" : "positive");
  }
  if (*row.text.unit)
  {
    demand << " (" << row.text.unit << ")";
  }
  return demand.str();
}
} // namespace

const SettingRow* findSetting(const std::string& nameOrOption)
{
  for (const SettingRow& row : SettingTable)
  {
    if (nameOrOption == row.text.name || (row.text.option && nameOrOption == row.text.option))
    {
      return &row;
    }
  }
  return nullptr;
}

SettingFault faultOfContact(const ContactSettings& settings)
{
  for (const SettingRow& row : SettingTable)
  {
    const double value = row.get(settings);
    const SettingRange& range = row.range;
    const bool isWithin = std::isfinite(value) && value <= range.most &&
      (range.includesLeast ? value >= range.least : value > range.least);
    if (!isWithin)
    {
      return row.isEnumeration()
        ? SettingFault::must(row.text.name, demandOf(row), static_cast<std::int64_t>(value))
        : SettingFault::must(row.text.name, demandOf(row), value);
    }
  }
  if (settings.friction.stickRadius < settings.friction.breakaway)
  {
    return SettingFault::must(
      "FrictionStickRadius", "be no less than the breakaway", settings.friction.stickRadius);
  }
  return {};
}
} // namespace palpate
