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
// Number of biarcs for a smooth part; the error is 1e-6 of the size of the part.
constexpr int PiecesPerSmooth = 24;
// The outline is straight where the profile is steeper than this slope, because no contact is
// steeper.
constexpr double SteepestSlope = 6.0;
// Radians. Smaller angles occur between the points of a sampled curve and do not count as corners.
constexpr double CornerAngle = 0.02;
// Largest fraction of a part that the fillet at either end may replace.
constexpr double LargestCut = 0.35;
// Step for finite differences as a fraction of a part's length; suitable for profiles with six
// digits.
constexpr double TangentStep = 1e-6;

double cross(const Vector2d& a, const Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Returns the direction rotated by 90° to the left, which points into the tool.
Vector2d leftOf(const Vector2d& direction)
{
  return { -direction.y(), direction.x() };
}

} // namespace

class ToolOutline::Part
{
public:
  Part(const AxisymmetricTool& tool, double from, double to)
    : Tool(tool)
    , From(from)
    , To(to)
    , End(to)
  {
    if (this->isSteepAt(to - 2.0 * TangentStep * (to - from)))
    {
      double low = from;
      for (int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + this->End);
        (this->isSteepAt(middle) ? this->End : low) = middle;
      }
    }
  }

  double from() const { return this->From; }
  double length() const { return this->To - this->From; }
  /// Returns the radius at which the part becomes too steep, like the side of a sphere, or at which
  /// it ends.
  double end() const { return this->End; }
  bool isSteep() const { return this->End < this->To; }

  Node at(double r) const
  {
    return { { r, this->Tool.profile(r) }, Vector2d(1.0, this->slopeAt(r)).normalized() };
  }

private:
  bool isSteepAt(double r) const { return this->slopeAt(r) > SteepestSlope; }

  /// Returns the slope by second-order differences within the part, one-sided at its ends.
  double slopeAt(double r) const
  {
    const double step = TangentStep * (this->To - this->From);
    const auto f = [this](double x) { return this->Tool.profile(x); };
    if (r - step < this->From || r + step > this->To)
    {
      const double s = r - step < this->From ? step : -step;
      return (-3.0 * f(r) + 4.0 * f(r + s) - f(r + 2.0 * s)) / (2.0 * s);
    }
    return (f(r + step) - f(r - step)) / (2.0 * step);
  }

  const AxisymmetricTool& Tool;
  double From;
  double To;
  double End;
};

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
  Node last{ { 0.0, tool.profile(0.0) }, { 1.0, 0.0 } };
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
  {
    const Part part(tool, ends[k], ends[k + 1]);
    last = this->addCorner(part, fillet, last, k == 0);
    last = this->addPart(part, last);
    if (ends[k + 1] == wall && !part.isSteep())
    {
      last = this->addWall(part, fillet, last);
    }
  }
  this->Arcs.push_back({ last.point, last.direction, 0.0, Infinite });
}

ToolOutline::Node ToolOutline::addCorner(
  const Part& part, double fillet, const Node& last, bool isApex)
{
  const Node first = part.at(part.from());
  const double turn = std::asin(std::clamp(cross(last.direction, first.direction), -1.0, 1.0));
  if (std::abs(turn) <= CornerAngle)
  {
    return isApex ? first : last;
  }
  const double longest = LargestCut * part.length();
  if (isApex) // the fillet of an apex is the sphere that is tangent to the flank
  {
    const double r = std::min(fillet * std::sin(turn), longest);
    Node flank = part.at(part.from() + r);
    const double rise = r / std::sin(turn) * (1.0 - std::cos(turn));
    this->addFillet({ { 0.0, flank.point.y() - rise }, { 1.0, 0.0 } }, flank);
    return flank;
  }
  const double cut = std::min(fillet * std::tan(0.5 * std::abs(turn)), longest);
  Node after = part.at(part.from() + cut * first.direction.x());
  this->addFillet({ last.point - cut * last.direction, last.direction }, after);
  return after;
}

ToolOutline::Node ToolOutline::addPart(const Part& part, const Node& last)
{
  const double start = last.point.x();
  const double middle = 0.5 * (start + part.end());
  const double begin = part.at(start).direction.y();
  const bool isStraight = std::abs(begin - part.at(part.end()).direction.y()) < 1e-7 &&
    std::abs(begin - part.at(middle).direction.y()) < 1e-7;
  Node from = last;
  const auto goTo = [&](double r)
  {
    const Node node = part.at(r);
    this->join(from, node);
    from = node;
  };
  if (isStraight)
  {
    // The fillet of the next corner may replace the rest.
    goTo(start + (1.0 - LargestCut) * (part.end() - start));
    goTo(part.end());
    return from;
  }
  for (int i = 1; i <= PiecesPerSmooth; ++i)
  {
    // Points are denser near the axis, because the curvature of a power law is largest there.
    const double t = static_cast<double>(i) / PiecesPerSmooth;
    goTo(start + (part.end() - start) * t * t);
  }
  return from;
}

ToolOutline::Node ToolOutline::addWall(const Part& part, double fillet, const Node& last)
{
  const double turn = std::acos(std::clamp(last.direction.y(), -1.0, 1.0));
  const double cut = std::min(fillet * std::tan(0.5 * turn), LargestCut * part.length());
  Node up{ { last.point.x(), last.point.y() + cut }, { 0.0, 1.0 } };
  if (turn > CornerAngle)
  {
    this->addFillet({ last.point - cut * last.direction, last.direction }, up);
  }
  return up;
}

/// Shortens the last arcs so that they end at the start of the fillet.
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

/// Adds a biarc: two arcs with a common tangent at their common point.
void ToolOutline::join(const Node& from, const Node& to)
{
  const Vector2d v = to.point - from.point;
  const Vector2d t = from.direction + to.direction;
  // Both tangents have the length d: |v - d t|² = 4d² [Bolton 1975].
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
  // The second arc begins in the direction in which the first arc ends.
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
