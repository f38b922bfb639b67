// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SafetySettings_h
#define palpate_SafetySettings_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/SettingFault.h"

#include <limits>

namespace palpate
{
/// The limits of a force before it is sent to a hand (SafetyChain). In the device's frame, SI
/// units. A limit that is negative or NaN blocks all forces, an infinite limit none.
struct PALPATE_EXPORT SafetySettings
{
  /// Factor of every force, 0 to 1. Use the same factor for all compared tools, so that the ratios
  /// of their forces are kept (DeviceFit).
  double forceFactor = 1.0;
  double maximumForce = 10.0;       ///< N
  double maximumStiffness = 1500.0; ///< N/m, of a sampled spring at `period`
  double maximumForceRate = std::numeric_limits<double>::infinity(); ///< N/s
  double maximumTorque = 0.0; ///< N m; 0: no torque is sent, and orientations are ignored
  double maximumTorsionalStiffness = 0.5; ///< N m/rad, as maximumStiffness
  double maximumTorqueRate = std::numeric_limits<double>::infinity(); ///< N m/s
  /// s: a device without a new reading for longer than this time is lost.
  double sampleTimeOut = 0.02;
  /// s, > 0: the period of the ticks for which maximumStiffness is valid.
  double period = 1e-3;
  /// s, >= 0: the largest sum of the delays of readings and forces, from the device's
  /// specification. Passivity control uses it, up to 32 periods.
  double delay = 0.0;
  /// s: time over which the force of the first contact rises from zero; 0: immediately.
  double entryRamp = 0.0;
  /// The force is zero until the tip has been outside the body once.
  bool gate = true;
  bool capStiffness = true;
  bool controlPassivity = true;

  /// All links, with the limits of the specification.
  static SafetySettings of(const DeviceSpecification& specification);
  /// Only two links: no force if it is not finite or the sample is not valid, and no force above
  /// the maximum. No torque.
  static SafetySettings magnitudeOnly(double maximumForce);
};

/// The fault of the first setting that is out of its range or NaN, with the setting's capitalised
/// name ("MaximumForce"). The chain is safe with any settings, but may send no force.
PALPATE_EXPORT SettingFault faultOf(const SafetySettings& settings);

/// The fault of a force factor; its range is that of SafetySettings::forceFactor and
/// ServoScene::forceFactor.
PALPATE_EXPORT SettingFault faultOfForceFactor(double factor);
} // namespace palpate

#endif
