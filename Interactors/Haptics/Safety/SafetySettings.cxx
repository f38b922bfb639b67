// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SafetySettings.h"

namespace palpate
{
SafetySettings SafetySettings::of(const DeviceSpecification& specification)
{
  SafetySettings settings;
  settings.maximumForce = specification.maximumForce;
  settings.maximumStiffness = specification.maximumStiffness;
  settings.maximumForceRate = specification.maximumForceRate;
  settings.sampleTimeOut = specification.sampleTimeOut;
  settings.period = 1.0 / specification.rate;
  return settings;
}

SafetySettings SafetySettings::magnitudeOnly(double maximumForce)
{
  SafetySettings settings;
  settings.maximumForce = maximumForce;
  settings.maximumStiffness = std::numeric_limits<double>::infinity();
  settings.sampleTimeOut = std::numeric_limits<double>::infinity();
  settings.gate = false;
  settings.capStiffness = false;
  settings.controlPassivity = false;
  return settings;
}
} // namespace palpate
