// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoStep_h
#define palpate_ServoStep_h

#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/DeviceEnd.h"
#include "Haptics/Servo/SceneSwitch.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace palpate
{
/**
 * One step of the servo loop, as a function of the device samples and the time. The order is device
 * sample → mapping and clutch → contact (SceneSwitch) → safety chain → force on the device. The
 * class is used by ServoLoop or by a loop of the caller, with one device or with several devices on
 * one body.
 *
 * Body, tool, material and settings may change while tips are in contact: change() passes another
 * scene, and the force on each hand changes to that of the new scene within 50 ms.
 *
 * If a device reports the orientation of the tool, the contact is that of a tool along this axis.
 * There is then a torque, which is sent to a device that outputs torque. A sample whose orientation
 * is not finite is invalid. If the orientation is unknown, the tool is along the body's normal, and
 * the results are bit for bit those of versions without tilt. The clutch stops the tip, not the
 * axis: a decoupled hand still turns the tool.
 *
 * The force on a hand is exactly zero, in the same tick, if its sample is not valid or not finite,
 * if the force is not finite, if the device has sent no reading for longer than its time-out, and
 * while the hand is stopped. The contacts of the hand then end. If the forces of all hands have
 * ended, a ramp ends too. The contacts are kept if readings are missing for no longer than the
 * device's time-out, see SafetyChain.
 *
 * **Several devices.** All devices are read and their contacts are computed together
 * (CoupledContacts: on a body with coupling, each contact lowers the surface under the other
 * contacts). Each force passes a separate mapping, clutch and safety chain. A hand without a
 * sample, or with an ended force, does not affect the other hands in that tick. A tool with a
 * closed gate, or with a hand that is decoupled by the clutch, is still in the body and affects the
 * other hands.
 *
 * The stiffness cap of each device takes the joint stiffness of all contacts into account: no
 * motion of all hands, in or out, is stiffer than the device's limit. On a body with coupling the
 * passivity controls share one account of energy, because the energy that one hand has put in is
 * returned to another hand when the first one unloads. In each tick, the energy that no force needs
 * is transferred to the hands where the scene stores energy. All hands together receive no more
 * than they have put in, plus the energy that the damping of their devices dissipates.
 *
 * step() and all other noexcept functions neither allocate, free, lock nor throw. All functions are
 * for one thread. Hands are numbered from 0.
 */
class PALPATE_EXPORT ServoStep
{
public:
  static constexpr std::size_t Most = ServoScene::MostHands;

  /// One device. If the mapping has a fault(), every sample is invalid. The clutch is held while
  /// any of the bits `clutchButtons` is set in DeviceSample::buttons.
  struct Hand
  {
    WorkspaceMapping mapping;
    SafetySettings safety;
    std::uint32_t clutchButtons = 0;
  };

  /// Uses only two links of the safety chain, finiteness and magnitude
  /// (SafetySettings::magnitudeOnly). `maximumForce` is in N; if it is negative or NaN, no force is
  /// sent. The body must outlive the step.
  ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
    const ContactSettings& settings = {});
  /// `scene` must not be null.
  ServoStep(std::unique_ptr<ServoScene> scene, const WorkspaceMapping& mapping,
    const SafetySettings& safety, std::uint32_t clutchButtons = 0);
  /// `hands` has 1 to Most elements; further elements are ignored. If `scene` is made for another
  /// number of hands, it is replaced by a new scene for this number.
  ServoStep(std::unique_ptr<ServoScene> scene, const std::vector<Hand>& hands);

  std::size_t count() const noexcept { return this->Devices.size(); }

  /// Computes a step of the only device. `time` (s) must increase, because ramps and the safety
  /// chain depend on it.
  Tick step(const DeviceSample& sample, double time) noexcept;
  /// Computes a step of all devices. `samples` and `ticks` have count() elements.
  void step(const DeviceSample* samples, double time, Tick* ticks) noexcept;

  /// Prefetches the memory that the next step reads if the hands continue their motion. Optional;
  /// to be called after the forces are sent and before the loop waits. The results of steps do not
  /// change.
  void foresee() const noexcept { this->Scenes.foresee(); }
  /// Returns the result of step() for a likely sample; during a ramp, the result of the new scene
  /// alone. It uses copies of contacts, clutches and safety chains, and thereby loads the data and
  /// code of a step into the caches. Optional; to be called shortly before the next sample is read.
  /// The results of steps do not change. The cost is that of a step.
  Tick rehearse(const DeviceSample& likely, double time) noexcept;
  void rehearse(const DeviceSample* likely, double time, Tick* ticks) noexcept;

  /// Changes to another scene (SceneSwitch). Returns false if the scene is null or is made for
  /// another number of hands. A scene for another number of hands is only handed back by
  /// takeRetired().
  bool change(std::unique_ptr<ServoScene> next) noexcept
  {
    return this->Scenes.change(std::move(next));
  }
  /// Whether a ramp to another scene is active or about to begin.
  bool isSwitching() const noexcept { return this->Scenes.isSwitching(); }
  /// The scenes that are no longer needed, as a list (ServoScene::next), or null. They must be
  /// freed outside the tick. Scenes that are not taken are freed by the destructor of the step.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return this->Scenes.takeRetired(); }

  /// Ends the forces of all hands from the next step until start().
  void stop() noexcept;
  void start() noexcept;
  /// Ends the force of one hand from the next step until start() is called for this hand.
  void stop(std::size_t hand) noexcept;
  void start(std::size_t hand) noexcept { this->Devices[hand].end.start(); }
  /// Resets contacts, ramp, clutches and the history of the safety chains. A stopped hand remains
  /// stopped.
  void reset() noexcept;

  const WorkspaceMapping& mapping(std::size_t hand = 0) const noexcept
  {
    return this->Devices[hand].end.mapping();
  }
  /// The safety settings that were given to the constructor. The force factor of the scene applies
  /// in addition.
  const SafetySettings& safety(std::size_t hand = 0) const noexcept
  {
    return this->Devices[hand].end.safety();
  }
  /// The energy that the hand has put in and not received back, J, as observed by the safety chain.
  double energy(std::size_t hand = 0) const noexcept { return this->Devices[hand].end.energy(); }

private:
  /// A device and its part of the present tick.
  struct Device
  {
    DeviceEnd end;
    SafetyInput input;
    bool isOver = false; ///< whether the force has ended
    /// Whether the gate was open and the force had not ended in the last tick.
    bool isAtWork = false;
    bool sharesEnergy = false;
    double wanted = 0.0; ///< energy that the account of this device lacks, J
  };

  /// Computes ticks for the devices, which are Devices or Rehearsed. Returns the number of hands
  /// whose force has ended.
  std::size_t makeTicks(std::vector<Device>& devices, const DeviceSample* samples, double time,
    double elapsed, Tick* ticks) noexcept;
  static void shareEnergy(std::vector<Device>& devices) noexcept;
  /// Computes a step. The ticks must have their default values before the call.
  void makeStep(const DeviceSample* samples, double time, Tick* ticks) noexcept;
  void makeRehearsal(const DeviceSample* likely, double time, Tick* ticks) noexcept;
  /// Time since the last step, s; 0 if the time does not increase.
  double since(double time) const noexcept
  {
    return time > this->LastTime ? time - this->LastTime : 0.0;
  }

  std::vector<Device> Devices;
  std::vector<Device> Rehearsed;              ///< copies of Devices for rehearsals
  std::vector<std::optional<ToolPose>> Poses; ///< poses of the present tick
  SceneSwitch Scenes;
  double LastTime; ///< time of the last step; NaN before the first step
};
} // namespace palpate

#endif
