// SPDX-License-Identifier: BSD-3-Clause
#include "TiltCircle.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tilt/TiltedSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace palpate::testing
{
namespace
{
constexpr std::size_t Radii = 64;
constexpr int Angles = 24; // number of angles of half a circle; the other half is symmetric
constexpr int Places = 30;

/// ∫_0^r √(a² - r²) dr.
double underCircle(double a, double r)
{
  const double share = std::min(r / a, 1.0);
  return 0.5 * a * a * (share * std::sqrt(1.0 - share * share) + std::asin(share));
}

/// Largest force of all circles with the centre at x, over E*.
double forceAbout(const TiltedSurface& surface, double x, double depth, double reach)
{
  const double limit = depth + 2.0 * reach;
  const double step = reach / Radii;
  std::array<double, Radii + 1> pressed{}; // u
  std::size_t known = 0;                   // number of radii whose whole circle is below the tool
  for (std::size_t i = 0; i <= Radii; ++i, ++known)
  {
    const double r = step * static_cast<double>(i);
    double sum = 0.0;
    for (int k = 0; k < Angles; ++k)
    {
      const double turn = Pi * (k + 0.5) / Angles;
      sum += depth - surface.heightAt(x + r * std::cos(turn), r * std::sin(turn), limit);
    }
    if (std::isinf(sum))
    {
      break;
    }
    pressed[i] = sum / Angles;
  }
  double largest = 0.0;
  for (std::size_t i = 1; i < known; ++i)
  {
    const double a = step * static_cast<double>(i);
    double sum = a * pressed[0];
    double before = 0.0;
    for (std::size_t j = 1; j <= i; ++j)
    {
      const double area = underCircle(a, step * static_cast<double>(j));
      sum += (pressed[j] - pressed[j - 1]) / step * (area - before);
      before = area;
    }
    largest = std::max(largest, 2.0 * sum);
  }
  return largest;
}
} // namespace

double circleForce(const AxisymmetricTool& tool, double angle, double depth)
{
  const TiltedSurface surface(tool, angle);
  const SurfaceBox box = surface.below(depth);
  const double reach = std::max(0.5 * (box.right - box.left), box.halfWidth);
  // Golden-section search along the tilt: there is one best place.
  constexpr double golden = 0.6180339887498949;
  double left = box.left;
  double right = box.right;
  double low = right - golden * (right - left);
  double high = left + golden * (right - left);
  double atLow = forceAbout(surface, low, depth, reach);
  double atHigh = forceAbout(surface, high, depth, reach);
  for (int i = 2; i < Places; ++i)
  {
    if (atLow > atHigh)
    {
      right = high;
      high = low;
      atHigh = atLow;
      low = right - golden * (right - left);
      atLow = forceAbout(surface, low, depth, reach);
    }
    else
    {
      left = low;
      low = high;
      atLow = atHigh;
      high = left + golden * (right - left);
      atHigh = forceAbout(surface, high, depth, reach);
    }
  }
  return std::max(atLow, atHigh);
}
} // namespace palpate::testing
