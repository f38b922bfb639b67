// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/StandingSide.h"

#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double HeldDepth = 0.03;   // fraction of the extent along the axis
constexpr double FlatDepth = 0.0005; // fraction of the extent within which a face counts as flat
constexpr double FlatShare = 0.9; // smallest fraction of the area within FlatDepth, for a flat side
constexpr double EqualAreas = 1e-6; // relative difference of equal areas

struct Side
{
  int axis;
  bool isUpper;
  double held = 0.0; ///< area within HeldDepth, seen along the axis, mm²
  double flat = 0.0; ///< area within FlatDepth, seen along the axis, mm²
};

void measure(const BodyMesh& mesh, const double* bounds, Side& side)
{
  const double low = bounds[2 * side.axis];
  const double high = bounds[2 * side.axis + 1];
  const double extent = high - low;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    const TriangleCorners& corners = mesh.corners(t);
    const Vector3 a = mesh.point(corners[0]);
    const Vector3 b = mesh.point(corners[1]);
    const Vector3 c = mesh.point(corners[2]);
    const double along = 0.5 * (b - a).cross(c - a)[side.axis];
    const double middle = (a + b + c)[side.axis] / 3.0;
    const double outward = side.isUpper ? along : -along;
    const double depth = side.isUpper ? high - middle : middle - low;
    side.held += depth <= HeldDepth * extent ? std::max(0.0, outward) : 0.0;
    side.flat += depth <= FlatDepth * extent ? std::max(0.0, outward) : 0.0;
  }
}

/// Rounds to two significant digits.
double rounded(double depth)
{
  const double unit = std::pow(10.0, std::floor(std::log10(depth)) - 1.0);
  return unit * std::round(depth / unit);
}
} // namespace

std::string standingSide(vtkPolyData* surface)
{
  const BodyMesh mesh = makeBodyMesh(surface);
  std::array<double, 6> bounds{};
  surface->GetBounds(bounds.data());
  std::array<Side, 6> sides = { { { 2, false }, { 1, false }, { 0, false }, { 2, true },
    { 1, true }, { 0, true } } };
  const Side* best = &sides.front();
  for (Side& side : sides)
  {
    measure(mesh, bounds.data(), side);
    best = side.held > (1.0 + EqualAreas) * best->held ? &side : best;
  }
  const std::string name = joined("xyz"[best->axis], best -> isUpper ? "+" : "-");
  const double extent = bounds[static_cast<std::size_t>(2 * best->axis + 1)] -
    bounds[static_cast<std::size_t>(2 * best->axis)];
  return best->flat >= FlatShare * best->held ? name
                                              : joined(name, ":", rounded(HeldDepth * extent));
}
} // namespace palpate
