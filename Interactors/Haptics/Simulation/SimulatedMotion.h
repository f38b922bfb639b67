// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SimulatedMotion_h
#define palpate_SimulatedMotion_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Simulation/PlantAxis.h"
#include "Haptics/Devices/SteeredAxis.h"
#include "Haptics/Devices/SteeredTarget.h"
#include "Haptics/Devices/TimedPath.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/**
 * The motion of a simulated device with a mass. The class receives forces, advances to the time of
 * the next reading, and measures position and velocity as encoders do.
 *
 * The motion is divided into intervals at each change of the force or of the target's velocity;
 * PlantAxis computes each interval. At the first reading the plant is at rest at the hand's target.
 * With a sample delay, the whole plant is computed for an earlier time, so that only delayed forces
 * must be stored. read and write are for one thread and do not allocate.
 */
class PALPATE_EXPORT SimulatedMotion
{
public:
  /// The hand follows `path`. If the path is empty, the hand is steered and starts at `start` (m).
  /// `rate` is the expected rate of the ticks, Hz.
  SimulatedMotion(const SimulatedPlant& plant, const HandModel& hand, TimedPath path,
    const Eigen::Vector3d& start, double rate);

  DeviceSample read(double time) noexcept;
  bool write(const Wrench& wrench) noexcept;
  /// The target of the hand, which one other thread may set. Null if the hand follows a path.
  SteeredTarget* steered() noexcept { return this->Steered.get(); }
  /// Sets the axis towards which a steered hand turns the tool; see SteeredAxis. For the thread
  /// that steers. No effect on a hand that follows a path.
  void turnTo(const Eigen::Vector3d& axis) noexcept;

  /// Position and velocity of the mass at the last measurement, not rounded to the encoder's step;
  /// m, m/s.
  Eigen::Vector3d position() const noexcept;
  Eigen::Vector3d velocity() const noexcept;
  /// The rotation vector of a plant with inertia, rad; zero while the orientation is unknown.
  Eigen::Vector3d rotation() const noexcept;
  /// The fault of the settings, or "" if there is none.
  const std::string& fault() const noexcept { return this->Fault; }

private:
  struct TimedForce
  {
    double start = 0.0;
    Wrench wrench;
  };

  void begin(double time) noexcept;
  void advanceTo(double time) noexcept;
  /// Lets the forces act whose delay has elapsed.
  void hold() noexcept;
  DeviceSample measure(double time) const noexcept;
  /// The hand's target orientation at `time` (s).
  ToolOrientation targetOrientation(double time) const noexcept;
  void beginTurn(const Eigen::Vector3d& rotation) noexcept;
  void turn(const Eigen::Vector3d& target, const Eigen::Vector3d& rate, double duration) noexcept;
  bool turns() const noexcept { return this->Plant.inertia > 0.0; }

  SimulatedPlant Plant;
  PlantAxis Axis;
  PlantAxis TurningAxis; ///< equations of motion for angles and torques
  TimedPath Path;
  std::unique_ptr<SteeredTarget> Steered; ///< null if the hand follows the path
  SteeredAxis SteeredShaft;
  std::string Fault;

  double Clock = std::numeric_limits<double>::quiet_NaN(); ///< time of the plant, s
  double LastTime = -std::numeric_limits<double>::infinity();
  DeviceSample Last;
  PlantAxis::State States[3];
  PlantAxis::State Turns[3]; ///< components of the rotation vector, rad
  bool IsTurned = false;     ///< whether the orientation is known
  Wrench Held;               ///< the force and torque that act now

  /// A ring buffer of the delayed forces.
  std::vector<TimedForce> Pending;
  std::size_t First = 0;
  std::size_t Count = 0;
};
} // namespace palpate

#endif
