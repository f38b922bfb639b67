// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RouteSearch_h
#define palpate_RouteSearch_h

#include "Haptics/Guidance/FreeSpace.h"
#include "Haptics/Guidance/TouchGoal.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// A polygon of bounded length, mm.
template <std::size_t Most>
struct BoundedPath
{
  BoundedPath() noexcept { this->points.fill(Vector3::Zero()); }

  std::array<Vector3, Most> points;
  std::size_t count = 0;

  /// Adds a point. No effect if the path already has Most points.
  void add(const Vector3& point) noexcept
  {
    if (this->count < Most)
    {
      this->points[this->count++] = point;
    }
  }
  const Vector3& last() const noexcept { return this->points[this->count - 1]; }
  /// Length of the path from the point `first` to the end.
  double lengthFrom(std::size_t first) const noexcept
  {
    double sum = 0.0;
    for (std::size_t i = first + 1; i < this->count; ++i)
    {
      sum += (this->points[i] - this->points[i - 1]).norm();
    }
    return sum;
  }
};

/**
 * Searches for a path around a body from a hand's retreat to a goal. The search is divided into
 * parts that are short enough for a servo tick.
 *
 * The *retreat* is a polygon that begins at the hand and leads away from the body; the goal's path
 * (TouchGoal::way) is a similar polygon. The search looks for a free straight line (FreeLine) from
 * a point of the retreat to a point of the goal's path; the line with the shortest total route is
 * tried first. If no line is free, the route goes around the body on a sphere. Legs of the retreat
 * that are not yet known to be free are checked before they are used. A point that no free leg
 * reaches is omitted. If the retreat does not lead to the sphere, straight lines from its known end
 * are tried in all directions.
 *
 * No function allocates or throws. The bodies of the goals must exist during the search.
 */
class PALPATE_EXPORT RouteSearch
{
public:
  static constexpr std::size_t MostRetreat = 24;
  using Retreat = BoundedPath<MostRetreat>;
  using Route = BoundedPath<MostRetreat + 8 + TouchGoal::MostSteps + 2>;

  /// Begins a search. The points of the retreat with an index below `known` are connected by free
  /// legs, or by legs that leave the body. Lines start at the point `first` or later points.
  /// `margin` is the clearance to keep, mm.
  void begin(const Retreat& retreat, std::size_t known, std::size_t first, double margin,
    const TouchGoal& goal) noexcept;
  /// Continues the search with at most `queries` closest-point queries. Returns Unknown if the
  /// search has not ended.
  FreeLine::State go(int queries) noexcept;

  const TouchGoal& goal() const noexcept { return this->Goal; }
  const Retreat& retreat() const noexcept { return this->Way; }
  /// The route that was found. It begins at `tip`, follows the retreat from its point `next` on,
  /// and ends at the position of the tip at the goal.
  Route route(const Vector3& tip, std::size_t next) const noexcept;
  /// Number of points of the goal's path that the route uses.
  std::size_t goalSteps() const noexcept { return this->To + 1; }

private:
  static constexpr std::size_t MostArc = 8;
  enum class Stage : std::uint8_t
  {
    Choose, ///< choose the next line
    Extend, ///< extend the retreat by one leg
    Line,
    Escape, ///< search from the retreat's known end to the sphere
    Arc,
    Done
  };

  void choose() noexcept;
  void escape() noexcept;
  void beginArc() noexcept;
  void endLeg(bool isFree) noexcept;
  void addEscape() noexcept;
  void nextArcLeg(bool isFree) noexcept;
  bool isOutside(const Vector3& point) const noexcept;
  void end(FreeLine::State state) noexcept
  {
    this->Found = state;
    this->Now = Stage::Done;
  }

  TouchGoal Goal;
  Retreat Way;
  std::size_t Known = 0;
  std::size_t First = 0;
  double Margin = 0.0;
  /// Bit j is set if the line to step j of the goal's path was tried.
  std::array<std::uint32_t, MostRetreat> Tried{};
  std::size_t From = 0; ///< index of the retreat's point at which the present line begins
  std::size_t To = 0;
  int Direction = 0; ///< the next direction of an escape
  /// Points between the end of the retreat and the end of the goal's path.
  BoundedPath<MostArc> Arc;
  std::size_t ArcLeg = 0;
  FreeLine Line;
  Stage Now = Stage::Done;
  FreeLine::State Found = FreeLine::State::Blocked;
};
} // namespace palpate

#endif
