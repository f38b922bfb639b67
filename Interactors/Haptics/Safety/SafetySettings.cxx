// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SafetySettings.h"

#include <cmath>

namespace palpate
{
SafetySettings SafetySettings::of(const DeviceSpecification& specification)
{
  SafetySettings settings;
  settings.maximumForce = specification.maximumForce;
  settings.maximumStiffness = specification.maximumStiffness;
  settings.maximumForceRate = specification.maximumForceRate;
  settings.maximumTorque = specification.outputsTorque ? specification.maximumTorque : 0.0;
  settings.maximumTorsionalStiffness = specification.maximumTorsionalStiffness;
  settings.maximumTorqueRate = specification.maximumTorqueRate;
  settings.sampleTimeOut = specification.sampleTimeOut;
  settings.period = 1.0 / specification.rate;
  settings.delay = specification.delay;
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

SettingFault faultOfForceFactor(double factor)
{
  if (!(factor > 0.0 && factor <= 1.0))
  {
    return SettingFault::must("ForceFactor", "be positive and at most 1", factor);
  }
  return {};
}

SettingFault faultOf(const SafetySettings& settings)
{
  if (SettingFault fault = faultOfForceFactor(settings.forceFactor))
  {
    return fault;
  }
  if (!(settings.maximumForce >= 0.0))
  {
    return SettingFault::must("MaximumForce", "not be negative (N)", settings.maximumForce);
  }
  if (!(settings.maximumStiffness > 0.0))
  {
    return SettingFault::must("MaximumStiffness", "be positive (N/m)", settings.maximumStiffness);
  }
  if (!(settings.maximumForceRate > 0.0))
  {
    return SettingFault::must("MaximumForceRate", "be positive (N/s)", settings.maximumForceRate);
  }
  if (!(settings.maximumTorque >= 0.0))
  {
    return SettingFault::must("MaximumTorque", "not be negative (N m)", settings.maximumTorque);
  }
  if (!(settings.maximumTorsionalStiffness > 0.0))
  {
    return SettingFault::must(
      "MaximumTorsionalStiffness", "be positive (N m/rad)", settings.maximumTorsionalStiffness);
  }
  if (!(settings.maximumTorqueRate > 0.0))
  {
    return SettingFault::must(
      "MaximumTorqueRate", "be positive (N m/s)", settings.maximumTorqueRate);
  }
  if (!(settings.sampleTimeOut > 0.0))
  {
    return SettingFault::must("SampleTimeOut", "be positive (s)", settings.sampleTimeOut);
  }
  if (!(settings.period > 0.0) || !std::isfinite(settings.period))
  {
    return SettingFault::must("Period", "be finite and positive (s)", settings.period);
  }
  if (!(settings.delay >= 0.0) || !std::isfinite(settings.delay))
  {
    return SettingFault::must("Delay", "be finite and not negative (s)", settings.delay);
  }
  if (!(settings.entryRamp >= 0.0) || !std::isfinite(settings.entryRamp))
  {
    return SettingFault::must("EntryRamp", "be finite and not negative (s)", settings.entryRamp);
  }
  return {};
}
} // namespace palpate
