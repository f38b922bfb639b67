// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DeviceEnd_h
#define palpate_DeviceEnd_h

#include "Haptics/Devices/Clutch.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Haptics/Devices/WorkspaceMapping.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Safety/SafetyChain.h"
#include "Haptics/Servo/SceneSwitch.h"
#include "Haptics/Servo/Tick.h"
#include "Contact/ToolPose.h"

#include <cstdint>

namespace palpate
{
/**
 * What of a servo step belongs to one device: mapping, clutch and safety chain. A tick reads the
 * sample, follows the tip, is told what that feels, and sends; whoever steps the contact does that
 * in between. A tip that is not felt, since the sample is not valid, is neither followed nor told.
 *
 * Nothing here allocates, locks or throws; for one thread.
 */
class PALPATE_EXPORT DeviceEnd
{
public:
  /// As ServoStep.
  DeviceEnd(const WorkspaceMapping& mapping, const SafetySettings& safety,
    std::uint32_t clutchButtons) noexcept;

  /// Begins a tick; tick.valid says whether there is a tip.
  void read(const DeviceSample& sample, double time, Tick& tick, SafetyInput& input) noexcept;
  /// Where the tool is, `elapsed` s after the last tick.
  ToolPose follow(double elapsed, Tick& tick) noexcept;
  /// What it feels there.
  void feel(const SceneForce& felt, Tick& tick, SafetyInput& input) noexcept;
  /// Ends a tick. True: the force was ended, not changed; the contact is to be forgotten.
  bool send(const SafetyInput& input, Tick& tick) noexcept;

  /// Whether a sample at that time has no force, whatever is felt (SafetyChain::isEnded).
  bool isEnded(double time) const noexcept { return this->Chain.isEnded(time); }

  void stop() noexcept { this->Chain.stop(); }
  void start() noexcept { this->Chain.start(); }
  void reset() noexcept;

  const WorkspaceMapping& mapping() const noexcept { return this->Mapping; }
  const SafetySettings& safety() const noexcept { return this->Safety; }
  /// For a scene of factor 1.
  const StiffnessLimits& limits() const noexcept { return this->Limits; }
  double energy() const noexcept { return this->Chain.energy(); }
  double spareEnergy() const noexcept { return this->Chain.spareEnergy(); }
  void transferEnergy(double energy) noexcept { this->Chain.transferEnergy(energy); }

private:
  WorkspaceMapping Mapping;
  SafetyChain Chain;
  SafetySettings Safety;
  Clutch Hand;
  StiffnessLimits Limits;
  bool IsSound;      ///< the mapping
  double Held = 1.0; ///< of the force, for the hand, before this tick
};
} // namespace palpate

#endif
