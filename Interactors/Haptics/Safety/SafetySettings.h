// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SafetySettings_h
#define palpate_SafetySettings_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/SettingFault.h"

#include <limits>

namespace palpate
{
/// The limits of a force before it reaches a hand (SafetyChain). The device's frame, SI units. A
/// limit that is negative or NaN blocks everything, an infinite one nothing.
struct PALPATE_EXPORT SafetySettings
{
  /// Factor of every force, 0 to 1: the same for all tools that are compared, so that their ratios
  /// are kept (DeviceFit).
  double forceFactor = 1.0;
  double maximumForce = 10.0;       ///< N
  double maximumStiffness = 1500.0; ///< N/m, that a sampled spring may have at `period`
  double maximumForceRate = std::numeric_limits<double>::infinity(); ///< N/s
  double maximumTorque = 0.0; ///< N m; 0: no torque is sent, and orientations are ignored
  double maximumTorsionalStiffness = 0.5; ///< N m/rad, as maximumStiffness
  double maximumTorqueRate = std::numeric_limits<double>::infinity(); ///< N m/s
  /// s; a device without a new reading for longer is lost.
  double sampleTimeOut = 0.02;
  /// s, > 0: of the ticks that maximumStiffness was stated for.
  double period = 1e-3;
  /// s, >= 0: the largest sum of the delays of readings and forces, by the device's specification;
  /// used by passivity control, up to 32 periods.
  double delay = 0.0;
  /// s over which the force of the first contact rises from zero; 0: at once.
  double entryRamp = 0.0;
  /// No force until the tip has been outside once.
  bool gate = true;
  bool capStiffness = true;
  bool controlPassivity = true;

  /// All links, with the limits of the specification.
  static SafetySettings of(const DeviceSpecification& specification);
  /// Two links alone: no force that is not finite or for an invalid sample, and none above the
  /// maximum. No torque.
  static SafetySettings magnitudeOnly(double maximumForce);
};

/// The first setting out of its range, or NaN, by its capitalised name ("MaximumForce"); for
/// settings from outside. The chain itself is safe with any, but may send nothing.
PALPATE_EXPORT SettingFault faultOf(const SafetySettings& settings);

/// The range is that of SafetySettings::forceFactor and ServoScene::forceFactor.
PALPATE_EXPORT SettingFault faultOfForceFactor(double factor);
} // namespace palpate

#endif
