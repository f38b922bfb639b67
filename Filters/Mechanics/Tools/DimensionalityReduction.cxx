// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tools/DimensionalityReduction.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Numerics/GaussLegendre.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::reduction
{
namespace
{
const GaussLegendre& startRule()
{
  static const GaussLegendre rule(32);
  return rule;
}

/// Calls piece(p, q) for each interval between neighbouring kinks from `lower` to `upper`.
template <class Piece>
void forEachPiece(double lower, double upper, const Radii& kinks, Piece&& piece)
{
  double p = lower;
  for (const double kink : kinks)
  {
    if (kink > p && kink < upper)
    {
      piece(p, kink);
      p = kink;
    }
  }
  if (p < upper)
  {
    piece(p, upper);
  }
}

/// Returns ∫_p^q f dv for an f that behaves like a power of (v - p) near p. In the first half, up
/// to the middle m, the substitution v - p = (m-p) u⁴ turns square roots into polynomials, and any
/// power above -3/4 into a function that Gauss's rule resolves.
template <class Integrand>
double fromBranchPoint(double p, double q, Integrand&& f)
{
  const double half = 0.5 * (q - p);
  const double first = startRule().integrate(0.0, 1.0,
    [&](double u)
    {
      const double cube = u * u * u;
      return f(p + half * cube * u) * 4.0 * cube;
    });
  return half * first + GaussLegendre::standard().integrate(p + half, q, f);
}

/// Returns ∫_p^q f(x, x-p) dx for an f with square roots at p and at s < p, which may be very close
/// to each other. In the first half x = (p+s)/2 + (p-s)/2 cosh φ removes both roots.
template <class Integrand>
double betweenBranchPoints(double s, double p, double q, Integrand&& f)
{
  const double width = p - s;
  const double half = 0.5 * (q - p);
  const double end = 2.0 * std::asinh(std::sqrt(half / width));
  const int panels = static_cast<int>(std::ceil(end / 12.0)); // 32 points resolve cosh φ over 12
  double sum =
    GaussLegendre::standard().integrate(p + half, q, [&](double x) { return f(x, x - p); });
  for (int i = 0; i < panels; ++i)
  {
    sum += startRule().integrate(end * i / panels, end * (i + 1) / panels,
      [&](double phi)
      {
        const double sinh = std::sinh(0.5 * phi);
        const double behind = width * sinh * sinh;
        return f(p + behind, behind) * width * sinh * std::cosh(0.5 * phi);
      });
  }
  return sum;
}

/// Returns ∫_r^a of an integrand f(x, x-r) with square roots at r and after the kinks.
template <class Integrand>
double fromRadius(double r, double a, const Radii& kinks, Integrand&& f)
{
  double before = 0.0; // the axis counts as a kink
  for (const double kink : kinks)
  {
    before = kink < r ? kink : before;
  }
  double sum = 0.0;
  forEachPiece(r, a, kinks,
    [&](double p, double q)
    {
      const auto fromStart = [&](double x, double behind) { return f(x, behind + (p - r)); };
      sum += p > before ? betweenBranchPoints(before, p, q, fromStart)
                        : fromBranchPoint(p, q, [&](double x) { return f(x, x - r); });
      before = p;
    });
  return sum;
}

/// Returns the angle θ of x = r sin θ, x <= r; accurate also for x → r.
double angleOf(double x, double r)
{
  return std::atan2(x, std::sqrt(r - x) * std::sqrt(r + x));
}

/// Returns ∫_0^a f(x) dx/√(r²-x²), r >= a, as an integral over the angle θ of x.
template <class Integrand>
double overAngles(double a, double r, const Radii& kinks, Integrand&& f)
{
  double sum = 0.0;
  forEachPiece(0.0, a, kinks,
    [&](double p, double q)
    {
      sum += fromBranchPoint(
        angleOf(p, r), angleOf(q, r), [&](double theta) { return f(r * std::sin(theta)); });
    });
  return sum;
}
} // namespace

double reducedProfile(const Function& profileSlope, double x, const Radii& kinks)
{
  return x * overAngles(x, x, kinks, profileSlope);
}

double reducedSlope(
  const Function& profileSlope, const Function& curvature, double x, const Radii& kinks)
{
  double sum =
    overAngles(x, x, kinks, [&](double r) { return profileSlope(r) + r * curvature(r); });
  for (const double kink : kinks)
  {
    if (kink < x)
    {
      constexpr double Aside = 1e-14;
      const double jump = profileSlope(kink * (1.0 + Aside)) - profileSlope(kink * (1.0 - Aside));
      sum += jump * kink / std::sqrt((x - kink) * (x + kink));
    }
  }
  return sum;
}

double force(const Function& profile, double a, double deflection, const Radii& kinks)
{
  double sum = 0.0;
  forEachPiece(0.0, a, kinks,
    [&](double p, double q)
    { sum += fromBranchPoint(p, q, [&](double x) { return deflection - profile(x); }); });
  return 2.0 * sum;
}

double pressure(const Function& slope, double r, double a, double step, const Radii& kinks)
{
  if (r == 0.0 && slope(0.0) > 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  double sum = fromRadius(
    r, a, kinks, [&](double x, double behind) { return slope(x) / std::sqrt(behind * (x + r)); });
  if (step != 0.0)
  {
    sum += step / std::sqrt((a - r) * (a + r));
  }
  return sum / Pi;
}

double normalDisplacementOutside(
  const Function& profile, double r, double a, double deflection, const Radii& kinks)
{
  return 2.0 / Pi * overAngles(a, r, kinks, [&](double x) { return deflection - profile(x); });
}

double loadInside(const Function& slope, double r, double a, double step, const Radii& kinks)
{
  // x < r contributes ∫_0^r x g'(x) dx, and x > r contributes ∫_r^a g'(x) (x - √(x²-r²)) dx.
  double core = 0.0;
  forEachPiece(0.0, r, kinks,
    [&](double p, double q)
    { core += fromBranchPoint(p, q, [&](double x) { return x * slope(x); }); });
  const double ring = fromRadius(r, a, kinks,
    [&](double x, double behind) { return slope(x) * r * r / (x + std::sqrt(behind * (x + r))); });
  const double flat = step != 0.0 ? step * r * r / (a + std::sqrt((a - r) * (a + r))) : 0.0;
  return 2.0 * (core + ring + flat);
}
} // namespace palpate::reduction
