// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_GuidedHand_h
#define palpate_GuidedHand_h

#include "Contact/ContactTracker.h"
#include "Haptics/Guidance/RouteSearch.h"
#include "Haptics/Guidance/TouchGoal.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace palpate
{
/**
 * A hand that moves a tip between points on the surface of a body without passing through the body.
 * The tip rises along the normal, moves around the body, and descends along the normal of the next
 * point. The class is used for a mouse pointer, whose position on the body may jump.
 *
 * In each tick the tip is on a path that is known to be free:
 * - over the last goal, in the column below `hover` or on the outward path found by TouchPlanner;
 * - between the outward paths of two goals, on a straight line or an arc that RouteSearch has found
 *   to be free. The search is divided over several ticks. During the search the tip rises or rests.
 *
 * Therefore a tip that does not press has no contact, even if a new goal arrives while the tip
 * moves, and on hollow and thin bodies. This is guaranteed for the facets. The smooth contact
 * surface is higher than the facets by up to the bulge of its patches.
 *
 * A pressing tip slides to a pressing goal nearby. Its foot moves over the surface towards the
 * goal, and the tip is held under the foot along the interpolated normal, at a depth between the
 * present depth and that of the goal. In each tick the depth of the contact is computed as in the
 * servo step (ContactTracker). If it would exceed the larger of these two depths, the tip is
 * lifted. If the foot does not approach the goal, for example at a ridge, the tip rises and
 * descends at the goal.
 *
 * If no path exists, for example between the inside and the outside of a hollow body, the tip is
 * placed at the top of the goal's column in one tick; jumps() counts these events.
 *
 * The remaining length of a path decays as e^(-Δt/τ), but not faster than FastestSpeed. No function
 * allocates or throws. A tick with a search costs SearchQueries closest-point queries, another tick
 * at most a few.
 */
class PALPATE_EXPORT GuidedHand
{
public:
  static constexpr double TimeConstant = 0.03;   ///< s, as in SteeredTarget
  static constexpr double FastestSpeed = 1000.0; ///< mm/s

  /// Places the tip at any point, mm. The hand moves from that point to its next goal.
  void putAt(const Vector3& tip) noexcept;
  /// Places the tip at the top of the goal's column, from where the hand moves to the goal.
  void beginAt(const TouchGoal& goal) noexcept;
  /// Sets the goal of the next ticks. No effect if goal.number is the number of the present goal.
  void follow(const TouchGoal& goal) noexcept;
  /// Advances the hand by `elapsed` s.
  void advance(double elapsed) noexcept;

  const Vector3& tip() const noexcept { return this->Tip; }
  /// Whether the tip is at its newest goal.
  bool rests() const noexcept;
  /// The smallest bodyNumber of a body that the hand still uses.
  std::uint64_t oldestBody() const noexcept;
  /// Number of goals to which no path was found.
  std::uint64_t jumps() const noexcept { return this->Jumps; }

private:
  static constexpr int SearchQueries = 16;
  static constexpr double SlideReach = 20.0; ///< mm, largest distance of a slide

  enum class Phase : std::uint8_t
  {
    Lost,   ///< the tip may be at any point
    Moving, ///< the tip moves on Path to Goal
    Sliding ///< the tip slides over the surface to Goal
  };

  void react() noexcept;
  void depart() noexcept;
  void search() noexcept;
  void enter(const RouteSearch::Route& route, std::size_t goalSteps) noexcept;
  void enterAtTop() noexcept;
  void enterColumn() noexcept;
  void move(double share, double most) noexcept;
  void moveInContact(double share, double most) noexcept;
  void slide(double share, double most) noexcept;
  bool slideBy(double step, double lift, double farthest, int halvings) noexcept;
  /// Whether the tip is in the column of Goal, below the top.
  bool isInColumn() const noexcept;
  double heightInColumn() const noexcept
  {
    return (this->Tip - this->Goal.point).dot(this->Goal.normal);
  }
  void setGoal(const TouchGoal& goal) noexcept;
  static double depthOf(const ContactTracker::Result& contact) noexcept;
  void acceptContact(const ContactTracker& tracker, const ContactTracker::Result& contact) noexcept;
  bool canSlideTo(const TouchGoal& goal) const noexcept;
  bool isBehind() const noexcept;
  bool canRise() const noexcept;
  void addTop(const Vector3& foot, const Vector3& normal) noexcept;
  /// An upper bound of the number of points of the retreat from Path. If this number is too large
  /// for a retreat, the hand first continues along Path; the number of points becomes smaller, and
  /// the last points are above the goal.
  std::size_t pointsToLeave() const noexcept;
  void leaveColumn() noexcept;
  void leavePath() noexcept;
  void leaveSurface() noexcept;
  void leaveUnknown() noexcept;

  Vector3 Tip = Vector3::Zero();
  Phase Now = Phase::Lost;
  bool IsSearching = false; ///< a path to Search.goal() is being searched; meanwhile Path is the
                            ///< beginning of the retreat
  TouchGoal Goal;           ///< the goal at the end of Path or of the slide
  TouchGoal Wanted;         ///< the newest goal

  RouteSearch::Route Path;
  std::size_t Leg = 0;       ///< the tip is between points Leg and Leg + 1 of Path
  std::size_t GoalSteps = 0; ///< number of points of Goal.way near the end of Path

  RouteSearch::Retreat Retreat;
  std::size_t Known = 0; ///< number of the retreat's points that are connected by free legs
  std::size_t First = 0; ///< index of the first point of the retreat from which a line may begin
  RouteSearch Search;

  Vector3 Foot = Vector3::Zero(); ///< foot of the tip during a slide
  Vector3 FootNormal = Vector3::Zero();
  std::int32_t FootTriangle = -1;
  double Height = 0.0; ///< height of the tip over the foot, mm
  int Stuck = 0;       ///< number of ticks in which the foot did not approach the goal

  std::optional<ContactTracker>
    Tracker;          ///< tracks the contact with Goal.body as the servo step does
  double Depth = 0.0; ///< depth of the contact, mm; 0 without contact
  Vector3 ContactPoint = Vector3::Zero();
  Vector3 ContactNormal = Vector3::Zero();

  std::uint64_t Jumps = 0;
};
} // namespace palpate

#endif
