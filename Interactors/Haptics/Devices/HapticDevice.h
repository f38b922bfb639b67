// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HapticDevice_h
#define palpate_HapticDevice_h

#include "Haptics/Devices/ToolOrientation.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <string>

namespace palpate
{
/// A force (N) and a torque about the tool's tip (N m) that act on the hand. Device frame.
struct Wrench
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();

  bool isFinite() const noexcept { return this->force.allFinite() && this->torque.allFinite(); }
  /// Returns the wrench with the force shortened to at most `maximumForce` (N) and the torque to at
  /// most `maximumTorque` (N m). Both parts must be finite.
  Wrench within(double maximumForce, double maximumTorque) const noexcept
  {
    return { shortened(this->force, maximumForce), shortened(this->torque, maximumTorque) };
  }

private:
  static Eigen::Vector3d shortened(const Eigen::Vector3d& vector, double most) noexcept
  {
    const double size = vector.norm();
    return (size > most ? most / size : 1.0) * vector;
  }
};

/// A device's specification by its manufacturer, in SI units and the device frame.
struct DeviceSpecification
{
  double maximumForce = 10.0; ///< N
  /// Largest stiffness, N/m, of a spring sampled at `rate` that comes to rest with any hand or
  /// without a hand. It is b/T with the device's own damping b and the period T. If readings and
  /// forces are delayed by t in total, it is b/(T + 2t). Above 2b/T the spring generates energy;
  /// between b/T and 2b/T it oscillates for a long time (Testing/Studies/stability).
  double maximumStiffness = 1500.0;
  double maximumForceRate = std::numeric_limits<double>::infinity(); ///< N/s
  double maximumDamping = 10.0; ///< largest damping of a damper sampled at `rate`, N s/m
  /// Half extents of the workspace, centred at 0, m.
  Eigen::Vector3d workspace = Eigen::Vector3d::Constant(0.1);
  double rate = 1000.0; ///< Hz
  /// Longest time without a new reading, s, after which the device counts as lost. Infinite for a
  /// device that sends no readings while it is at rest.
  double sampleTimeOut = 0.02;
  /// Largest sum of the delays of readings and forces, s. At 0 the sum is at most one tick.
  double delay = 0.0;
  bool outputsForce = true;

  bool outputsTorque = false;
  /// Largest torque about the tip, N m; 0 if the device outputs no torque.
  double maximumTorque = 0.0;
  /// Largest stiffness for rotation, N m/rad, defined as maximumStiffness is for translation:
  /// b_θ/T, or b_θ/(T + 2t) with delays, where b_θ (N m s/rad) is the device's own rotational
  /// damping.
  double maximumTorsionalStiffness = 0.5;
  double maximumTorqueRate = std::numeric_limits<double>::infinity(); ///< N m/s
};

/// One reading of a device. SI units, device frame.
struct DeviceSample
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m
  /// Velocity, m/s; zero if the device does not measure it.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  std::uint32_t buttons = 0; ///< bit i is set while button i is pressed
  /// False if the device has no reading yet, is disconnected, or has failed. The force is then
  /// zero.
  bool valid = false;
  /// False if the sample repeats the last reading because there is no new one.
  bool fresh = true;

  ToolOrientation orientation = orientationNotTold(); ///< unit quaternion; all zero if unknown
  /// angular velocity, rad/s; zero if the device does not measure it
  Eigen::Vector3d angularVelocity = Eigen::Vector3d::Zero();
};

/// Communication errors of a device since it was opened.
struct DeviceErrors
{
  std::uint64_t malformed = 0; ///< reports of wrong size, version, checksum or content
  std::uint64_t stale = 0;     ///< reports whose number is not above that of an earlier report
  std::uint64_t lost = 0;      ///< reports that were not received, according to the report numbers
  std::uint64_t unsent = 0;    ///< forces that could not be sent
  std::uint64_t disconnections = 0;
};

/**
 * A haptic device: it measures the position of the hand and applies a force to it. SI units, device
 * frame.
 *
 * read, write, writeWrench and holdFor are called from the servo tick. They return immediately and
 * neither allocate, lock nor throw. The caller passes the time (s), so that a session can run in
 * virtual time. status and errors may be called from one other thread at the same time.
 */
class PALPATE_EXPORT HapticDevice
{
public:
  virtual ~HapticDevice() = default;
  /// The specification; it is constant while a servo loop runs.
  virtual const DeviceSpecification& specification() const noexcept = 0;
  virtual DeviceSample read(double time) noexcept = 0;
  /// Applies a force to the hand, N. Returns false if the device did not accept it.
  virtual bool write(const Eigen::Vector3d& force) noexcept = 0;
  /// Applies a force and a torque. A device without torque output ignores the torque.
  virtual bool writeWrench(const Wrench& wrench) noexcept { return this->write(wrench.force); }
  /// Sets the time (s) for which each following force is held if no other force is written after
  /// it. No effect on a device that cannot end its force by itself.
  virtual void holdFor(double seconds) noexcept { static_cast<void>(seconds); }

  /// The state of the connection as readable text: "connected", "unplugged, waiting for it to
  /// return".
  virtual std::string status() const { return "connected"; }
  virtual DeviceErrors errors() const noexcept { return {}; }
};
} // namespace palpate

#endif
