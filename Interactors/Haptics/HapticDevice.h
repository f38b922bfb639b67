// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HapticDevice_h
#define palpate_HapticDevice_h

#include <Eigen/Core>

namespace palpate
{
/// What a maker states about a device. SI units.
struct DeviceSpecification
{
  double maximumForce = 10.0;                                 ///< N
  double maximumStiffness = 3000.0;                           ///< N/m
  Eigen::Vector3d workspace = Eigen::Vector3d::Constant(0.1); ///< half extents, m
  double rate = 1000.0;                                       ///< Hz
  double sampleTimeOut = 0.02;                                ///< s
  bool outputsForce = true;
};

/// One reading of a device, in its own frame. SI units.
struct DeviceSample
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m
  unsigned buttons = 0;
  /// False when the device had nothing to report, or failed: the force is then zero.
  bool valid = false;
};

/**
 * A haptic device: read the hand, write the force. SI units, the device's own frame.
 *
 * read and write are called from the servo tick: they return at once, and neither allocate, lock
 * nor throw. `time` is passed in, so that a session can run in virtual time.
 */
class HapticDevice
{
public:
  virtual ~HapticDevice() = default;
  virtual const DeviceSpecification& specification() const noexcept = 0;
  virtual DeviceSample read(double time) noexcept = 0;
  /// Force on the hand, N. Returns false when the device did not take it.
  virtual bool write(const Eigen::Vector3d& force) noexcept = 0;
};
} // namespace palpate

#endif
