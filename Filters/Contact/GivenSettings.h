// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_GivenSettings_h
#define palpate_GivenSettings_h

#include "Contact/ContactSettings.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// What is wrong with one setting; nothing if there is no name.
struct SettingFault
{
  std::string name;   ///< as the filters' property, "FrictionCoefficient"
  std::string remark; ///< "must be finite and not negative, but is -1"

  explicit operator bool() const noexcept { return !this->name.empty(); }
};

/**
 * ContactSettings as they come in from outside, enumerations as numbers: what the properties of the
 * filters and the C interface hold, and the one place that knows their ranges. Members, units and
 * defaults are those of ContactSettings.
 */
struct PALPATE_EXPORT GivenSettings
{
  int forceForm = static_cast<int>(ContactSettings{}.form);
  int contactSurface = static_cast<int>(ContactSettings{}.surface);
  int frictionModel = static_cast<int>(FrictionSettings{}.model);
  double frictionCoefficient = FrictionSettings{}.coefficient;         ///< >= 0
  double tangentialStiffness = FrictionSettings{}.tangentialStiffness; ///< N/mm, > 0
  double frictionBreakaway = FrictionSettings{}.breakaway;             ///< 0 to 1
  double frictionStickRadius = FrictionSettings{}.stickRadius;         ///< > 0, >= the breakaway
  double poissonRatio = FrictionSettings{}.poissonRatio;               ///< 0 to 0.5

  /// The first that is out of its range, NaN included; also one that the chosen model does not use.
  SettingFault fault() const;

  /// As the kernel takes them; only if there is no fault.
  ContactSettings settings() const noexcept;
};
} // namespace palpate

#endif
