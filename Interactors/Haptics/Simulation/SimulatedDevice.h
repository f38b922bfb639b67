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
 * A simulated device, of one of two kinds. In virtual time it is bit for bit deterministic: the
 * samples depend only on the settings, the times of the readings and the written forces.
 * FaultyDevice adds faults.
 *
 * A **stiff hand** follows a path in time, or the target of steerTo (SteeredTarget), and ignores
 * the force.
 *
 * A **plant in a hand** has a mass, damping, friction, encoders and delays (SimulatedPlant). A
 * spring and a damper (HandModel) connect it to a target, which follows a path or is set by
 * steerTo. Therefore the plant moves under the force. At the first reading the plant is at rest at
 * the hand's target, without force. A written force acts from the time of the preceding reading,
 * plus the force delay, until the next force. The force is not limited to the specification,
 * because the safety chain limits it. Between the ticks the motion is integrated exactly, so that
 * the time between two readings is arbitrary. If the time does not increase, the last reading is
 * repeated and is not fresh. The reported velocity is that of the mass or, with an encoder step,
 * the difference of the last two readings divided by the time between them.
 *
 * The device reports the tool's orientation if the way points of its path have an axis, or after
 * turnTo. If the plant has an inertia, torques turn it; it begins with the hand's target
 * orientation.
 *
 * If a setting is out of its range, no sample is valid and status() returns the reason. The checks
 * cover the plant and the hand (`fault` of HeldPlant), the path (finite, with times that do not
 * decrease) and the rate (0 to 100000 Hz). One thread calls read and write of a plant, one other
 * thread calls steerTo; these functions neither wait nor allocate. setBody and touch are for the
 * thread that calls steerTo; they may allocate. A tick costs one microsecond. With friction or a
 * limited hand, an event costs about ten microseconds per axis (PlantAxis).
 */
class PALPATE_EXPORT SimulatedDevice final : public HapticDevice
{
public:
  using WayPoint = palpate::WayPoint;

  /// Makes a stiff hand that follows a path.
  explicit SimulatedDevice(
    std::vector<WayPoint> path, const DeviceSpecification& specification = {});
  /// Makes a stiff hand that is steered, for example by a mouse, and starts at `start` (m).
  explicit SimulatedDevice(
    const Eigen::Vector3d& start, const DeviceSpecification& specification = {});
  /// Makes a plant in a hand that follows a path, which may be a single point.
  SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand, std::vector<WayPoint> path,
    const DeviceSpecification& specification = {});
  /// Makes a plant in a hand that is steered, for example by a mouse or by a script, and starts at
  /// `start` (m).
  SimulatedDevice(const SimulatedPlant& plant, const HandModel& hand, const Eigen::Vector3d& start,
    const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// The sample is not valid if the path is empty, or if the target of a stiff hand is not finite.
  /// It is also not valid if `time` is not finite, unless the device is a stiff hand that is
  /// steered.
  DeviceSample read(double time) noexcept override;
  /// A stiff hand accepts any force, finite or not. A plant rejects a force that is not finite, and
  /// its force is then zero.
  bool write(const Eigen::Vector3d& force) noexcept override
  {
    return this->writeWrench({ force, Eigen::Vector3d::Zero() });
  }
  bool writeWrench(const Wrench& wrench) noexcept override;
  std::string status() const override;

  /// Sets the target of a steered hand, m (SteeredTarget). No effect on a hand with a path. The
  /// hand does not move while the target is not finite.
  void steerTo(const Eigen::Vector3d& target) noexcept;

  /// Sets the axis along which a steered hand holds the tool (SteeredAxis). The axis is in the
  /// device frame, from tip to hand, and need not be normalised. Zero means an unknown axis, as at
  /// the start. No effect on a hand with a path, or if the axis is not finite.
  void turnTo(const Eigen::Vector3d& axis) noexcept;

  /// Sets the body that a steered hand touches and the mapping to its frame. The body must not be
  /// null. The mapping must not change after the first reading. The device keeps the body while it
  /// is in use.
  void setBody(std::shared_ptr<const ContactBody> body, const WorkspaceMapping& mapping);
  /// Moves a steered hand around the body to a point on its surface (GuidedHand). `point` and
  /// `normal`, the outward unit normal, are in the body frame. `height` is the height of the tip
  /// above the point, mm; negative if the tip presses. Before the first reading the hand starts
  /// there, or at the free height if it presses. The call costs 20 to some thousand closest-point
  /// queries (TouchPlanner). No effect on a hand with a path, without a body, or if a number is not
  /// finite.
  void touch(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double height);

  const Eigen::Vector3d& lastForce() const noexcept { return this->Last.force; }
  const Eigen::Vector3d& lastTorque() const noexcept { return this->Last.torque; }
  /// Time of the last way point, s. It is 0 for an empty path or a steered hand.
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
  std::unique_ptr<SimulatedMotion> Motion; ///< null for a stiff hand
  double Duration = 0.0;
  Wrench Last;
};
} // namespace palpate

#endif
