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
 * Which way a tool is held by a hand that is steered from another thread: what SteeredTarget is for
 * a place.
 *
 * The shaft turns towards what it was told by the shortest way, the angle that is left going as
 * e^(-Δt/τ), and no further about itself than that takes. It is not told until it is told for the
 * first time, and begins there; the zero vector ends that. turnTo is for one thread, moveOn for the
 * servo thread; neither waits.
 */
class PALPATE_EXPORT SteeredAxis
{
public:
  static constexpr double TimeConstant = 0.03; ///< s, of SteeredTarget

  /// Of any length, in the frame of the device; what is not finite changes nothing.
  void turnTo(const Eigen::Vector3d& axis) noexcept;
  /// Moves on to `time` (s; an earlier one than before, or the first, moves nothing).
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
