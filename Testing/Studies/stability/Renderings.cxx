// SPDX-License-Identifier: BSD-3-Clause
#include "Renderings.h"

#include <limits>

namespace palpate::testing
{
const char* nameOf(Control control)
{
  switch (control)
  {
    case Control::None:
      return "none";
    case Control::Cap:
      return "cap";
    case Control::Passivity:
      return "passivity";
    case Control::ChainAtLimit:
      return "chain at 2b/T";
    default:
      return "chain";
  }
}

SafetySettings safetyOf(Control control, const LoopSetting& setting)
{
  if (control == Control::None)
  {
    return SafetySettings::magnitudeOnly(std::numeric_limits<double>::infinity());
  }
  SafetySettings safety = SafetySettings::of(setting.specification());
  if (control != Control::Chain)
  {
    safety.maximumStiffness = setting.passiveStiffness();
    safety.delay = 0.0;
  }
  if (control == Control::Cap || control == Control::Passivity)
  {
    safety.maximumForce = std::numeric_limits<double>::infinity();
    safety.sampleTimeOut = std::numeric_limits<double>::infinity();
    safety.gate = false;
    safety.capStiffness = control == Control::Cap;
    safety.controlPassivity = control == Control::Passivity;
  }
  return safety;
}
} // namespace palpate::testing
