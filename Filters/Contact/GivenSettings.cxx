// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/GivenSettings.h"

#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{
template <class Value>
SettingFault makeFault(const char* name, const std::string& range, Value value)
{
  std::ostringstream remark;
  remark << "must " << range << ", but is " << value;
  return { name, remark.str() };
}
} // namespace

SettingFault GivenSettings::fault() const
{
  const auto isWithin = [](double value, double low, double high)
  { return value >= low && value <= high; }; // not NaN
  if (!isWithin(this->forceForm, 0, 2))
  {
    return makeFault("ForceForm", "be 0 (Paper), 1 (NormalizedDirection) or 2 (EnergyConsistent)",
      this->forceForm);
  }
  if (!isWithin(this->contactSurface, 0, 1))
  {
    return makeFault("ContactSurface", "be 0 (Facets) or 1 (Smooth)", this->contactSurface);
  }
  if (!isWithin(this->frictionModel, 0, 2))
  {
    return makeFault(
      "FrictionModel", "be 0 (ElastoPlastic), 1 (Dahl) or 2 (ShapeDerived)", this->frictionModel);
  }
  if (!(this->frictionCoefficient >= 0.0) || !std::isfinite(this->frictionCoefficient))
  {
    return makeFault(
      "FrictionCoefficient", "be finite and not negative", this->frictionCoefficient);
  }
  if (!(this->tangentialStiffness > 0.0) || !std::isfinite(this->tangentialStiffness))
  {
    return makeFault(
      "TangentialStiffness", "be finite and positive (N/mm)", this->tangentialStiffness);
  }
  if (!isWithin(this->frictionBreakaway, 0.0, 1.0))
  {
    return makeFault("FrictionBreakaway", "lie between 0 and 1", this->frictionBreakaway);
  }
  const double radius = this->frictionStickRadius;
  if (!(radius > 0.0 && radius >= this->frictionBreakaway) || !std::isfinite(radius))
  {
    return makeFault(
      "FrictionStickRadius", "be finite, positive and no less than the breakaway", radius);
  }
  if (!isWithin(this->poissonRatio, 0.0, 0.5))
  {
    return makeFault("PoissonRatio", "lie between 0 and 0.5", this->poissonRatio);
  }
  return {};
}

ContactSettings GivenSettings::settings() const noexcept
{
  ContactSettings settings;
  settings.form = static_cast<ForceForm>(this->forceForm);
  settings.surface = static_cast<ContactSurface>(this->contactSurface);
  settings.friction.model = static_cast<FrictionModel>(this->frictionModel);
  settings.friction.coefficient = this->frictionCoefficient;
  settings.friction.tangentialStiffness = this->tangentialStiffness;
  settings.friction.breakaway = this->frictionBreakaway;
  settings.friction.stickRadius = this->frictionStickRadius;
  settings.friction.poissonRatio = this->poissonRatio;
  return settings;
}
} // namespace palpate
