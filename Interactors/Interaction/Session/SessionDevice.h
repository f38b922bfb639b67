// SPDX-License-Identifier: BSD-3-Clause
#ifndef SessionDevice_h
#define SessionDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Devices/Trajectory.h"
#include "Haptics/Simulation/SimulatedPlant.h"

#include <memory>
#include <string>

namespace palpate
{
/// The device of a session. Devices of some kinds are made only when the session starts.
struct SessionDevice
{
  enum Kind
  {
    Simulated,
    Plant,
    Replay,
    Opened,     ///< "hid" or "bridge": hardware or another program; only in real time
    OfTheCaller ///< passed by C++ code
  };

  Kind kind = Simulated;
  std::shared_ptr<HapticDevice> device; ///< null if the device is made at Start
  Trajectory trajectory;                ///< recorded trajectory, for the kind Replay
  HeldPlant held;                       ///< plant and hand, for the kind Plant

  /// Whether the motion of the device is independent of the force, so that a force has no effect on
  /// later forces.
  bool isStiff() const { return this->kind == Simulated || this->kind == Replay; }
  /// Whether the hand follows a path or is steered.
  bool isSimulated() const { return this->kind == Simulated || this->kind == Plant; }
  /// Returns the specification at the rate `rate`, Hz. The specification is known even before the
  /// device is made at Start.
  DeviceSpecification specification(double rate) const;
};

/// Reads "simulated", "plant", "plant:SETTINGS" (readPlant), "replay:FILE", "hid:PATH" or
/// "bridge:ADDRESS", and opens the device. Returns "" on success. Otherwise returns an error and
/// leaves `device` unchanged.
std::string openSessionDevice(const std::string& name, SessionDevice& device);
} // namespace palpate

#endif
