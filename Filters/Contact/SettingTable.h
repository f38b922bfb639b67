// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SettingTable_h
#define palpate_SettingTable_h

#include "Contact/ContactSettings.h"
#include "Contact/SettingFault.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <limits>
#include <string>
#include <type_traits>

namespace palpate
{
/// One of the values of a setting that is an enumeration.
struct SettingWord
{
  const char* name = nullptr;   ///< name of the enumerator, "NormalizedDirection"; null: none
  const char* option = nullptr; ///< name on a command line, "normalized"
};
using SettingWords = std::array<SettingWord, 3>;

/// The texts of a setting. Its default is that of ContactSettings.
struct SettingText
{
  const char* name;   ///< of the property, "FrictionCoefficient"
  const char* option; ///< on a command line, without dashes; null: not offered there
  const char* unit;   ///< "" for ratios and enumerations
  const char* help;   ///< begins with a small letter and ends without a full stop
};

/// The range of a setting; all its values are finite.
struct SettingRange
{
  static constexpr double Endless = std::numeric_limits<double>::infinity();

  double least;
  double most;
  bool includesLeast;
  const char* what; ///< the kind of number, for errors; null for an enumeration

  static constexpr SettingRange positive(const char* what) { return { 0.0, Endless, false, what }; }
  static constexpr SettingRange notNegative(const char* what)
  {
    return { 0.0, Endless, true, what };
  }
  static constexpr SettingRange between(double least, double most, const char* what)
  {
    return { least, most, true, what };
  }
};

/// One of the ContactSettings with its texts, range and access.
struct SettingRow
{
  SettingText text;
  SettingRange range;
  SettingWords words; ///< by number; empty for a number
  double (*get)(const ContactSettings&);
  void (*set)(ContactSettings&, double); ///< accepts any value, see faultOfContact()

  constexpr bool isEnumeration() const { return this->words[0].name != nullptr; }
  constexpr double usual() const { return this->get(ContactSettings{}); }
};

namespace setting
{
template <auto Member, class Settings>
constexpr auto& memberOf(Settings& settings)
{
  if constexpr (std::is_invocable_v<decltype(Member), Settings&>)
  {
    return settings.*Member;
  }
  else
  {
    return settings.friction.*Member;
  }
}

template <auto Member>
constexpr double get(const ContactSettings& settings)
{
  return static_cast<double>(memberOf<Member>(settings));
}

template <auto Member>
constexpr void set(ContactSettings& settings, double value)
{
  auto& member = memberOf<Member>(settings);
  member = static_cast<std::decay_t<decltype(member)>>(value);
}

template <auto Member>
constexpr SettingRow number(const SettingText& text, const SettingRange& range)
{
  return { text, range, {}, get<Member>, set<Member> };
}

template <auto Member>
constexpr SettingRow choice(const SettingText& text, const SettingWords& words)
{
  double last = 0.0;
  while (last + 1 < words.size() && words[static_cast<std::size_t>(last) + 1].name)
  {
    ++last;
  }
  return { text, { 0.0, last, true, nullptr }, words, get<Member>, set<Member> };
}
} // namespace setting

/**
 * The settings of a contact: the single source of their texts and ranges. Filters, sessions and the
 * C interface check values by it, the program's options are made from it, and ParaView's properties
 * are tested against it.
 */
inline constexpr std::array<SettingRow, 9> SettingTable = { {
  setting::choice<&ContactSettings::form>(
    { "ForceForm", "force-form", "",
      "how the three curves of a triangle become one force. Paper: as printed, a little weaker "
      "inside facets. Normalized direction: full magnitude along the blended normal. "
      "Energy-consistent: the gradient of the blended energy, so that closed loops within one "
      "contact neither gain nor lose energy" },
    { { { "Paper", "paper" }, { "NormalizedDirection", "normalized" },
      { "EnergyConsistent", "energy" } } }),
  setting::choice<&ContactSettings::surface>(
    { "ContactSurface", "contact-surface", "",
      "what the tip touches: the triangles, or smooth patches through their corners and the "
      "response's normals" },
    { { { "Facets", "facets" }, { "Smooth", "smooth" } } }),
  setting::choice<&FrictionSettings::model>(
    { "FrictionModel", "friction-model", "",
      "what a contact does before it slides. Elasto-plastic: sticks, stays where it is under light "
      "loads. Dahl: creeps from the first displacement on, and drifts. Shape-derived: follows from "
      "the response itself" },
    { { { "ElastoPlastic", "elasto-plastic" }, { "Dahl", "dahl" }, { "ShapeDerived", "shape" } } }),
  setting::number<&FrictionSettings::coefficient>(
    { "FrictionCoefficient", "friction", "", "Coulomb's coefficient of friction; 0: none" },
    SettingRange::notNegative("a coefficient of friction, e.g. 0.3")),
  setting::number<&FrictionSettings::tangentialStiffness>(
    { "TangentialStiffness", "tangential-stiffness", "N/mm",
      "of the stuck contact, above 0; not used by the shape-derived model" },
    SettingRange::positive("a stiffness in N/mm, e.g. 1")),
  setting::number<&FrictionSettings::breakaway>(
    { "FrictionBreakaway", nullptr, "",
      "elasto-plastic model: share of the sliding limit below which nothing creeps" },
    SettingRange::between(0.0, 1.0, "a share, e.g. 0.8")),
  setting::number<&FrictionSettings::stickRadius>(
    { "FrictionStickRadius", nullptr, "",
      "elasto-plastic model: share of the sliding limit at which half of a further displacement is "
      "creep; no less than the breakaway" },
    SettingRange::positive("a share, e.g. 0.9")),
  setting::number<&FrictionSettings::poissonRatio>(
    { "PoissonRatio", nullptr, "", "of the body; only used by the shape-derived friction" },
    SettingRange::between(0.0, 0.5, "Poisson's ratio, e.g. 0.45")),
  setting::number<&ContactSettings::relaxationElements>(
    { "RelaxationElements", "relaxation-elements", "",
      "elements side by side that a body which relaxes is felt with, of which each touches and "
      "lets go by itself; 0: one for all, the quasi-linear law" },
    SettingRange::between(
      0.0, ContactSettings::MostRelaxationElements, "a number of elements, e.g. 16")),
} };

/// The row with this name or command-line option; null if there is none.
PALPATE_EXPORT const SettingRow* findSetting(const std::string& nameOrOption);

/// The first setting that is out of its range or NaN, even if the chosen model does not use it.
/// Kernels require settings without fault.
PALPATE_EXPORT SettingFault faultOfContact(const ContactSettings& settings);
} // namespace palpate

#endif
