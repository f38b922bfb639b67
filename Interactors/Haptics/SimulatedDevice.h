// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SimulatedDevice_h
#define palpate_SimulatedDevice_h

#include "HapticDevice.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * A device without hardware: a stiff hand that follows a path in time, whatever it feels.
 *
 * Between way points the position is linear in time; before the first and after the last it rests
 * there. Deterministic: the sample depends on the path and the time alone.
 */
class SimulatedDevice final : public HapticDevice
{
public:
  struct WayPoint
  {
    double time = 0.0;                                  ///< s, not decreasing along the path
    Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m
  };

  explicit SimulatedDevice(
    std::vector<WayPoint> path, const DeviceSpecification& specification = {});

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  /// Not valid while the path is empty or `time` is not finite.
  DeviceSample read(double time) noexcept override;
  bool write(const Eigen::Vector3d& force) noexcept override;

  const Eigen::Vector3d& lastForce() const noexcept { return this->Force; }
  /// Time of the last way point, s; 0 for an empty path.
  double duration() const noexcept;

private:
  DeviceSpecification Limits;
  std::vector<WayPoint> Path;
  Eigen::Vector3d Force = Eigen::Vector3d::Zero();
};
} // namespace palpate

#endif
