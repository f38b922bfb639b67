// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltedSurface.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
TiltedSurface::TiltedSurface(const AxisymmetricTool& tool, double angle)
  : Tool(tool)
  , Sine(std::sin(angle))
  , Cosine(std::cos(angle))
  , Drop(deepestPoint(tool, angle).drop)
{
  // Coordinates of the deepest point: x = r cos θ + f sin θ and -h = f cos θ - r sin θ. They are
  // rotated back to obtain r.
  const DeepestPoint deepest = deepestPoint(tool, angle);
  this->Deepest = deepest.offset * this->Cosine + deepest.drop * this->Sine;
}

/// Returns the height of a point above the profile, measured along the tool's axis; negative
/// outside the tool.
double TiltedSurface::insideAt(double x, double y, double z) const
{
  return x * this->Sine + z * this->Cosine -
    this->Tool.profile(std::hypot(x * this->Cosine - z * this->Sine, y));
}

double TiltedSurface::heightAt(double x, double y, double limit) const
{
  const double bottom = -this->Drop;
  if (this->Sine == 0.0)
  {
    const double height = this->Tool.profile(std::hypot(x, y));
    return height < limit ? height : Infinity;
  }
  // Steps upwards until the point is inside the tool. The flank of a convex tool may end above, so
  // that a higher point may again be outside.
  constexpr int Steps = 16;
  double low = bottom;
  double lowValue = this->insideAt(x, y, low);
  double high = low;
  double highValue = lowValue;
  for (int i = 1; i <= Steps && highValue < 0.0; ++i)
  {
    low = high;
    lowValue = highValue;
    high = bottom + limit * i / Steps;
    highValue = this->insideAt(x, y, high);
  }
  if (highValue < 0.0)
  {
    return Infinity;
  }
  // Regula falsi with halved end values (Illinois), or bisection if the point is at a wall.
  double z = high;
  for (int i = 0; i < 60 && high - low > 1e-13 * (limit + this->Drop); ++i)
  {
    const bool isWall = std::isinf(lowValue) || lowValue == highValue;
    z = isWall ? 0.5 * (low + high) : (low * highValue - high * lowValue) / (highValue - lowValue);
    const double value = this->insideAt(x, y, z);
    if (value == 0.0)
    {
      break;
    }
    if (value > 0.0)
    {
      high = z;
      highValue = value;
      lowValue *= 0.5;
    }
    else
    {
      low = z;
      lowValue = value;
      highValue *= 0.5;
    }
  }
  return std::max(0.0, z + this->Drop);
}

SurfaceBox TiltedSurface::below(double limit) const
{
  // Searches the radii at which the lowest point is below the limit. The search starts at the
  // deepest point, with smaller steps near it.
  const double wall = this->Tool.largestContactRadius();
  const auto isLow = [&](double r)
  { return this->Tool.profile(r) * this->Cosine - r * this->Sine + this->Drop < limit; };
  double end = std::max({ this->Deepest, limit, this->Tool.smallestContactRadius() });
  for (int i = 0; i < 100 && end < wall && isLow(end); ++i)
  {
    end *= 2.0;
  }
  end = std::min(end, wall);
  constexpr int Steps = 400;
  double inner = this->Deepest;
  double outer = this->Deepest;
  for (int i = 0; i < Steps; ++i)
  {
    const auto along = [](int k) { return std::pow(static_cast<double>(k) / Steps, 3.0); };
    const double out = this->Deepest + (end - this->Deepest) * along(i);
    const double in = this->Deepest * (1.0 - along(i));
    outer = isLow(out) ? this->Deepest + (end - this->Deepest) * along(i + 1) : outer;
    inner = isLow(in) ? this->Deepest * (1.0 - along(i + 1)) : inner;
  }
  SurfaceBox box{ Infinity, -Infinity, 0.0 };
  const auto add = [&](double r, double f)
  {
    constexpr int Turns = 64;
    for (int i = 0; i <= Turns; ++i)
    {
      const double along = r * std::cos(Pi * i / Turns);
      if (f * this->Cosine - along * this->Sine + this->Drop <= limit)
      {
        const double x = along * this->Cosine + f * this->Sine;
        box.left = std::min(box.left, x);
        box.right = std::max(box.right, x);
        box.halfWidth = std::max(box.halfWidth, r * std::sin(Pi * i / Turns));
      }
    }
  };
  constexpr int Radii = 96;
  for (int i = 0; i <= Radii; ++i)
  {
    const double r = inner + (outer - inner) * i / Radii;
    add(r, this->Tool.profile(r));
  }
  if (outer >= wall) // the box also extends upwards along the wall
  {
    const double rim = this->Tool.profile(wall);
    const double rise = limit - (rim * this->Cosine - wall * this->Sine + this->Drop);
    for (int i = 0; i <= Radii && rise > 0.0 && this->Sine > 0.0; ++i)
    {
      add(wall, rim + rise / this->Cosine * i / Radii);
    }
  }
  const double margin = 0.04 * std::max(box.right - box.left, 2.0 * box.halfWidth);
  return { box.left - margin, box.right + margin, box.halfWidth + margin };
}
} // namespace palpate
