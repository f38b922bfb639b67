// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SafetySettings_h
#define palpate_SafetySettings_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/SettingFault.h"

#include <limits>

namespace palpate
{
/// The limits of a force before it is sent to a hand (SafetyChain). Device frame, SI units. A
/// negative limit or NaN blocks all forces. An infinite limit blocks no force.
struct PALPATE_EXPORT SafetySettings
{
  /// Factor by which every force is multiplied, 0 to 1. Compared tools must have the same factor,
  /// so that the ratios of their forces are kept (DeviceFit).
  double forceFactor = 1.0;
  double maximumForce = 10.0;       ///< N
  double maximumStiffness = 1500.0; ///< N/m, of a spring sampled at `period`
  double maximumForceRate = std::numeric_limits<double>::infinity(); ///< N/s
  double maximumTorque = 0.0; ///< N m; if 0, no torque is sent and orientations are ignored
  double maximumTorsionalStiffness = 0.5; ///< N m/rad, of a torsion spring sampled at `period`
  double maximumTorqueRate = std::numeric_limits<double>::infinity(); ///< N m/s
  /// Longest time without a new reading, s, after which the device counts as lost.
  double sampleTimeOut = 0.02;
  /// Period of the ticks, s, > 0. maximumStiffness is valid for this period.
  double period = 1e-3;
  /// Largest sum of the delays of readings and forces, s, >= 0, from the device's specification.
  /// Passivity control takes up to 32 periods into account.
  double delay = 0.0;
  /// Time, s, over which the force of the first contact rises from zero. If 0, the force acts
  /// immediately.
  double entryRamp = 0.0;
  /// Whether the force is zero until the tip has been outside the body once.
  bool gate = true;
  bool capStiffness = true;
  bool controlPassivity = true;

  /// Settings with all links active and with the limits of the specification.
  static SafetySettings of(const DeviceSpecification& specification);
  /// Settings with only two active links: no force if it is not finite or the sample is not valid,
  /// and no force above `maximumForce` (N). No torque is sent.
  static SafetySettings magnitudeOnly(double maximumForce);
};

/// The fault of the first setting that is out of its range or NaN, with the setting's capitalised
/// name ("MaximumForce"). With faulty settings the chain is safe, but may send no force.
PALPATE_EXPORT SettingFault faultOf(const SafetySettings& settings);

/// The fault of a force factor. Its range is that of SafetySettings::forceFactor and
/// ServoScene::forceFactor.
PALPATE_EXPORT SettingFault faultOfForceFactor(double factor);
} // namespace palpate

#endif
