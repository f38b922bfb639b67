// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SimulatedDevice_h
#define palpate_SimulatedDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Devices/SteeredAxis.h"
#include "Haptics/Simulation/SimulatedMotion.h"
#include "Haptics/Simulation/SimulatedPlant.h"
#include "Haptics/Devices/TimedPath.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/**
 * A device without hardware, in one of two kinds. Deterministic to the bit in virtual time: nothing
 * counts but what it was made of, the times read and the forces written. FaultyDevice adds faults.
 *
 * A **stiff hand** follows a path in time, or steerTo (SteeredTarget), whatever it feels: the
 * sample depends on these and the time alone.
 *
 * A **plant in a hand** has a mass, damping, friction, encoders and delays (SimulatedPlant), and is
 * held by a spring and a damper (HandModel) that follow a path, or steerTo: it gives way to the
 * force. It starts at rest where the hand means to be at the first reading, with no force. A force
 * written acts from the time of the reading before it, plus the force delay, until the next one; it
 * is not limited to the specification (the safety chain does that). Between the ticks the motion is
 * integrated exactly: the time between two readings may be anything. A time that does not increase
 * gives the last reading again, not fresh. The velocity told is the mass's own, or, with an encoder
 * step, the difference of the last two readings.
 *
 * It tells how the tool is turned where the way points of its path have an axis, or where turnTo
 * has told one. A plant with an inertia is turned by torques, too; it begins as the hand means to
 * hold it.
 *
 * Settings out of range (`fault` of HeldPlant; a path that is not finite or goes
 * back in time; a rate that is not of 0 to 100000 Hz): no sample is valid and status() says why.
 * Read and write a plant from one thread, steerTo from one other; none waits or allocates. A tick
 * costs a microsecond; with friction or a limited hand some ten per axis when something stops,
 * lets go or reaches its limit.
 */
class PALPATE_EXPORT SimulatedDevice final : public HapticDevice
{
public:
  using WayPoint = palpate::WayPoint;

  /// A stiff hand.
  explicit SimulatedDevice(
    std::vector<WayPoint> path, const DeviceSpecification& specification = {});
  /// A stiff hand that is steered, as by a mouse.
  explicit SimulatedDevice(
    const Eigen::Vector3d& start, const DeviceSpecification& specification = {});
  /// A plant in a hand that follows a path (of a script or a file, or a single place to rest).
  SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand, std::vector<WayPoint> path,
    const DeviceSpecification& specification = {});
  /// A plant in a hand that is steered, as by a mouse or step by step from a script.
  SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand, const Eigen::Vector3d& start,
    const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// Not valid while `time` or the target is not finite, or a stiff hand's path is empty.
  DeviceSample read(double time) noexcept override;
  /// Finite or not, a stiff hand takes any force; a plant refuses one that is not finite, and feels
  /// none then.
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;
  std::string status() const override;

  /// Where a steered hand is to go, m (SteeredTarget); without effect on one with a path, or where
  /// it is not finite.
  void steerTo(const Eigen::Vector3d& target) noexcept;

  /// Along which axis (from tip to hand, any length, the device's frame) a steered hand is to hold
  /// the tool (SteeredAxis); zero: not told, as at first. Without effect on one with a path, or
  /// where it is not finite.
  void turnTo(const Eigen::Vector3d& axis) noexcept;

  const Eigen::Vector3d& lastForce() const noexcept { return this->Last.force; }
  const Eigen::Vector3d& lastTorque() const noexcept { return this->Last.torque; }
  /// Time of the last way point, s; 0 for an empty path or a steered hand.
  double duration() const noexcept { return this->Duration; }
  /// Position (m) and velocity (m/s) of a plant when its last reading was measured, without the
  /// encoder's step; zero for a stiff hand.
  Eigen::Vector3d truePosition() const noexcept;
  Eigen::Vector3d trueVelocity() const noexcept;

private:
  DeviceSpecification Limits;
  TimedPath Path;                          ///< of a stiff hand
  std::unique_ptr<SteeredTarget> Target;   ///< of a stiff hand without a path
  SteeredAxis Shaft;                       ///< likewise
  std::unique_ptr<SimulatedMotion> Motion; ///< null: a stiff hand
  double Duration = 0.0;
  Wrench Last;
};
} // namespace palpate

#endif
