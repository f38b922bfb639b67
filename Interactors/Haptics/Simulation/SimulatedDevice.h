// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SimulatedDevice_h
#define palpate_SimulatedDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Devices/SteeredAxis.h"
#include "Haptics/Guidance/TouchPlanner.h"
#include "Haptics/Simulation/SimulatedMotion.h"
#include "Haptics/Simulation/SimulatedPlant.h"
#include "Haptics/Devices/TimedPath.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/**
 * A device without hardware, of two kinds. In virtual time it is bit for bit deterministic: it
 * depends only on its settings, the times of the readings and the written forces. FaultyDevice adds
 * faults.
 *
 * A **stiff hand** follows a path in time, or steerTo (SteeredTarget), and ignores the force: the
 * sample depends only on the path or target and on the time.
 *
 * A **plant in a hand** has a mass, damping, friction, encoders and delays (SimulatedPlant). It is
 * connected to a spring and a damper (HandModel) whose target follows a path, or steerTo, so that
 * the plant moves under the force. It starts at the first reading, at rest at the hand's target and
 * without force. A written force acts from the time of the preceding reading, plus the force delay,
 * until the next force. The force is not limited to the specification (the safety chain does that).
 * Between the ticks the motion is integrated exactly, so that the time between two readings is
 * arbitrary. A time that does not increase repeats the last reading, not fresh. The reported
 * velocity is that of the mass or, with an encoder step, the difference of the last two readings
 * divided by their time.
 *
 * The device reports the tool's orientation if the way points of its path have an axis, or after
 * turnTo. Torques also turn a plant with an inertia; it begins with the hand's target orientation.
 *
 * If settings are out of range (`fault` of HeldPlant; a path that is not finite or whose times
 * decrease; a rate outside 0 to 100000 Hz), no sample is valid and status() returns the reason.
 * read and write of a plant are for one thread, steerTo for one other; none of them waits or
 * allocates. setBody and touch are for the thread of steerTo; they may allocate. A tick costs a
 * microsecond; with friction or a limited hand about ten per axis at an event (PlantAxis).
 */
class PALPATE_EXPORT SimulatedDevice final : public HapticDevice
{
public:
  using WayPoint = palpate::WayPoint;

  /// A stiff hand.
  explicit SimulatedDevice(
    std::vector<WayPoint> path, const DeviceSpecification& specification = {});
  /// A stiff hand that is steered, for example by a mouse.
  explicit SimulatedDevice(
    const Eigen::Vector3d& start, const DeviceSpecification& specification = {});
  /// A plant in a hand that follows a path (of a script or a file, or a single point at rest).
  SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand, std::vector<WayPoint> path,
    const DeviceSpecification& specification = {});
  /// A plant in a hand that is steered, for example by a mouse, or step by step by a script.
  SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand, const Eigen::Vector3d& start,
    const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// The sample is not valid for an empty path, for a target of a stiff hand that is not finite,
  /// and for a `time` that is not finite, except with a steered stiff hand.
  DeviceSample read(double time) noexcept override;
  /// A stiff hand accepts any force, finite or not. A plant rejects a force that is not finite, and
  /// then has no force.
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;
  std::string status() const override;

  /// Sets the target of a steered hand, m (SteeredTarget). No effect on a hand with a path. A hand
  /// does not move towards a target that is not finite.
  void steerTo(const Eigen::Vector3d& target) noexcept;

  /// Sets the axis (from tip to hand, not normalised, the device's frame) along which a steered
  /// hand holds the tool (SteeredAxis); zero: unknown, as at the start. No effect on a hand with a
  /// path, or if the axis is not finite.
  void turnTo(const Eigen::Vector3d& axis) noexcept;

  /// Sets the body that a steered hand touches, not null, and the mapping to its frame. The mapping
  /// must not change after the first reading. The device keeps the body while it is in use.
  void setBody(std::shared_ptr<const ContactBody> body, const WorkspaceMapping& mapping);
  /// Moves a steered hand around the body to `height` (mm, negative: pressed) above a point of its
  /// surface with an outward unit normal, in the body's frame: see GuidedHand. Before the first
  /// reading, the hand starts there, or at the free height if it presses. Takes 20 to some thousand
  /// searches of a closest point (TouchPlanner). No effect on a hand with a path, without a body,
  /// or if a number is not finite.
  void touch(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double height);

  const Eigen::Vector3d& lastForce() const noexcept { return this->Last.force; }
  const Eigen::Vector3d& lastTorque() const noexcept { return this->Last.torque; }
  /// Time of the last way point, s; 0 for an empty path or a steered hand.
  double duration() const noexcept { return this->Duration; }
  /// Position (m) and velocity (m/s) of a plant at its last measurement, not rounded to the
  /// encoder's step; zero for a stiff hand.
  Eigen::Vector3d truePosition() const noexcept;
  Eigen::Vector3d trueVelocity() const noexcept;

private:
  SteeredTarget* steered() noexcept;

  DeviceSpecification Limits;
  TimedPath Path;                          ///< path of a stiff hand
  std::unique_ptr<SteeredTarget> Target;   ///< target of a stiff hand without a path
  TouchPlanner Planner;                    ///< for the thread that steers
  SteeredAxis Shaft;                       ///< axis of a stiff hand without a path
  std::unique_ptr<SimulatedMotion> Motion; ///< null: a stiff hand
  double Duration = 0.0;
  Wrench Last;
};
} // namespace palpate

#endif
