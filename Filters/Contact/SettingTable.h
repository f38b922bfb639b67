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
/// Names of one value of an enumeration.
struct SettingWord
{
  /// Name of the enumerator, "NormalizedDirection"; null if the entry is unused.
  const char* name = nullptr;
  const char* option = nullptr; ///< name on a command line and in Python, "normalized-direction"
  const char* older = nullptr;  ///< an earlier name, which can still be read; null if there is none
};
using SettingWords = std::array<SettingWord, 3>;

/// The texts of a setting. Its default is the default of ContactSettings.
struct SettingText
{
  const char* name;   ///< name of the property, "FrictionCoefficient"
  const char* option; ///< command-line option without dashes; null if there is no option
  const char* unit;   ///< unit; "" for ratios and enumerations
  /// Description of the setting, with unit and range but without the default. It begins with a
  /// small letter and ends without a full stop.
  const char* help;
};

/// The range of a setting. All values of a setting are finite.
struct SettingRange
{
  static constexpr double Endless = std::numeric_limits<double>::infinity();

  double least;
  double most;
  bool includesLeast;
  const char* what; ///< the kind of number, for error messages; null for an enumeration

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
  /// Names of the values of an enumeration, in the order of the values; empty for a number.
  SettingWords words;
  double (*get)(const ContactSettings&);
  void (*set)(ContactSettings&, double); ///< accepts any value; faultOfContact() checks it

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
 * The settings of a contact. This table is the only source of their texts and ranges. Filters,
 * sessions and the C interface check values with this table, the program's options are derived from
 * it, and ParaView's properties are tested against it.
 */
inline constexpr std::array<SettingRow, 9> SettingTable = { {
  setting::choice<&ContactSettings::form>(
    { "ForceForm", "force-form", "",
      "rule that combines the curves of a triangle's three corners into one force. Paper: the "
      "printed sum of the three forces, slightly too small inside a facet. Normalized direction: "
      "the blended magnitude along the blended normal. Energy-consistent: the gradient of the "
      "blended energy; a closed path within one contact neither gains nor loses energy" },
    { { { "Paper", "paper" }, { "NormalizedDirection", "normalized-direction", "normalized" },
      { "EnergyConsistent", "energy-consistent", "energy" } } }),
  setting::choice<&ContactSettings::surface>(
    { "ContactSurface", "contact-surface", "",
      "surface that the tip touches. Facets: the triangles. Smooth: a curved patch on each "
      "triangle, through its corners and perpendicular to the normals of the response there" },
    { { { "Facets", "facets" }, { "Smooth", "smooth" } } }),
  setting::choice<&FrictionSettings::model>(
    { "FrictionModel", "friction-model", "",
      "behaviour of a contact before it slides. Elasto-plastic: it sticks, and does not drift "
      "under light loads. Dahl: it creeps from the first displacement on, and drifts. "
      "Shape-derived: its resistance follows from the curves of the response" },
    { { { "ElastoPlastic", "elasto-plastic" }, { "Dahl", "dahl" },
      { "ShapeDerived", "shape-derived", "shape" } } }),
  setting::number<&FrictionSettings::coefficient>(
    { "FrictionCoefficient", "friction", "",
      "Coulomb's coefficient of friction, at least 0. 0: no friction" },
    SettingRange::notNegative("a coefficient of friction, e.g. 0.3")),
  setting::number<&FrictionSettings::tangentialStiffness>(
    { "TangentialStiffness", "tangential-stiffness", "N/mm",
      "tangential stiffness of a sticking contact, N/mm, above 0. The shape-derived model does "
      "not use it" },
    SettingRange::positive("a stiffness in N/mm, e.g. 1")),
  setting::number<&FrictionSettings::breakaway>(
    { "FrictionBreakaway", nullptr, "",
      "fraction of the sliding limit below which a contact does not creep, 0 to 1. Only the "
      "elasto-plastic model uses it" },
    SettingRange::between(0.0, 1.0, "a fraction, e.g. 0.8")),
  setting::number<&FrictionSettings::stickRadius>(
    { "FrictionStickRadius", nullptr, "",
      "fraction of the sliding limit at which half of a further displacement is creep, above 0 "
      "and no less than the breakaway. Only the elasto-plastic model uses it" },
    SettingRange::positive("a fraction, e.g. 0.9")),
  setting::number<&FrictionSettings::poissonRatio>(
    { "PoissonRatio", nullptr, "",
      "Poisson's ratio of the body, 0 to 0.5. Only the shape-derived friction model uses it" },
    SettingRange::between(0.0, 0.5, "Poisson's ratio, e.g. 0.45")),
  setting::number<&ContactSettings::relaxationElements>(
    { "RelaxationElements", "relaxation-elements", "",
      "number of parallel elements in a contact with a body that relaxes, 0 to 32. Each element "
      "touches and separates by itself; more elements are more accurate when the tool moves out. "
      "0: one element, the quasi-linear law" },
    SettingRange::between(
      0.0, ContactSettings::MostRelaxationElements, "a number of elements, e.g. 16")),
} };

/// Returns the row with this property name or command-line option; null if there is none.
PALPATE_EXPORT const SettingRow* findSetting(const std::string& nameOrOption);

/// Returns the first setting that is out of its range or NaN, even if the chosen model does not use
/// it. The contact classes require settings without fault.
PALPATE_EXPORT SettingFault faultOfContact(const ContactSettings& settings);
} // namespace palpate

#endif
