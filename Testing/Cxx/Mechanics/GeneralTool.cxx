// SPDX-License-Identifier: BSD-3-Clause
#include "GeneralTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/DimensionalityReduction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LargestSearched = 1e9; // mm, largest contact radius that is searched
} // namespace

GeneralTool::GeneralTool(Shape shape)
  : Given(std::move(shape))
{
  if (std::isfinite(this->Given.outer) && this->Given.flat < this->Given.outer)
  {
    this->Limit = findDepthLimit(
      this->Given.profile, [this](double x) { return this->reducedProfile(x); }, this->Given.kinks,
      this->Given.outer);
  }
}

double GeneralTool::profile(double r) const
{
  return std::isnan(r) ? r : r <= this->Given.outer ? this->Given.profile(r) : Infinity;
}

double GeneralTool::reducedProfile(double x) const
{
  if (!(x > this->Given.flat))
  {
    return std::isnan(x) ? x : 0.0;
  }
  return reduction::reducedProfile(this->Given.slope, x, this->Given.kinks);
}

double GeneralTool::reducedSlope(double x) const
{
  if (x < this->Given.flat || this->Given.flat >= this->Given.outer)
  {
    return 0.0;
  }
  return x > 0.0
    ? reduction::reducedSlope(this->Given.slope, this->Given.curvature, x, this->Given.kinks)
    : 0.5 * Pi * this->Given.slope(0.0);
}

/// The radius at which `excess`, a function of x, first exceeds 0; the outer radius if it never
/// does. The search runs between neighbouring kinks over t with x² = kink² + t², because g is
/// analytic in t.
double GeneralTool::passage(const std::function<ValueAndSlope(double)>& excess) const
{
  double begin = this->Given.flat;
  double end = this->Given.outer;
  for (const double kink : this->Given.kinks)
  {
    if (kink > begin && kink < end && excess(kink).value <= 0.0)
    {
      begin = kink;
    }
    else if (kink > begin)
    {
      end = std::min(end, kink);
      break;
    }
  }
  if (std::isinf(end))
  {
    end = begin > 0.0 ? 2.0 * begin : 1.0;
    while (excess(end).value <= 0.0)
    {
      end *= 2.0;
      if (!(end < LargestSearched))
      {
        return Infinity;
      }
    }
  }
  if (begin >= end || excess(end).value <= 0.0)
  {
    return this->Given.outer;
  }
  const double whole = std::sqrt((end - begin) * (end + begin));
  const double t = increasingRoot(
    [&](double at)
    {
      const double x = std::hypot(begin, at);
      const ValueAndSlope found = excess(x);
      return ValueAndSlope{ found.value, found.slope * at / x };
    },
    0.0, whole, whole);
  return std::hypot(begin, t);
}

double GeneralTool::radiusAt(double deflection) const
{
  return this->passage(
    [&](double x) {
      return ValueAndSlope{ this->reducedProfile(x) - deflection, this->reducedSlope(x) };
    });
}

double GeneralTool::forcePerModulus(double a, double deflection) const
{
  return reduction::force(
    [this](double x) { return this->reducedProfile(x); }, a, deflection, this->Given.kinks);
}

double GeneralTool::depthAtStrain(double ratio) const
{
  if (!(ratio > 0.0))
  {
    return std::isnan(ratio) ? ratio : 0.0;
  }
  return ratio *
    this->passage(
      [&](double x) {
        return ValueAndSlope{ this->reducedProfile(x) - ratio * x, this->reducedSlope(x) - ratio };
      });
}

double GeneralTool::depthAtContactRadius(double a) const
{
  return std::isnan(a) ? a : a > this->Given.outer ? Infinity : this->reducedProfile(a);
}
} // namespace palpate
