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
 * One step of a servo loop for several devices on one body: what ServoStep is for one. All are
 * read, their contacts are stepped together (CoupledContacts: on a body with coupling they feel one
 * another), and each force goes through a mapping, clutch and safety chain of its own.
 *
 * A device whose sample is not valid, that is silent or stopped loses its own contact alone: its
 * force is zero in the same tick, in which the others already feel it no more. A gap, which keeps
 * the contact of a ServoStep, forgets it here. A tool whose gate is shut, or whose hand the clutch
 * has taken off, is in the body, and the others feel it.
 *
 * The stiffness cap of each counts by how much contacts are stiffer together: no motion of all
 * hands, in or out, is stiffer than the device's limit. Where contacts feel one another the
 * passivity controls have one account: what one hand put in comes out at another when the first
 * lets go, so what no force needs goes in each tick to where the scene holds it. All hands together
 * get no more than they have put in and their devices' damping takes.
 *
 * Another scene is taken from no force: the forces of all hands go to nothing within 50 ms, and
 * come from the other scene within another 50.
 *
 * step() and all that is noexcept neither allocate, free, lock nor throw, and are for one thread.
 */
class PALPATE_EXPORT HandsStep
{
public:
  static constexpr std::size_t Most = 4;

  /// What ServoStep is told of its one device.
  struct Hand
  {
    WorkspaceMapping mapping;
    SafetySettings safety;
    std::uint32_t clutchButtons = 0;
  };

  /// `scene` is not null; where it is made for another number of hands it is made anew. 1 to Most
  /// hands: any beyond have no step.
  HandsStep(std::unique_ptr<ServoScene> scene, const std::vector<Hand>& hands);

  std::size_t count() const noexcept { return this->Ends.size(); }

  /// A sample for each hand; what each has is there until the next step. `time` as of ServoStep.
  const std::vector<Tick>& step(const DeviceSample* samples, double time) noexcept;
  const std::vector<Tick>& ticks() const noexcept { return this->Ticks; }

  void foresee() const noexcept { this->Current->together->foresee(); }
  void rehearse(double elapsed) const noexcept { this->Current->together->rehearse(elapsed); }

  /// False, and nothing happens but that it is retired, if it is made for another number of hands.
  bool change(std::unique_ptr<ServoScene> next) noexcept;
  bool isSwitching() const noexcept { return this->Waiting || this->Fade.share() < 1.0; }
  std::unique_ptr<ServoScene> takeRetired() noexcept { return std::move(this->Retired); }

  void stop() noexcept;
  void start() noexcept;
  /// One hand alone.
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
  /// J, as its own chain observes it.
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
  std::vector<ToolPose> Poses; ///< not finite of a hand that is not there
  std::vector<char> AtWork;    ///< whose gate is open, and whose force the tick before did not end
  std::vector<double> Wanted;  ///< J, of each account
  std::unique_ptr<ServoScene> Current;
  std::unique_ptr<ServoScene> Waiting; ///< null but until the forces have gone
  std::unique_ptr<ServoScene> Retired;
  ForceRamp Fade{ 1.0 };
  std::uint32_t Changes = 0;
  double LastTime; ///< NaN: none
};
} // namespace palpate

#endif
