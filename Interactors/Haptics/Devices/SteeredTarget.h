// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SteeredTarget_h
#define palpate_SteeredTarget_h

#include "Haptics/Devices/WorkspaceMapping.h"
#include "Haptics/Guidance/GuidedHand.h"
#include "Haptics/Servo/LatestValue.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <atomic>
#include <cstdint>

namespace palpate
{
/**
 * The target of a hand that another thread steers, for example by a mouse.
 *
 * After steerTo, the position x approaches the target at servo rate as x ← target + (x - target)
 * e^(-Δt/τ), without jumps or oscillation, on a straight line. After touch, it moves around the
 * body to a place of its surface (GuidedHand). steerTo and touch are for one thread, moveOn for the
 * servo thread; neither waits.
 */
class PALPATE_EXPORT SteeredTarget
{
public:
  static constexpr double TimeConstant = 0.03; ///< s

  explicit SteeredTarget(const Eigen::Vector3d& start);

  /// Sets the mapping of the device, for touch; to be called before the first moveOn.
  void setMapping(const WorkspaceMapping& mapping) noexcept { this->Mapping = mapping; }

  void steerTo(const Eigen::Vector3d& target) noexcept;
  /// Moves the hand to a goal. The goal's body must exist until oldestBody() returns a larger
  /// number. If this is called before the first moveOn, the hand starts at the top of the goal's
  /// column.
  void touch(const TouchGoal& goal) noexcept;
  /// The smallest number of a body that is still in use; for the thread that steers.
  std::uint64_t oldestBody() const noexcept { return this->Oldest.load(std::memory_order_acquire); }

  /// Advances to `time` (s). There is no motion in the first call, or if time decreases. Returns
  /// false, without motion, while the target is not finite.
  bool moveOn(double time) noexcept;
  /// The position, m.
  const Eigen::Vector3d& position() const noexcept { return this->Position; }

private:
  struct Told
  {
    Eigen::Vector3d target = Eigen::Vector3d::Zero(); ///< m, if `goal` has no number
    TouchGoal goal;
  };
  void moveGuided(const TouchGoal& goal, double elapsed) noexcept;

  LatestValue<Told> Newest;
  WorkspaceMapping Mapping;
  Eigen::Vector3d Position;
  double LastTime;
  bool HasBegun = false;
  GuidedHand Hand;
  bool IsGuided = false;
  std::atomic<std::uint64_t> Oldest{ 0 };
};
} // namespace palpate

#endif
