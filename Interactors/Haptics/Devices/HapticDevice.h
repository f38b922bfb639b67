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
/// A force and a torque about the tool's tip that act on the hand. The device's frame; N, N m.
struct Wrench
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();

  bool isFinite() const noexcept { return this->force.allFinite() && this->torque.allFinite(); }
  /// The wrench with each part limited to its maximum, N and N m. Both parts must be finite.
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

/// A device's specification by its manufacturer. SI units, the device's frame.
struct DeviceSpecification
{
  double maximumForce = 10.0; ///< N
  /// N/m: the largest stiffness of a spring sampled at the given rate that comes to rest with any
  /// hand or without a hand. It is b/T with the device's own damping b and the period T, or b/(T +
  /// 2t) if readings and forces are delayed by t together. Beyond 2b/T the spring generates energy;
  /// between b/T and 2b/T it oscillates for a long time (Testing/Studies/stability).
  double maximumStiffness = 1500.0;
  double maximumForceRate = std::numeric_limits<double>::infinity(); ///< N/s
  double maximumDamping = 10.0; ///< N s/m, of a sampled damper at the given rate
  Eigen::Vector3d workspace = Eigen::Vector3d::Constant(0.1); ///< half extents about 0, m
  double rate = 1000.0;                                       ///< Hz
  /// s: a device without a new reading for longer than this time counts as lost; infinite for a
  /// device that sends no readings while it is at rest.
  double sampleTimeOut = 0.02;
  /// s: the largest sum of the delays of readings and forces; 0: at most one tick.
  double delay = 0.0;
  bool outputsForce = true;

  bool outputsTorque = false;
  double maximumTorque = 0.0; ///< N m, about the tip; 0: the device outputs no torque
  /// N m/rad, defined for rotation as maximumStiffness is for translation: b_θ/T, or b_θ/(T + 2t),
  /// with the device's own rotational damping b_θ (N m s/rad).
  double maximumTorsionalStiffness = 0.5;
  double maximumTorqueRate = std::numeric_limits<double>::infinity(); ///< N m/s
};

/// One reading of a device, in the device's frame. SI units.
struct DeviceSample
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m
  /// In m/s; zero if the device does not measure it.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  std::uint32_t buttons = 0; ///< bit i: button i is pressed
  /// False if the device has no reading yet, is disconnected, or has failed: the force is then
  /// zero.
  bool valid = false;
  /// False if there is no new reading; the sample then repeats the last reading.
  bool fresh = true;

  ToolOrientation orientation = orientationNotTold(); ///< unit, or unknown
  /// rad/s; zero if the device does not measure it
  Eigen::Vector3d angularVelocity = Eigen::Vector3d::Zero();
};

/// Communication errors of a device since it was opened.
struct DeviceErrors
{
  std::uint64_t malformed = 0; ///< reports of wrong size, version, check sum or content
  std::uint64_t stale = 0;     ///< reports older than, or equal to, an earlier one
  std::uint64_t lost = 0;      ///< reports that were not received, according to the report numbers
  std::uint64_t unsent = 0;    ///< forces that could not be sent
  std::uint64_t disconnections = 0;
};

/**
 * A haptic device: it measures the hand and applies the force. SI units, the device's frame.
 *
 * read, write, writeWrench and holdFor are called from the servo tick: they return immediately, and
 * neither allocate, lock nor throw. The caller passes `time` (s), so that a session can run in
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
  /// Applies a force and a torque. A device without torque output applies only the force.
  virtual bool writeWrench(const Wrench& wrench) noexcept { return this->write(wrench.force); }
  /// Sets the time (s) for which the following forces are held if no other force follows. No effect
  /// on a device that cannot end its force itself.
  virtual void holdFor(double seconds) noexcept { static_cast<void>(seconds); }

  /// The state as readable text: "connected", "unplugged, waiting for it to return".
  virtual std::string status() const { return "connected"; }
  virtual DeviceErrors errors() const noexcept { return {}; }
};
} // namespace palpate

#endif
