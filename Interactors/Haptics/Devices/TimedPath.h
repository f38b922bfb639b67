// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TimedPath_h
#define palpate_TimedPath_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace palpate
{
/// A position and its time.
struct WayPoint
{
  double time = 0.0;                                  ///< s; must not decrease along a path
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< m
  /// Axis of the tool, from tip to hand, not normalised; zero if unknown.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
};

/**
 * A position as a function of time. The position is interpolated linearly between way points and
 * rests before the first and after the last one. Two way points with the same time are a jump: at
 * that time and later, the second one applies.
 *
 * The axis turns at constant speed from one way point to the next. If one of the two way points has
 * no axis, the axis is unknown between them.
 *
 * A look-up in a path of n way points costs O(log n) and does not allocate.
 */
class PALPATE_EXPORT TimedPath
{
public:
  /// An interval of uniform motion.
  struct Ramp
  {
    Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< position at the given time, m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); ///< m/s
    double end = 0.0;                                   ///< end of the motion, s; may be infinite
  };

  explicit TimedPath(std::vector<WayPoint> points)
    : Points(std::move(points))
  {
  }

  bool isEmpty() const noexcept { return this->Points.empty(); }
  /// Time of the last way point, s; 0 for an empty path.
  double duration() const noexcept { return this->isEmpty() ? 0.0 : this->Points.back().time; }

  /// The position at `time`, m. An empty path returns zero.
  Eigen::Vector3d at(double time) const noexcept;
  /// The axis of the tool at `time`, a unit vector; zero if the axis is unknown.
  Eigen::Vector3d axisAt(double time) const noexcept;
  /// The uniform motion that begins at `time` on the path. An empty path rests at zero.
  Ramp rampAt(double time) const noexcept;

  /// Describes the first way point that is not finite or whose time is before that of the preceding
  /// one. Returns "" if there is no such way point.
  std::string fault() const;

private:
  std::vector<WayPoint> Points;
};
} // namespace palpate

#endif
