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
 * After steerTo, the position x approaches the target on a straight line without jumps or
 * oscillation. Each tick computes x ← target + (x - target) e^(-Δt/τ). After touch, the position
 * moves around the body to a point on its surface (GuidedHand). One thread calls steerTo and touch,
 * the servo thread calls moveOn. No function waits.
 */
class PALPATE_EXPORT SteeredTarget
{
public:
  static constexpr double TimeConstant = 0.03; ///< s

  explicit SteeredTarget(const Eigen::Vector3d& start);

  /// Sets the mapping of the device, which touch needs. Must be called before the first moveOn.
  void setMapping(const WorkspaceMapping& mapping) noexcept { this->Mapping = mapping; }

  void steerTo(const Eigen::Vector3d& target) noexcept;
  /// Moves the hand to a goal. The body of the goal must exist until oldestBody() returns a number
  /// above goal.bodyNumber. If touch is called before the first moveOn, the hand starts at the top
  /// of the column over the goal.
  void touch(const TouchGoal& goal) noexcept;
  /// The smallest bodyNumber of a goal that is still in use. To be called by the thread that
  /// steers.
  std::uint64_t oldestBody() const noexcept { return this->Oldest.load(std::memory_order_acquire); }

  /// Advances to `time` (s). The position does not move in the first call, or if the time
  /// decreases. Returns false, without motion, while the target is not finite.
  bool moveOn(double time) noexcept;
  /// The position of the hand, m.
  const Eigen::Vector3d& position() const noexcept { return this->Position; }

private:
  struct Told
  {
    Eigen::Vector3d target = Eigen::Vector3d::Zero(); ///< used if `goal` has no number; m
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
