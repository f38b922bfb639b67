// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HandsStep_h
#define palpate_HandsStep_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/DeviceEnd.h"
#include "Haptics/Servo/SceneSwitch.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/**
 * One step of a servo loop for several devices on one body; ServoStep is for one device. All
 * devices are read and their contacts are stepped together (CoupledContacts: on a body with
 * coupling each contact lowers the surface under the others). Each force passes a separate mapping,
 * clutch and safety chain.
 *
 * If the sample of a device is not valid, or its watchdog has expired or it is stopped, only its
 * own contact ends: its force is zero in the same tick, and the contact has no effect on the others
 * in that tick. A gap of the readings ends the contact, unlike in ServoStep. A tool whose gate is
 * closed, or whose hand is decoupled by the clutch, is still in the body and affects the others.
 *
 * The stiffness cap of each device takes into account how much stiffer all contacts are together:
 * no motion of all hands, in or out, is stiffer than the device's limit. On a body with coupling
 * the passivity controls share one account of energy, because the energy that one hand has put in
 * is returned to another hand when the first one unloads. In each tick, the energy that no force
 * needs is transferred to the hands at which the scene stores it. All hands together receive no
 * more than they have put in, plus the energy that the damping of their devices dissipates.
 *
 * During a change of the scene the force passes through zero: the forces of all hands fade to zero
 * within 50 ms, then rise to those of the new scene within another 50 ms.
 *
 * step() and all other noexcept functions neither allocate, free, lock nor throw. All functions are
 * for one thread.
 */
class PALPATE_EXPORT HandsStep
{
public:
  static constexpr std::size_t Most = 4;

  /// The parameters of one device, as in ServoStep.
  struct Hand
  {
    WorkspaceMapping mapping;
    SafetySettings safety;
    std::uint32_t clutchButtons = 0;
  };

  /// `scene` must not be null; if it is made for another number of hands, it is made again. 1 to
  /// Most hands; further hands are ignored.
  HandsStep(std::unique_ptr<ServoScene> scene, const std::vector<Hand>& hands);

  std::size_t count() const noexcept { return this->Ends.size(); }

  /// Makes a step with one sample per hand. Returns one tick per hand, valid until the next step.
  /// `time` as in ServoStep.
  const std::vector<Tick>& step(const DeviceSample* samples, double time) noexcept;
  const std::vector<Tick>& ticks() const noexcept { return this->Ticks; }

  void foresee() const noexcept { this->Current->together->foresee(); }
  void rehearse(double elapsed) const noexcept { this->Current->together->rehearse(elapsed); }

  /// Changes to another scene. Returns false for null, or if the scene is made for another number
  /// of hands; such a scene is only returned by takeRetired().
  bool change(std::unique_ptr<ServoScene> next) noexcept;
  bool isSwitching() const noexcept { return this->Waiting || this->Fade.share() < 1.0; }
  std::unique_ptr<ServoScene> takeRetired() noexcept { return std::move(this->Retired); }

  void stop() noexcept;
  void start() noexcept;
  /// Stops only one hand.
  void stop(std::size_t hand) noexcept;
  void start(std::size_t hand) noexcept { this->Ends[hand].start(); }
  void reset() noexcept;

  const WorkspaceMapping& mapping(std::size_t hand) const noexcept
  {
    return this->Ends[hand].mapping();
  }
  const SafetySettings& safety(std::size_t hand) const noexcept
  {
    return this->Ends[hand].safety();
  }
  /// J, as observed by the hand's safety chain.
  double energy(std::size_t hand) const noexcept { return this->Ends[hand].energy(); }

private:
  void take() noexcept;
  void retire(std::unique_ptr<ServoScene> scene) noexcept;
  void read(const DeviceSample* samples, double time, double elapsed) noexcept;
  SceneForce feel(std::size_t hand, const Contact& contact) noexcept;
  void feelAll(double elapsed) noexcept;
  void shareEnergy() noexcept;

  std::vector<DeviceEnd> Ends;
  std::vector<Tick> Ticks;
  std::vector<SafetyInput> Inputs;
  std::vector<ToolPose> Poses; ///< not finite for a hand without a tip, or with an ended force
  /// Hands whose gate is open and whose force did not end in the last tick.
  std::vector<char> AtWork;
  std::vector<double> Wanted; ///< J, the missing energy of each account
  std::unique_ptr<ServoScene> Current;
  std::unique_ptr<ServoScene> Waiting; ///< null except while the forces fade out
  std::unique_ptr<ServoScene> Retired;
  ForceRamp Fade{ 1.0 };
  std::uint32_t Changes = 0;
  double LastTime; ///< NaN: there was no step yet
};
} // namespace palpate

#endif
