// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltGeometry.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tilt/CubicSpline.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace palpate
{
namespace
{
constexpr double Degree = Pi / 180.0;
// Margin between the largest tilt and the tilt at which the flank touches the body along its
// length.
constexpr double Margin = 4.0 * Degree;
// At larger tilts the body's surface cannot be treated as a plane.
constexpr double LargestTilt = 80.0 * Degree;
// Distance from the tip at which a flank has its final slope.
constexpr double FarRadius = 1e6;

/// A point of the profile.
struct Place
{
  double r;
  double f;
};

DeepestPoint seenTilted(const Place& place, double angle)
{
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  return { std::max(0.0, place.r * sine - place.f * cosine), place.r * cosine + place.f * sine };
}

/// Returns the deepest point of a sampled profile. It is one of the given points, because the
/// profile is straight between these points.
Place deepestOf(const std::vector<ProfilePoint>& points, double angle)
{
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const auto drop = [&](const ProfilePoint& point) { return point.r * sine - point.f * cosine; };
  const ProfilePoint& deepest = *std::max_element(points.begin(), points.end(),
    [&](const ProfilePoint& a, const ProfilePoint& b) { return drop(a) < drop(b); });
  return { deepest.r, deepest.f };
}

/// Returns the deepest point of a profile given as a function: the deepest sample, refined by
/// golden-section search.
Place deepestOf(const AxisymmetricTool& tool, double angle)
{
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const auto drop = [&](double r) { return r * sine - tool.profile(r) * cosine; };
  double end = tool.largestContactRadius();
  if (std::isinf(end))
  {
    end = 1.0;
    for (int i = 0; i < 100 && tool.profile(end) * cosine < 2.0 * end * sine; ++i)
    {
      end *= 2.0;
    }
  }
  constexpr int Samples = 1000;
  int best = 0;
  for (int i = 1; i <= Samples; ++i)
  {
    best = drop(end * i / Samples) > drop(end * best / Samples) ? i : best;
  }
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = end * std::max(0, best - 1) / Samples;
  double high = end * std::min(Samples, best + 1) / Samples;
  for (int i = 0; i < 60; ++i)
  {
    const double p = high - ratio * (high - low);
    const double q = low + ratio * (high - low);
    (drop(p) > drop(q) ? high : low) = drop(p) > drop(q) ? q : p;
  }
  const double r = drop(end) > drop(0.5 * (low + high)) ? end : 0.5 * (low + high);
  return { r, tool.profile(r) };
}

Place deepestPlace(const AxisymmetricTool& tool, double angle)
{
  const std::optional<ToolSpecification> known = knownSpecification(tool);
  if (!known)
  {
    return deepestOf(tool, angle);
  }
  const ToolSpecification& s = *known;
  const double slope = std::tan(angle);
  double r = 0.0;
  switch (s.Shape)
  {
    case ToolShape::Cone:
      break;
    case ToolShape::Flat:
    case ToolShape::TruncatedCone:
      r = s.Radius;
      break;
    case ToolShape::Sphere:
    case ToolShape::BluntedCone:
      r = s.Radius * std::sin(angle);
      break;
    case ToolShape::Paraboloid:
      r = s.Radius * slope;
      break;
    case ToolShape::RoundedFlat:
      r = s.Radius + s.EdgeRadius * slope;
      break;
    case ToolShape::PowerLaw:
      r = s.Exponent > 1.0
        ? std::pow(slope / (s.Exponent * s.Coefficient), 1.0 / (s.Exponent - 1.0))
        : 0.0;
      break;
    case ToolShape::Profile:
      return deepestOf(s.Profile, angle);
  }
  return { r, tool.profile(r) };
}

/// Returns the tilt at which the steepest part of the flank is parallel to the body's surface, rad;
/// a right angle if there is no such tilt.
double flankAngle(const AxisymmetricTool& tool)
{
  const std::optional<ToolSpecification> known = knownSpecification(tool);
  if (known && known->Shape == ToolShape::Profile)
  {
    const std::vector<ProfilePoint>& points = known->Profile;
    double steepest = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      const ProfilePoint& p = points[i - 1];
      const ProfilePoint& q = points[i];
      steepest = std::max(steepest, (q.f - p.f) / (q.r - p.r));
    }
    return steepest > 0.0 ? std::atan(steepest) : 0.5 * Pi;
  }
  if (std::isfinite(tool.largestContactRadius()))
  {
    return 0.5 * Pi; // no such tilt: the tool is a sphere or has a vertical wall
  }
  double reach = std::max(1.0, tool.smallestContactRadius());
  reach = tool.kinks().empty() ? reach : std::max(reach, tool.kinks().back());
  const double far = FarRadius * reach;
  return std::atan((tool.profile(2.0 * far) - tool.profile(far)) / far);
}
} // namespace

DeepestPoint deepestPoint(const AxisymmetricTool& tool, double angle)
{
  if (!(angle > 0.0))
  {
    return {};
  }
  return seenTilted(deepestPlace(tool, angle), angle);
}

double largestTilt(const AxisymmetricTool& tool)
{
  return std::clamp(flankAngle(tool) - Margin, 0.0, LargestTilt);
}

std::string checkTilt(const AxisymmetricTool& tool, double angle)
{
  const double largest = largestTilt(tool);
  if (!(angle > 0.0))
  {
    return joined("the largest tilt must be positive (degrees), but is ", angle / Degree);
  }
  if (largest <= 0.0)
  {
    return joined("the tool's flank rises by ", flankAngle(tool) / Degree,
      " degrees only and lies on the body when the tool is tilted; there is no law for a tilt of ",
      angle / Degree, " degrees");
  }
  constexpr double Rounding = 1e-9; // tolerance for angles converted from degrees
  return angle <= largest + Rounding
    ? ""
    : joined("a tilt of ", angle / Degree, " degrees is too much for this tool: ",
        largest < LargestTilt ? "its flank lies on the body soon after "
                              : "there is no law beyond ",
        largest / Degree, " degrees");
}

double dropScaleOf(const AxisymmetricTool& tool)
{
  const double angle = std::min(0.5, largestTilt(tool));
  // The offset of a rim is the same at any tilt. For a paraboloid the offset of the deepest point
  // is proportional to the tilt.
  constexpr double First = 0.02;
  constexpr double Half = 0.5;
  constexpr double RimScale = 3.0; // a flat end is in full contact for D >= 3 h
  return deepestPoint(tool, First * angle).offset > Half * deepestPoint(tool, angle).offset &&
      deepestPoint(tool, angle).offset > 0.0
    ? RimScale
    : 0.0;
}

ToolDrop::ToolDrop(const AxisymmetricTool& tool, double largest)
  : Largest(largest)
{
  for (int k = 0; k < Angles; ++k)
  {
    // The smallest angle is not exactly 0, because a rim is the deepest point only for tilts above
    // 0.
    constexpr double LeastAngle = 1e-9;
    const double angle = std::max(LeastAngle, static_cast<double>(k) / (Angles - 1)) * largest;
    const DeepestPoint deepest = deepestPoint(tool, angle);
    this->Nodes.push_back(k == 0 ? 0.0 : deepest.drop);
    this->Nodes.push_back(deepest.offset);
  }
}

DeepestPoint ToolDrop::at(double angle) const
{
  constexpr int Cells = Angles - 1;
  const double width = this->Largest / Cells;
  const double place = angle / width;
  const int cell = std::clamp(static_cast<int>(place), 0, Cells - 1);
  const double* node = this->Nodes.data() + 2 * static_cast<std::size_t>(cell);
  if (angle >= this->Largest)
  {
    return { node[2] + (angle - this->Largest) * node[3], node[3] };
  }
  const double t = place - cell;
  const CubicCell drop(node[2] - node[0], node[1] * width, node[3] * width);
  return { node[0] + drop.value(t), drop.slope(t) / width };
}
} // namespace palpate
