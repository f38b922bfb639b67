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
 * The inside of a simulated device with a mass: takes forces, moves on to the time of the next
 * reading, and reports as encoders do.
 *
 * It moves from one change of force, or of the target's velocity, to the next, each stretch by
 * PlantAxis. It starts at rest where the hand means to be at the first reading. A late reading
 * means a plant that runs behind by the sample delay: nothing is remembered but forces on their
 * way. read and write are for one thread, and allocate nothing.
 */
class PALPATE_EXPORT SimulatedMotion
{
public:
  /// The hand follows `path`; on an empty one it is steered, from `start`.
  SimulatedMotion(const SimulatedPlant& plant, const HandModel& hand, TimedPath path,
    const Eigen::Vector3d& start, double rate);

  DeviceSample read(double time) noexcept;
  bool write(const Wrench& wrench) noexcept;
  /// From one other thread; without effect on a hand that follows a path.
  void steerTo(const Eigen::Vector3d& target) noexcept;
  void turnTo(const Eigen::Vector3d& axis) noexcept;

  /// Of the mass, when the last reading was measured, without the encoder's step; m, m/s.
  Eigen::Vector3d position() const noexcept;
  Eigen::Vector3d velocity() const noexcept;
  /// The rotation vector of a plant that turns, rad; zero before it is told how it is held.
  Eigen::Vector3d rotation() const noexcept;
  /// What is wrong with the settings, or "".
  const std::string& fault() const noexcept { return this->Fault; }

private:
  struct TimedForce
  {
    double start = 0.0;
    Wrench wrench;
  };

  void begin(double time) noexcept;
  void advanceTo(double time) noexcept;
  /// Takes over the forces that have arrived.
  void hold() noexcept;
  DeviceSample measure(double time) const noexcept;
  /// Which way the hand means to hold the tool at a time.
  ToolOrientation meant(double time) const noexcept;
  void beginTurn(const Eigen::Vector3d& rotation) noexcept;
  void turn(const Eigen::Vector3d& meant, const Eigen::Vector3d& rate, double duration) noexcept;
  bool turns() const noexcept { return this->Plant.inertia > 0.0; }

  SimulatedPlant Plant;
  PlantAxis Axis;
  PlantAxis TurningAxis; ///< of angles and torques
  TimedPath Path;
  std::unique_ptr<SteeredTarget> Steered; ///< null: the hand follows the path
  SteeredAxis SteeredShaft;
  std::string Fault;

  double Clock = std::numeric_limits<double>::quiet_NaN(); ///< the plant's time, s
  double LastTime = -std::numeric_limits<double>::infinity();
  DeviceSample Last;
  PlantAxis::State States[3];
  PlantAxis::State Turns[3]; ///< of the rotation vector, rad
  bool IsTurned = false;     ///< somebody has told how it is held
  Wrench Held;               ///< what acts now

  /// A ring of the forces on their way.
  std::vector<TimedForce> Pending;
  std::size_t First = 0;
  std::size_t Count = 0;
};
} // namespace palpate

#endif
