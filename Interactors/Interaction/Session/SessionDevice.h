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
/// The device of a session, as far as it can be made before the session starts.
struct SessionDevice
{
  enum Kind
  {
    Simulated,
    Plant,
    Replay,
    Opened,     ///< "hid", "bridge": hardware or another program, only in real time
    OfTheCaller ///< given by C++
  };

  Kind kind = Simulated;
  std::shared_ptr<HapticDevice> device; ///< null if it is made at Start
  Trajectory trajectory;                ///< for Replay
  HeldPlant held;                       ///< for Plant

  /// True if the motion of the device does not depend on the force, so that no loop is closed
  /// through it.
  bool isStiff() const { return this->kind == Simulated || this->kind == Replay; }
  /// True for a hand that follows a path or is steered.
  bool isSimulated() const { return this->kind == Simulated || this->kind == Plant; }
  /// Specification at `rate`, Hz. Also valid for a device that is made at Start.
  DeviceSpecification specification(double rate) const;
};

/// Reads "simulated", "plant", "plant:SETTINGS" (readPlant), "replay:FILE", "hid:PATH" or
/// "bridge:ADDRESS", and opens the device. Returns "" or an error, which leaves `device` unchanged.
std::string openSessionDevice(const std::string& name, SessionDevice& device);
} // namespace palpate

#endif
