// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactNames_h
#define palpate_ContactNames_h

#include "Contact/SettingTable.h"
#include "NumberRange.h"

#include <map>
#include <string>

namespace palpate
{
/// The names of an enumeration's values on the command line.
using ContactNames = std::map<std::string, int>;
inline ContactNames namesOf(const SettingRow& setting)
{
  ContactNames names;
  for (std::size_t i = 0; i < setting.words.size() && setting.words[i].option; ++i)
  {
    names[setting.words[i].option] = static_cast<int>(i);
  }
  return names;
}

/// Returns the present name of a setting's value. `name` is the present name or an earlier one.
inline std::string presentName(const SettingRow& setting, const std::string& name)
{
  for (const SettingWord& word : setting.words)
  {
    if (word.older && name == word.older)
    {
      return word.option;
    }
  }
  return name;
}

/// The range of a setting.
inline NumberRange rangeOf(const SettingRow& setting)
{
  const SettingRange& range = setting.range;
  return { range.what, range.least, range.most, range.includesLeast };
}

constexpr double Kilometre = 1e6; // mm; larger than any body

/// Range of Young's modulus, for the option and for the alternatives of a trial.
inline constexpr NumberRange YoungsModulusRange =
  NumberRange::positive("a modulus in MPa, e.g. 0.05");
inline constexpr NumberRange PoissonsRatioRange =
  NumberRange::between(0.0, 0.5, "Poisson's ratio, e.g. 0.45");
inline constexpr NumberRange LayerRange =
  NumberRange::positive("a thickness in mm, e.g. 7, or none", Kilometre);
inline constexpr NumberRange StackRange{ "a thickness in mm, e.g. 1.5", 0.0, Kilometre };
} // namespace palpate

#endif
