// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TouchPlanner_h
#define palpate_TouchPlanner_h

#include "Haptics/Guidance/TouchGoal.h"
#include "Mechanics/PalpateExport.h"

#include <deque>
#include <memory>

namespace palpate
{
/**
 * Makes the goals of a guided hand, on the thread that steers the hand.
 *
 * For a point of the surface, the planner computes the height up to which the column over the point
 * is free. It also searches for a straight path from the top of the column to a sphere around the
 * body. It tries the normal first, then directions at increasing angles from the normal. In a
 * hollow from which no direction leads out, it tries again from the middle of the hollow. A goal
 * without a path to the sphere (`leadsOut` is false) can be reached only from points with a free
 * straight line to the goal. A plan costs 20 to some thousand closest-point queries.
 *
 * The planner keeps the bodies of its goals until release().
 */
class PALPATE_EXPORT TouchPlanner
{
public:
  static constexpr double Approach = 3.0; ///< largest height from which a tip descends, mm

  /// Sets the body of the next goals. Must not be null.
  void setBody(std::shared_ptr<const ContactBody> body);
  bool hasBody() const noexcept { return !this->Bodies.empty(); }

  /// Returns the goal of a tip at `height` above a point of the surface. `height` is in mm;
  /// negative if the tip presses. `point` is replaced by the closest point on the surface if it is
  /// not on the surface. `normal` is the outward unit normal. If the tip does not press, it is
  /// lowered to the free height if that is smaller. setBody must have been called.
  TouchGoal plan(const Vector3& point, const Vector3& normal, double height);

  /// Releases all bodies whose number is below `oldest`, the number of the oldest body in use.
  void release(std::uint64_t oldest);

private:
  struct Body
  {
    std::shared_ptr<const ContactBody> kernel;
    std::uint64_t number;
  };
  void findWay(TouchGoal& goal) const;
  bool leaveAlong(const Vector3& direction, TouchGoal& goal) const;
  bool leaveNear(const Vector3& normal, TouchGoal& goal) const;
  bool climb(TouchGoal& goal) const;

  std::deque<Body> Bodies; ///< the last body is the body of the next goals
  std::uint64_t LastNumber = 0;
  std::uint64_t LastBody = 0;
  std::uint64_t Surface = 0;
  double Radius = 0.0;                 ///< radius of a sphere around the body, mm
  double LastMost = 0.0;               ///< largest height of the last column, mm
  Vector3 LastPoint = Vector3::Zero(); ///< the last point given to plan()
  Vector3 LastNormal = Vector3::Zero();
  TouchGoal Last; ///< the last goal; its path is reused for the same point
};
} // namespace palpate

#endif
