// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/ToolOutline.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr int PiecesPerSmooth = 24;   // biarcs of a smooth part: 1e-6 of its size off
constexpr double SteepestSlope = 6.0; // from there on straight: no contact is steeper
constexpr double CornerAngle = 0.02;  // radians; less is no corner but a sampled curve
constexpr double SlopeStep = 1e-6;    // of a part's length: differences of profiles of six digits

double cross(const Vector2d& a, const Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Turned a quarter left: into the tool.
Vector2d leftOf(const Vector2d& direction)
{
  return { -direction.y(), direction.x() };
}

Vector2d along(double slope)
{
  return Vector2d(1.0, slope).normalized();
}
} // namespace

ToolOutline::ToolOutline(const AxisymmetricTool& tool, double reach, double fillet)
{
  const double wall = tool.largestContactRadius();
  const double end = std::min(reach, wall);
  std::vector<double> ends = { 0.0 };
  for (const double kink : tool.kinks())
  {
    if (kink > 1e-9 * end && kink < (1.0 - 1e-9) * end)
    {
      ends.push_back(kink);
    }
  }
  ends.push_back(end);

  // Smooth parts between the kinks, their slopes at both ends by differences inside.
  const auto slopeAt = [&tool](double r, double from, double to)
  {
    const double step = SlopeStep * (to - from);
    const double low = std::max(from, r - step);
    const double high = std::min(to, r + step);
    if (low == from || high == to) // one-sided, of second order
    {
      const double s = low == from ? step : -step;
      return (-3.0 * tool.profile(r) + 4.0 * tool.profile(r + s) - tool.profile(r + 2.0 * s)) /
        (2.0 * s);
    }
    return (tool.profile(high) - tool.profile(low)) / (high - low);
  };
  Node last{ { 0.0, 0.0 }, { 1.0, 0.0 } };
  bool begun = false;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
  {
    const double from = ends[k];
    double to = ends[k + 1];
    const double length = to - from;
    const auto nodeAt = [&](double r)
    {
      // The walls of a sphere: its slope grows without bound before the end.
      return Node{ { r, tool.profile(r) }, along(slopeAt(r, from, ends[k + 1])) };
    };
    const bool isSteep = nodeAt(to - 2.0 * SlopeStep * length).direction.y() >
      SteepestSlope * nodeAt(to - 2.0 * SlopeStep * length).direction.x();
    if (isSteep)
    {
      double low = from;
      for (int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + to);
        const Node node = nodeAt(middle);
        (node.direction.y() > SteepestSlope * node.direction.x() ? to : low) = middle;
      }
    }
    const Node first = nodeAt(from);
    const double turn = std::asin(std::clamp(cross(last.direction, first.direction), -1.0, 1.0));
    const bool hasCorner = std::abs(turn) > CornerAngle;
    // At the axis the other half of the tool makes the corner twice as sharp.
    const double cut = hasCorner
      ? std::min(fillet * std::tan(0.5 * std::abs(turn) * (begun ? 1.0 : 2.0)), 0.4 * length)
      : 0.0;
    double start = from;
    if (hasCorner && !begun)
    {
      const double angle = turn; // the sphere that touches the flank
      const double r = std::min(fillet * std::sin(angle), 0.4 * length);
      const double radius = r / std::sin(angle);
      const Node flank = nodeAt(from + r);
      const Node tip{ { 0.0, flank.point.y() - radius * (1.0 - std::cos(angle)) }, { 1.0, 0.0 } };
      this->addFillet(tip, flank);
      last = flank;
      start = from + r;
    }
    else if (hasCorner)
    {
      const Node after = nodeAt(from + cut * first.direction.x());
      this->addFillet({ last.point - cut * last.direction, last.direction }, after);
      last = after;
      start = after.point.x();
    }
    else if (!begun)
    {
      last = first;
    }
    begun = true;
    // What the next corner needs of this part is taken off when it comes: parts end unjoined.
    const bool isLast = k + 2 == ends.size();
    const double slopeBegin = nodeAt(start).direction.y();
    const double slopeEnd = nodeAt(to).direction.y();
    const double slopeMiddle = nodeAt(0.5 * (start + to)).direction.y();
    const bool isStraight =
      std::abs(slopeBegin - slopeEnd) < 1e-7 && std::abs(slopeBegin - slopeMiddle) < 1e-7;
    const int pieces = isStraight ? 2 : PiecesPerSmooth;
    for (int i = 1; i <= pieces; ++i)
    {
      // Closer towards the axis, where a power law bends most.
      const double t = static_cast<double>(i) / pieces;
      const double r = start + (to - start) * (isStraight ? (i == 1 ? 0.6 : 1.0) : t * t);
      const Node node = nodeAt(r);
      this->join(last, node);
      last = node;
    }
    if (isLast && to == wall && !isSteep)
    {
      const double turnUp = std::acos(std::clamp(last.direction.y(), -1.0, 1.0));
      const double cutUp = std::min(fillet * std::tan(0.5 * turnUp), 0.35 * length);
      const Node up{ { wall, last.point.y() + cutUp }, { 0.0, 1.0 } };
      if (turnUp > CornerAngle)
      {
        this->addFillet({ last.point - cutUp * last.direction, last.direction }, up);
      }
      last = up;
    }
  }
  this->Arcs.push_back({ last.point, last.direction, 0.0, Infinite });
}

/// Cuts the last arcs back to where the fillet begins.
void ToolOutline::addFillet(const Node& before, const Node& after)
{
  while (!this->Arcs.empty())
  {
    Arc& arc = this->Arcs.back();
    const double kept = (before.point - arc.from).dot(arc.direction);
    if (kept > 1e-9 * arc.length)
    {
      arc.length = std::min(arc.length, kept);
      break;
    }
    this->Arcs.pop_back();
  }
  this->Fillets.emplace_back(before.point.x(), after.point.x());
  this->join(before, after);
}

/// A biarc: two arcs with the same tangent where they meet.
void ToolOutline::join(const Node& from, const Node& to)
{
  const Vector2d v = to.point - from.point;
  const Vector2d t = from.direction + to.direction;
  // Equal tangent lengths d: |v - d t|² = 4d² [Bolton 1975].
  const double a = 2.0 * (1.0 - from.direction.dot(to.direction));
  const double b = v.dot(t);
  const double c = v.squaredNorm();
  if (!(c > 0.0))
  {
    return;
  }
  const double d = c / (b + std::sqrt(std::max(0.0, b * b + a * c)));
  const Vector2d middle = 0.5 * (from.point + to.point + d * (from.direction - to.direction));
  this->addArc(from, middle);
  // The second arc seen from its end: its beginning has the direction of the first one's end.
  const Vector2d chord = (middle - from.point).normalized();
  const Vector2d direction = 2.0 * chord.dot(from.direction) * chord - from.direction;
  this->addArc({ middle, direction }, to.point);
}

void ToolOutline::addArc(const Node& from, const Vector2d& to)
{
  const Vector2d chord = to - from.point;
  const double length = chord.norm();
  if (!(length > 0.0))
  {
    return;
  }
  const double curvature = 2.0 * cross(from.direction, chord) / (length * length);
  const double half = std::asin(std::clamp(0.5 * curvature * length, -1.0, 1.0));
  this->Arcs.push_back({ from.point, from.direction, std::abs(half) < 1e-9 ? 0.0 : curvature,
    std::abs(half) < 1e-9 ? length : length * half / std::sin(half) });
}

ToolOutline::Distance ToolOutline::distance(const Vector2d& point) const
{
  Distance best{ Infinite, { 0.0, -1.0 }, Matrix2d::Zero() };
  for (const Arc& arc : this->Arcs)
  {
    const bool isFirst = &arc == &this->Arcs.front();
    const Vector2d inward = leftOf(arc.direction);
    const Vector2d offset = point - arc.from;
    Distance here{ 0.0, -inward, Matrix2d::Zero() };
    double way = offset.dot(arc.direction);
    if (arc.curvature == 0.0)
    {
      here.value = -offset.dot(inward);
    }
    else
    {
      const Vector2d centre = arc.from + inward / arc.curvature;
      const Vector2d out = point - centre;
      const double sign = arc.curvature > 0.0 ? 1.0 : -1.0;
      const double far = out.norm();
      if (!(far > 0.0))
      {
        continue;
      }
      here.gradient = sign * out / far;
      here.value = sign * far - 1.0 / arc.curvature;
      const Vector2d tangent = leftOf(here.gradient);
      here.hessian = sign / far * tangent * tangent.transpose();
      way = std::atan2(sign * out.dot(arc.direction), -sign * out.dot(inward)) / arc.curvature;
    }
    const double slack = 1e-9 * std::min(arc.length, 1.0);
    const bool isBeside = (way < -slack && !isFirst) || way > arc.length + slack;
    if (!isBeside && std::abs(here.value) < std::abs(best.value))
    {
      best = here;
    }
  }
  return best;
}

double ToolOutline::height(double r) const
{
  for (const Arc& arc : this->Arcs)
  {
    const double x = r - arc.from.x();
    const Vector2d inward = leftOf(arc.direction);
    if (arc.curvature == 0.0)
    {
      if (arc.direction.x() > 1e-12 && x <= arc.length * arc.direction.x())
      {
        return arc.from.y() + x * arc.direction.y() / arc.direction.x();
      }
      continue;
    }
    const Vector2d centre = arc.from + inward / arc.curvature;
    const double angle = arc.length * arc.curvature;
    const Vector2d out = arc.from - centre;
    const double endX = centre.x() + std::cos(angle) * out.x() - std::sin(angle) * out.y();
    if (r <= endX)
    {
      const double far = r - centre.x();
      const double root =
        std::sqrt(std::max(0.0, 1.0 / (arc.curvature * arc.curvature) - far * far));
      return centre.y() - (arc.curvature > 0.0 ? root : -root);
    }
  }
  return Infinite;
}
} // namespace palpate
