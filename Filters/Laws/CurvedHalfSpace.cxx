// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/CurvedHalfSpace.h"

#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int PieceCount = 128;
constexpr int MostSteps = 30;
// Largest residual relative to the depth. The relative error after the next step is of the order of
// the square of this value.
constexpr double Converged = 1e-5;

double cubic(const std::array<double, 4>& c, double x)
{
  return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

/// Returns the cubic through four values at x = from, from + 1, from + 2, from + 3.
std::array<double, 4> throughFour(const double* value, double from)
{
  // Newton's forward differences in s = x - from.
  const double first = value[1] - value[0];
  const double second = value[2] - 2.0 * value[1] + value[0];
  const double third = value[3] - 3.0 * value[2] + 3.0 * value[1] - value[0];
  const std::array<double, 4> s = { value[0], first - second / 2.0 + third / 3.0,
    second / 2.0 - third / 2.0, third / 6.0 };
  const double b = -from;
  return { cubic(s, b), s[1] + b * (2.0 * s[2] + 3.0 * b * s[3]), s[2] + 3.0 * b * s[3], s[3] };
}

/// Returns the factor 1 + ln²(one/other)/48 for two sums of curvatures.
double ellipse(double one, double other)
{
  if (one == other)
  {
    return 1.0;
  }
  const double ratio = std::log(one / other);
  return 1.0 + ratio * ratio / 48.0;
}

/// Returns the state before the rim of a flat end is in full contact. It is a power of the depth,
/// up to the depth at which the law begins.
LocalState beforeRim(const LocalState& first, double fraction)
{
  const double power = first.stiffness * first.depth / first.force;
  const double force = first.force * std::pow(fraction, power);
  const double depth = first.depth * fraction;
  return { depth, force, power * force / depth, first.radius, first.toolDepth * fraction,
    first.toolDepth / first.depth, false };
}
} // namespace

CurvedHalfSpace::CurvedHalfSpace(const AxisymmetricTool& tool, double deepest)
  : Step(std::sqrt(deepest) / PieceCount)
  , FlatRadius(tool.smallestContactRadius())
{
  std::vector<double> radius = { this->FlatRadius };
  std::vector<double> share = { 0.0 }; // F/(a t²); the value at first contact is set later
  for (int i = 1; i <= PieceCount; ++i)
  {
    const double t = this->Step * i;
    const IndentationPoint point = tool.evaluate(std::min(t * t, deepest), 1.0);
    radius.push_back(point.contactRadius);
    share.push_back(point.force / (point.contactRadius * t * t));
  }
  for (std::size_t i = 0; i < PieceCount; ++i)
  {
    const std::size_t first = std::clamp<std::size_t>(i, 2, radius.size() - 3) - 1;
    const double from = static_cast<double>(first) - static_cast<double>(i);
    this->Pieces.push_back(
      { throughFour(radius.data() + first, from), throughFour(share.data() + first, from) });
  }
  if (this->FlatRadius > 0.0)
  {
    this->Pieces.front().radius = throughFour(radius.data(), 0.0);
  }
  else
  {
    this->FirstPower = std::log2(radius[2] / radius[1]);
    this->FirstRadius = radius[1];
  }
}

CurvedHalfSpace::Circle CurvedHalfSpace::at(double t) const
{
  const double place = t / this->Step;
  const int piece = std::min(static_cast<int>(place), PieceCount - 1);
  const double x = place - piece;
  const Piece& powers = this->Pieces[static_cast<std::size_t>(piece)];
  const auto& r = powers.radius;
  double radius = cubic(r, x);
  double slope = (r[1] + x * (2.0 * r[2] + 3.0 * x * r[3])) / this->Step;
  if (piece == 0 && this->FirstRadius > 0.0)
  {
    radius = this->FirstRadius * std::pow(place, this->FirstPower);
    slope = this->FirstPower * radius / t;
  }
  return { radius, slope, cubic(powers.share, x) * radius * t * t };
}

CurvedHalfSpace::Sagging CurvedHalfSpace::saggingAt(
  double t, const Circle& circle, const SpotCurvature& curvature)
{
  const double square = circle.radius * circle.radius;
  const double one = t * t + curvature.first * square;
  const double other = t * t + curvature.second * square;
  if (!(one > 0.0 && other > 0.0))
  {
    return { one, other, 0.0, 0.0 };
  }
  const double depth = std::sqrt(one * other);
  const double grow = circle.radius * circle.slope;
  return { one, other, depth,
    ((t + curvature.first * grow) * other + (t + curvature.second * grow) * one) / depth };
}

CurvedHalfSpace::Contact CurvedHalfSpace::contactAt(double t, const SpotCurvature& curvature) const
{
  const Circle circle = this->at(t);
  const Sagging body = saggingAt(t, circle, curvature);
  const double a = circle.radius;
  const double tool = t * t;
  if (!(body.slope > 0.0))
  {
    return { {}, 0.0, false };
  }
  const double factor = ellipse(body.one, body.other);
  return { { body.depth, factor * (circle.force + 4.0 / 3.0 * a * (body.depth - tool)),
             factor * 2.0 * a, a, tool, 2.0 * t / body.slope },
    body.slope, this->FlatRadius > 0.0 || std::min(body.one, body.other) > LeastSum * tool };
}

/// The contact of a flat end of radius b on a bump at depths below κ_m b², where full contact
/// begins. The law is that of Hertz until the contact radius is b. At larger depths the force is
/// extrapolated linearly.
LocalState CurvedHalfSpace::sagAlone(double depth, const SpotCurvature& curvature) const
{
  const double b = this->FlatRadius;
  const double mean = curvature.mean() * b * b;
  const double hertz = std::sqrt(curvature.first * curvature.second) * b * b;
  if (depth > hertz && mean > hertz)
  {
    const double from = ellipse(curvature.first, curvature.second) * 4.0 / 3.0 * b * hertz;
    const double slope = (4.0 / 3.0 * b * mean - from) / (mean - hertz);
    return { depth, from + slope * (depth - hertz), slope, b, 0.0, 0.0 };
  }
  const double a = std::sqrt(depth / std::sqrt(curvature.first * curvature.second));
  const double factor = ellipse(curvature.first, curvature.second);
  return { depth, factor * 4.0 / 3.0 * a * depth, factor * 2.0 * a, a, 0.0, 0.0 };
}

LocalState CurvedHalfSpace::sagInSeries(
  const SpotCurvature& curvature, double softness, double deflection) const
{
  double depth = deflection;
  for (int step = 0; softness > 0.0 && step < MostSteps; ++step)
  {
    const LocalState state = this->sagAlone(depth, curvature);
    const double left = deflection - depth - softness * state.force;
    // At full contact the stiffness decreases abruptly. Therefore a Newton step may lead to a
    // negative depth.
    depth = std::max(depth + left / (1.0 + softness * state.stiffness), 0.25 * depth);
    if (std::abs(left) <= Converged * deflection)
    {
      break;
    }
  }
  return this->sagAlone(depth, curvature);
}

bool CurvedHalfSpace::solve(const SpotCurvature& around, double softness,
  const std::vector<double>& deflections, LocalState* states) const
{
  const double end = this->Step * PieceCount;
  const double b = this->FlatRadius;
  const auto total = [softness](const LocalState& state)
  { return state.depth + softness * state.force; };
  // In full contact, the law of a flat end depends only on the mean curvature. On a bump full
  // contact begins at a depth of κ_m b². On other surfaces the rim touches first, and no law is
  // valid before full contact.
  const double mean = around.mean();
  const SpotCurvature curvature = b > 0.0 ? SpotCurvature{ mean, mean, 0.0 } : around;
  const double rim = b > 0.0 ? wholeFrom(b, around) : 0.0;
  const bool isRimFirst = rim > 0.0;
  const LocalState first = isRimFirst
    ? this->contactAt(std::max(std::sqrt(rim - mean * b * b), 1e-6 * end), curvature).local
    : b > 0.0 && mean > 0.0 ? this->sagAlone(mean * b * b, around)
                            : LocalState{ 0.0, 0.0, 0.0, b, 0.0, 1.0 };
  const double whole = total(first);
  // The ratio of t² to the deflection changes little, so that its next value is extrapolated
  // linearly. The first value is that of two paraboloids.
  const double flat = std::min(std::sqrt(deflections.front()), end);
  const double radius = this->at(flat).radius;
  const double sum = flat * flat + curvature.mean() * radius * radius;
  double last = sum > 0.0 ? flat * flat / sum : 1.0;
  double before = last;
  for (std::size_t i = 0; i < deflections.size(); ++i)
  {
    const double deflection = deflections[i];
    if (deflection <= whole)
    {
      states[i] = isRimFirst ? beforeRim(first, deflection / whole)
                             : this->sagInSeries(around, softness, deflection);
      before = last = first.toolDepth / whole;
      continue;
    }
    const double ahead = i < 2 ? 0.0
                               : (deflection - deflections[i - 1]) /
        (deflections[i - 1] - deflections[i - 2]) * (last - before);
    const double fraction = last + ahead > 0.0 ? last + ahead : std::max(last, 1e-6);
    double t = std::min(std::sqrt(fraction * deflection), end);
    bool isFound = false;
    for (int step = 0; step < MostSteps && !isFound; ++step)
    {
      const Circle circle = this->at(t);
      const Sagging body = saggingAt(t, circle, curvature);
      if (!(body.slope > 0.0))
      {
        return false;
      }
      double left = deflection - body.depth;
      double slope = body.slope;
      if (softness > 0.0)
      {
        const LocalState local = this->contactAt(t, curvature).local;
        left -= softness * local.force;
        slope *= 1.0 + softness * local.stiffness;
      }
      const double change = left / slope;
      isFound = std::abs(left) <= Converged * deflection;
      t = std::clamp(t + change, 0.25 * t, 4.0 * t);
      if (t > end && step > 2 && !isFound)
      {
        return false;
      }
      t = isFound ? t : std::min(t, end);
    }
    const Contact contact = this->contactAt(t, curvature);
    if (!isFound || !contact.isThere)
    {
      return false;
    }
    states[i] = contact.local;
    before = i == 0 ? contact.local.toolDepth / deflection : last;
    last = contact.local.toolDepth / deflection;
  }
  return true;
}
} // namespace palpate
