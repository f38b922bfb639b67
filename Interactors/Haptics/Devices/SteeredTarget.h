// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SteeredTarget_h
#define palpate_SteeredTarget_h

#include "Haptics/Servo/LatestValue.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * The target of a hand that another thread steers, for example by a mouse.
 *
 * The target is set in steps at display rate. The position x approaches it at servo rate as x ←
 * target + (x - target) e^(-Δt/τ), without jumps or oscillation. steerTo is for one thread, moveOn
 * for the servo thread; neither waits.
 */
class PALPATE_EXPORT SteeredTarget
{
public:
  static constexpr double TimeConstant = 0.03; ///< s

  explicit SteeredTarget(const Eigen::Vector3d& start);

  void steerTo(const Eigen::Vector3d& target) noexcept { this->Told.write(target); }
  /// Advances to `time` (s). There is no motion in the first call, or if time decreases. Returns
  /// false, without motion, while the target is not finite.
  bool moveOn(double time) noexcept;
  /// The position, m.
  const Eigen::Vector3d& position() const noexcept { return this->Position; }

private:
  LatestValue<Eigen::Vector3d> Told;
  Eigen::Vector3d Position;
  double LastTime;
};
} // namespace palpate

#endif
