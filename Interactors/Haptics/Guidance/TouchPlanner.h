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
 * For a point of the surface it finds the height up to which the column over the point is free, and
 * a straight way from the top of the column to a sphere around the body. It tries the normal first,
 * then directions farther and farther from the normal. In a hollow from which no direction leads
 * out, it tries again from the middle of the hollow. A goal without such a way (`leadsOut` is
 * false) can be reached only from places with a free straight line to it. Cost: 20 to some thousand
 * closest points.
 *
 * The planner keeps the bodies of its goals until release().
 */
class PALPATE_EXPORT TouchPlanner
{
public:
  static constexpr double Approach = 3.0; ///< mm, largest height from which a hand comes down

  /// Sets the body of the next goals, not null.
  void setBody(std::shared_ptr<const ContactBody> body);
  bool hasBody() const noexcept { return !this->Bodies.empty(); }

  /// The goal of a tip at `height` (mm, negative: pressed) above a point with an outward unit
  /// normal. A point that is not on the surface is replaced by the closest one that is. A tip that
  /// does not press is lowered to the free height if that is smaller. setBody must have set a body.
  TouchGoal plan(const Vector3& point, const Vector3& normal, double height);

  /// Releases the bodies with a smaller number than that of the oldest body in use.
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

  std::deque<Body> Bodies; ///< the last body is that of the next goals
  std::uint64_t LastNumber = 0;
  std::uint64_t LastBody = 0;
  std::uint64_t Surface = 0;
  double Radius = 0.0;                 ///< radius of a sphere around the body, mm
  double LastMost = 0.0;               ///< largest height of the last column, mm
  Vector3 LastPoint = Vector3::Zero(); ///< the last point given to plan()
  Vector3 LastNormal = Vector3::Zero();
  TouchGoal Last; ///< the last goal; its way is used again for the same place
};
} // namespace palpate

#endif
