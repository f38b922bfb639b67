// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/TimedPath.h"

#include "Haptics/Devices/ToolOrientation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
/// The first way point whose time is after `time`.
auto after(const std::vector<WayPoint>& points, double time)
{
  return std::upper_bound(points.begin(), points.end(), time,
    [](double t, const WayPoint& point) { return t < point.time; });
}
} // namespace

Eigen::Vector3d TimedPath::at(double time) const noexcept
{
  if (this->Points.empty())
  {
    return Eigen::Vector3d::Zero();
  }
  const auto to = after(this->Points, time);
  if (to == this->Points.begin())
  {
    return this->Points.front().position;
  }
  if (to == this->Points.end())
  {
    return this->Points.back().position;
  }
  const WayPoint& from = *(to - 1);
  const double share = (time - from.time) / (to->time - from.time);
  return from.position + share * (to->position - from.position);
}

Eigen::Vector3d TimedPath::axisAt(double time) const noexcept
{
  if (this->Points.empty())
  {
    return Eigen::Vector3d::Zero();
  }
  const auto to = after(this->Points, time);
  const WayPoint& from = to == this->Points.begin() ? *to : *(to - 1);
  if (to == this->Points.begin() || to == this->Points.end() || from.axis.isZero(0.0))
  {
    return from.axis.stableNormalized();
  }
  if (to->axis.isZero(0.0))
  {
    return Eigen::Vector3d::Zero();
  }
  const double share = (time - from.time) / (to->time - from.time);
  const Eigen::Vector3d axis = from.axis.stableNormalized();
  return turnedBy(share * leastTurn(axis, to->axis.stableNormalized())) * axis;
}

TimedPath::Ramp TimedPath::rampAt(double time) const noexcept
{
  Ramp ramp;
  ramp.position = this->at(time);
  const auto to = after(this->Points, time);
  if (to == this->Points.end())
  {
    ramp.end = std::numeric_limits<double>::infinity();
    return ramp;
  }
  ramp.end = to->time;
  if (to != this->Points.begin())
  {
    const WayPoint& from = *(to - 1);
    ramp.velocity = (to->position - from.position) / (to->time - from.time);
  }
  return ramp;
}

std::string TimedPath::fault() const
{
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const WayPoint& point = this->Points[i];
    if (!std::isfinite(point.time) || !point.position.allFinite() || !point.axis.allFinite())
    {
      return "way point " + std::to_string(i) + " is not finite";
    }
    if (i > 0 && point.time < this->Points[i - 1].time)
    {
      return "way point " + std::to_string(i) + " is earlier than the one before";
    }
  }
  return {};
}
} // namespace palpate
