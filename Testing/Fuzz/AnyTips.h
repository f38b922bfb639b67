// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_AnyTips_h
#define palpate_testing_AnyTips_h

#include "Contact/ContactBody.h"
#include "Require.h"
#include "Contact/ToolContact.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace palpate::testing
{
/// Makes a number from arbitrary bits, including infinities and NaN. ConsumeFloatingPoint gives
/// only finite numbers.
template <class Number, class Bits>
Number anyBits(FuzzedDataProvider& input)
{
  static_assert(sizeof(Number) == sizeof(Bits));
  const auto bits = input.ConsumeIntegral<Bits>();
  Number number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

/// Makes a coordinate of a tip: usually within the size of a body, sometimes from 64 arbitrary
/// bits.
inline double anyNumber(FuzzedDataProvider& input)
{
  return input.ConsumeIntegralInRange<int>(0, 15) > 0
    ? 0.125 * input.ConsumeIntegralInRange<int>(-64, 64)
    : anyBits<double, std::uint64_t>(input);
}

/// Moves tips through a body, with every force form, surface and friction. Each contact must be
/// finite and have a triangle of the input, or there is no contact.
inline void feelAround(const ContactBody& body, std::size_t triangles, FuzzedDataProvider& input)
{
  ContactSettings settings;
  settings.form = input.PickValueInArray(
    { ForceForm::Paper, ForceForm::NormalizedDirection, ForceForm::EnergyConsistent });
  settings.surface = input.PickValueInArray({ ContactSurface::Facets, ContactSurface::Smooth });
  settings.friction.model = input.PickValueInArray(
    { FrictionModel::ElastoPlastic, FrictionModel::Dahl, FrictionModel::ShapeDerived });
  settings.friction.coefficient = input.ConsumeBool() ? 0.5 : 0.0;
  ToolContact contact(body, settings);
  for (int tick = 0; tick < 16 && input.remaining_bytes() > 0; ++tick)
  {
    const Vector3 tip(anyNumber(input), anyNumber(input), anyNumber(input));
    const Contact felt = contact.update(tip);
    require(felt.force.allFinite() && felt.friction.allFinite() && std::isfinite(felt.normalForce),
      "a force is finite");
    require(felt.triangle >= -1 && felt.triangle < static_cast<std::int64_t>(triangles),
      "a contact is on a triangle of the input");
    const bool touches = felt.state == ContactState::Stick || felt.state == ContactState::Slide ||
      felt.state == ContactState::BeyondRange;
    require(touches || felt.state == ContactState::LostAtBorder || felt.force.isZero(0.0),
      "what does not touch feels nothing");
    require(!touches || tip.allFinite(), "a tip that is nowhere touches nothing");
  }
}
} // namespace palpate::testing

#endif
