// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/ProfileTool.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Number of samples per step of the slope for a profile that is not convex.
constexpr int RisesPerStep = 8;

std::string pointText(std::size_t i, const ProfilePoint& point)
{
  return "profile point " + std::to_string(i) + " (r = " + shortestDecimals(point.r) +
    ", f = " + shortestDecimals(point.f) + ")";
}
} // namespace

std::string ProfileTool::checkLast(const std::vector<ProfilePoint>& points)
{
  const std::size_t i = points.size() - 1;
  const ProfilePoint& point = points[i];
  if (!std::isfinite(point.r) || !std::isfinite(point.f))
  {
    return pointText(i, point) + " must be finite (mm)";
  }
  if (i == 0)
  {
    return point.r == 0.0 && point.f == 0.0 ? std::string()
                                            : pointText(i, point) + " must be the tip, (0, 0)";
  }
  if (!(point.r > points[i - 1].r))
  {
    return pointText(i, point) + " must lie farther from the axis than the one before, at r = " +
      shortestDecimals(points[i - 1].r);
  }
  return point.f >= 0.0 ? std::string()
                        : pointText(i, point) +
      " lies below the tip: the tool touches there first, and the law of a central contact holds "
      "at no δ > 0";
}

std::string ProfileTool::check(const std::vector<ProfilePoint>& points)
{
  std::vector<ProfilePoint> before;
  for (const ProfilePoint& point : points)
  {
    before.push_back(point);
    std::string fault = checkLast(before);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return points.size() >= 2
    ? std::string()
    : "a profile needs two points or more, but has " + std::to_string(points.size());
}

ProfileTool::ProfileTool(std::vector<ProfilePoint> points)
  : Points(std::move(points))
{
  double slope = 0.0;
  bool convex = true;
  for (std::size_t i = 0; i + 1 < this->Points.size(); ++i)
  {
    const ProfilePoint& p = this->Points[i];
    const ProfilePoint& q = this->Points[i + 1];
    const double next = (q.f - p.f) / (q.r - p.r);
    // The computed slopes of equally steep segments differ by the rounding errors of their end
    // points.
    const double rounding = 4e-16 * (q.f + p.f) / (q.r - p.r);
    if (std::abs(next - slope) > rounding)
    {
      this->Steps.push_back({ SlopeStep(p.r), next - slope });
      convex = convex && next > slope;
      slope = next;
    }
  }
  if (!convex)
  {
    this->Limit = findDepthLimit([this](double r) { return this->profile(r); },
      [this](double x) { return this->reducedProfile(x); }, this->kinks(),
      this->largestContactRadius());
  }
  this->findRises();
  const double middle = std::min(
    this->depthAtContactRadius(0.5 * this->largestContactRadius()), 0.5 * this->Limit.depth);
  if (middle > 0.0)
  {
    const IndentationPoint at = this->evaluate(middle, 1.0);
    this->MiddleExponent = at.stiffness * middle / at.force;
  }
}

/// Finds the running maxima of g. For a convex profile g increases everywhere; other profiles are
/// sampled.
void ProfileTool::findRises()
{
  double level = 0.0;
  const bool sampled = std::any_of(
    this->Steps.begin(), this->Steps.end(), [](const Step& step) { return step.change < 0.0; });
  const int count = sampled ? RisesPerStep : 1;
  for (std::size_t i = 0; i < this->Steps.size(); ++i)
  {
    const double begin = this->Steps[i].unit.radius();
    const double end =
      i + 1 < this->Steps.size() ? this->Steps[i + 1].unit.radius() : this->largestContactRadius();
    const double whole = std::sqrt((end - begin) * (end + begin));
    for (int k = 1; k <= count; ++k)
    {
      const double t = whole * k / count;
      const double g = this->behind(i, t).value;
      if (g > level)
      {
        level = g;
        this->Rises.push_back({ i, t, g });
      }
    }
  }
}

std::string ProfileTool::specification() const
{
  return formatProfile(this->Points);
}

double ProfileTool::profile(double r) const
{
  const auto next = std::lower_bound(this->Points.begin() + 1, this->Points.end(), r,
    [](const ProfilePoint& point, double radius) { return point.r < radius; });
  if (next == this->Points.end())
  {
    return Infinity;
  }
  const ProfilePoint& p = *(next - 1);
  return p.f + (r - p.r) * (next->f - p.f) / (next->r - p.r);
}

std::vector<double> ProfileTool::kinks() const
{
  std::vector<double> radii;
  for (const Step& step : this->Steps)
  {
    if (step.unit.radius() > 0.0)
    {
      radii.push_back(step.unit.radius());
    }
  }
  if (this->Steps.empty())
  {
    radii.push_back(this->largestContactRadius());
  }
  return radii;
}

double ProfileTool::smallestContactRadius() const
{
  return this->Steps.empty() ? this->largestContactRadius() : this->Steps.front().unit.radius();
}

double ProfileTool::reducedProfile(double x) const
{
  double sum = std::isnan(x) ? x : 0.0;
  for (const Step& step : this->Steps)
  {
    if (!(step.unit.radius() < x))
    {
      break;
    }
    sum += step.change * step.unit.reducedProfile(x);
  }
  return sum;
}

double ProfileTool::reducedSlope(double x) const
{
  double sum = 0.0;
  for (const Step& step : this->Steps)
  {
    sum += step.unit.radius() <= x ? step.change * step.unit.reducedSlope(x) : 0.0;
  }
  return sum;
}

/// Returns g at x = √(r²+t²) beyond a step of radius r, and dg/dt = Σ m_i (A_i + r_i/√(x²-r_i²))
/// t/x. g is accurate even if x rounds to r.
ValueAndSlope ProfileTool::behind(std::size_t step, double t) const
{
  const double r = this->Steps[step].unit.radius();
  const double x = std::hypot(r, t);
  double angles = 0.0;
  double roots = 0.0;
  for (std::size_t i = 0; i < step; ++i)
  {
    const double b = this->Steps[i].unit.radius();
    const double q = std::sqrt((r - b) * (r + b) + t * t);
    angles += this->Steps[i].change * std::atan2(q, b);
    roots += this->Steps[i].change * b / q;
  }
  angles += this->Steps[step].change * std::atan2(t, r);
  return { x * angles, (angles * t + roots * t + this->Steps[step].change * r) / x };
}

double ProfileTool::radiusAt(double deflection) const
{
  const auto rise = std::upper_bound(this->Rises.begin(), this->Rises.end(), deflection,
    [](double depth, const Rise& each) { return depth < each.level; });
  if (rise == this->Rises.end())
  {
    return this->largestContactRadius();
  }
  Rise before = { rise->step, 0.0, 0.0 };
  if (rise != this->Rises.begin())
  {
    const Rise& last = *(rise - 1);
    before.t = last.step == rise->step ? last.t : 0.0;
    before.level = last.level;
  }
  const double share = (deflection - before.level) / (rise->level - before.level);
  const double t = increasingRoot(
    [&](double at)
    {
      const ValueAndSlope g = this->behind(rise->step, at);
      return ValueAndSlope{ g.value - deflection, g.slope };
    },
    before.t, rise->t, before.t + share * (rise->t - before.t));
  return std::hypot(this->Steps[rise->step].unit.radius(), t);
}

double ProfileTool::forcePerModulus(double a, double deflection) const
{
  double integral = 0.0;
  for (const Step& step : this->Steps)
  {
    integral += step.change * step.unit.reducedIntegral(a);
  }
  return 2.0 * (a * deflection - integral);
}

double ProfileTool::pressurePerModulus(double r, double a, double deflection) const
{
  const double punch =
    a < this->largestContactRadius() ? 0.0 : std::max(0.0, deflection - this->reducedProfile(a));
  double sum = punch > 0.0 ? punch / (Pi * std::sqrt((a - r) * (a + r))) : 0.0;
  for (const Step& step : this->Steps)
  {
    if (step.unit.radius() == r && r < a)
    {
      return step.change * Infinity;
    }
    sum += step.change * step.unit.pressure(r, a);
  }
  return sum;
}

double ProfileTool::normalDisplacementOutside(double r, double a, double deflection) const
{
  double sum = 2.0 / Pi * (deflection - this->reducedProfile(a)) * std::asin(a / r);
  for (const Step& step : this->Steps)
  {
    sum += step.change * step.unit.normalDisplacementOutside(r, a);
  }
  return sum;
}

double ProfileTool::loadInside(double r, double a, double deflection) const
{
  double sum = 2.0 * this->rimStep(a, deflection) * r * r / (a + std::sqrt((a - r) * (a + r)));
  for (const Step& step : this->Steps)
  {
    sum += step.change * step.unit.loadInside(r, a);
  }
  return sum;
}

double ProfileTool::depthAtContactRadius(double a) const
{
  if (!(a > 0.0 && a <= this->largestContactRadius()))
  {
    return std::isnan(a) ? a : a > 0.0 ? Infinity : 0.0;
  }
  // Uses the largest g at radii up to a, because g may decrease.
  double level = this->reducedProfile(a);
  for (const Rise& rise : this->Rises)
  {
    if (std::hypot(this->Steps[rise.step].unit.radius(), rise.t) < a)
    {
      level = std::max(level, rise.level);
    }
  }
  return level;
}

double ProfileTool::depthAtStrain(double ratio) const
{
  if (!(ratio > 0.0))
  {
    return std::isnan(ratio) ? ratio : 0.0;
  }
  // Finds the first rise at which δ/a = g(a)/a exceeds the ratio, then the crossing before this
  // rise.
  double low = 0.0;
  for (const Rise& rise : this->Rises)
  {
    const double high = std::hypot(this->Steps[rise.step].unit.radius(), rise.t);
    if (rise.level > ratio * high)
    {
      if (rise.step == 0 && this->Steps[0].unit.radius() == 0.0 && low == 0.0)
      {
        return 0.0; // the first segment is a cone, with the same strain at every depth
      }
      const double begin = std::max(low, this->Steps[rise.step].unit.radius());
      const double a = increasingRoot(
        [&](double x)
        {
          const double g = this->reducedProfile(x);
          return ValueAndSlope{ g / x - ratio, (this->reducedSlope(x) - g / x) / x };
        },
        begin, high, high);
      return ratio * a;
    }
    low = high;
  }
  return ratio * this->largestContactRadius(); // beyond all rises, the contact ends at the wall
}
} // namespace palpate
