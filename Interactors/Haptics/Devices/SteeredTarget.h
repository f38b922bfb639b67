// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SteeredTarget_h
#define palpate_SteeredTarget_h

#include "Haptics/Servo/LatestValue.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * Where a hand that is steered from another thread, as by a mouse, means to be.
 *
 * What it is told comes at display rate in steps; its aim approaches that as
 * x ← told + (x - told) e^(-Δt/τ), so that it neither jumps nor rings at servo rate. steerTo is for
 * one thread, moveOn for the servo thread; neither waits.
 */
class PALPATE_EXPORT SteeredTarget
{
public:
  static constexpr double TimeConstant = 0.03; ///< s

  explicit SteeredTarget(const Eigen::Vector3d& start);

  void steerTo(const Eigen::Vector3d& target) noexcept { this->Told.write(target); }
  /// Moves on to `time` (s; an earlier one than before, or the first, moves nothing). False, and
  /// not moved, while what was told is not finite.
  bool moveOn(double time) noexcept;
  /// m
  const Eigen::Vector3d& position() const noexcept { return this->Position; }

private:
  LatestValue<Eigen::Vector3d> Told;
  Eigen::Vector3d Position;
  double LastTime;
};
} // namespace palpate

#endif
