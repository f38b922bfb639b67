// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SteeredAxis_h
#define palpate_SteeredAxis_h

#include "Haptics/Devices/ToolOrientation.h"
#include "Haptics/Servo/LatestValue.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * The axis of a tool held by a hand that another thread steers. It is the counterpart of
 * SteeredTarget for orientations.
 *
 * The shaft turns towards the axis of the last turnTo by the shortest rotation, without spin; the
 * remaining angle decays as e^(-Δt/τ). The axis is unknown until the first turnTo, which sets it
 * without a motion. The zero vector makes the axis unknown again. One thread calls turnTo, the
 * servo thread calls moveOn. Neither function waits.
 */
class PALPATE_EXPORT SteeredAxis
{
public:
  static constexpr double TimeConstant = 0.03; ///< s, as in SteeredTarget

  /// Sets the axis, in the device frame, towards which the shaft turns. The axis need not have unit
  /// length. No effect if the axis is not finite.
  void turnTo(const Eigen::Vector3d& axis) noexcept;
  /// Advances to `time` (s). The axis does not move in the first call, or if the time decreases.
  void moveOn(double time) noexcept;
  const ToolOrientation& orientation() const noexcept { return this->Orientation; }

private:
  LatestValue<Eigen::Vector3d> Told{ Eigen::Vector3d::Zero() };
  ToolOrientation Orientation = orientationNotTold();
  double LastTime = 0.0;
  bool HasTime = false;
};
} // namespace palpate

#endif
