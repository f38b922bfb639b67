// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/CappedResponse.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Permitted error of the force, divided by K_max δ, due to the error in the position of one end of
/// an interval.
constexpr double Accuracy = 1e-7;
} // namespace

double CappedResponse::Slope::root() const noexcept
{
  // The root between t = 0 and t = 1, where the signs differ. The formula avoids cancellation.
  const double square = second * second - 4.0 * first * third;
  const double sum = -0.5 * (second + std::copysign(std::sqrt(std::max(0.0, square)), second));
  for (const double t : { first / sum, sum / third })
  {
    if (t > 0.0 && t < 1.0)
    {
      return t;
    }
  }
  return 0.5;
}

double CappedResponse::Slope::oppositeExtreme() const noexcept
{
  const double t = -0.5 * second / third;
  const bool isBetween = t > 0.0 && t < 1.0;
  const double extreme = first + t * (second + t * third);
  return isBetween && first * (first + second + third) > 0.0 && first * extreme < 0.0 ? t : 0.0;
}

CappedResponse::Place CappedResponse::at(double root) const noexcept
{
  const double deflection = this->Range * (root * root);
  const ResponseValue value = this->Response.evaluate(deflection);
  return { root, deflection, value.force, value.stiffness - this->Maximum };
}

/// Evaluates the curve near δ = 0. The stiffness may be infinite there, so that only the sign of
/// the excess is exact and its magnitude is limited.
CappedResponse::Place CappedResponse::atOnset(const Place& first) const noexcept
{
  constexpr double close = 1e-6;
  const double largest = this->Maximum + std::abs(first.excess);
  Place place;
  place.excess = std::clamp(this->at(close).excess, -largest, largest);
  return place;
}

/// Derivative of G = F - K_max δ between two points. G is approximated by the cubic in √δ that has
/// the values and slopes of G at these points. Then G'(t) = first + t (second + t third), with t
/// from 0 to 1.
CappedResponse::Slope CappedResponse::slopeBetween(
  const Place& low, const Place& high) const noexcept
{
  const double width = high.root - low.root;
  const double rise = high.force - low.force - this->Maximum * (high.deflection - low.deflection);
  const double first = 2.0 * this->Range * width * low.root * low.excess;
  const double last = 2.0 * this->Range * width * high.root * high.excess;
  return { first, 6.0 * rise - 4.0 * first - 2.0 * last, 3.0 * (first + last) - 6.0 * rise };
}

CappedResponse::Place CappedResponse::crossing(Place low, Place high) const noexcept
{
  const bool rises = high.excess > 0.0;
  const double enough = Accuracy * this->Maximum * high.deflection;
  double guess = this->slopeBetween(low, high).root();
  // Illinois variant of regula falsi: if one end is kept twice, its weight is halved, so that both
  // ends approach the root.
  double lowWeight = 1.0;
  double highWeight = 1.0;
  Place found = low;
  for (int i = 0; i < Refinements; ++i)
  {
    found = this->at(low.root + guess * (high.root - low.root));
    const double steepness = (std::abs(low.excess) + std::abs(high.excess)) /
      std::max(high.deflection - low.deflection, 1e-300);
    if (!(0.5 * found.excess * found.excess > steepness * enough))
    {
      break;
    }
    const bool isHigh = (found.excess > 0.0) == rises;
    (isHigh ? high : low) = found;
    lowWeight = isHigh ? 0.5 * lowWeight : 1.0;
    highWeight = isHigh ? 1.0 : 0.5 * highWeight;
    const double a = lowWeight * std::abs(low.excess);
    guess = a / (a + highWeight * std::abs(high.excess));
  }
  return found;
}

double CappedResponse::lost(double deflection, double force) const noexcept
{
  double sum = 0.0;
  Place next = this->at(1.0 / NodesInRange);
  Place last = this->atOnset(next);
  Place turn = last; // the last point below δ at which the excess changes its sign
  bool isAbove = last.excess > 0.0;
  const auto advance = [&](const Place& to)
  {
    if ((to.excess > 0.0) != isAbove)
    {
      const Place end = this->crossing(last, to);
      if (end.deflection >= deflection)
      {
        last.deflection = deflection; // the sign changes beyond δ: ends the search
        return;
      }
      sum += isAbove ? this->taken(turn, end.deflection, end.force) : 0.0;
      turn = end;
      isAbove = !isAbove;
    }
    last = to;
  };
  for (int j = 1; j <= Nodes && last.deflection < deflection; ++j)
  {
    next = j > 1 ? this->at(static_cast<double>(j) / NodesInRange) : next;
    const double between = this->slopeBetween(last, next).oppositeExtreme();
    if (between > 0.0)
    {
      advance(this->at(last.root + between * (next.root - last.root)));
    }
    if (last.deflection < deflection)
    {
      advance(next);
    }
  }
  return isAbove ? sum + this->taken(turn, deflection, force) : sum;
}

double CappedResponse::lostByRise(double deflection, double force) const noexcept
{
  const double position = std::ceil(std::sqrt(deflection / this->Range) * NodesInRange);
  int above = position < Nodes ? std::max(1, static_cast<int>(position)) : Nodes;
  int below = 0;
  Place high = this->at(static_cast<double>(above) / NodesInRange);
  Place low;
  while (above - below > 1)
  {
    const int middle = (above + below) / 2;
    const Place place = this->at(static_cast<double>(middle) / NodesInRange);
    const bool isAbove = place.excess > 0.0;
    (isAbove ? above : below) = middle;
    (isAbove ? high : low) = place;
  }
  if (below == 0)
  {
    low = this->atOnset(high);
  }
  if (!(high.excess > 0.0))
  {
    return 0.0; // the excess is not positive because of rounding at the node
  }
  const Place begin = low.excess > 0.0 ? low : this->crossing(low, high);
  return begin.deflection < deflection ? this->taken(begin, deflection, force) : 0.0;
}

[[gnu::hot]] ResponseValue CappedResponse::cap(
  double deflection, ResponseValue value) const noexcept
{
  if (!(deflection > 0.0) || !(this->Range > 0.0) || std::isinf(this->Maximum))
  {
    return value;
  }
  const bool rises = this->Response.hasRisingStiffness();
  if (rises && value.stiffness <= this->Maximum)
  {
    return value;
  }
  const double lost =
    rises ? this->lostByRise(deflection, value.force) : this->lost(deflection, value.force);
  value.force = std::max(0.0, value.force - std::max(0.0, lost));
  value.stiffness = std::min(value.stiffness, this->Maximum);
  return value;
}

ResponseValue CappedResponse::evaluate(double deflection) const noexcept
{
  return this->cap(deflection, this->Response.evaluate(deflection));
}

[[gnu::hot]] double CappedResponse::share(double deflection) const noexcept
{
  const ResponseValue value = this->Response.evaluate(deflection);
  const double whole = value.force;
  return whole > 0.0 ? std::min(1.0, this->cap(deflection, value).force / whole) : 1.0;
}
} // namespace palpate
