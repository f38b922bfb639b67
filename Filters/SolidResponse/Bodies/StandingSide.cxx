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
// Initial held depth, as a fraction of the extent along the axis. It is also the step by which the
// depth increases.
constexpr double HeldDepth = 0.03;
constexpr int MostSteps = 5;
// Smallest held area, as a fraction of the area of the bounding box. Both areas are projected along
// the axis.
constexpr double Support = 0.25;
// Depth of a face that counts as flat, as a fraction of the extent along the axis.
constexpr double FlatDepth = 0.0005;
// Smallest flat area of a side that counts as flat, as a fraction of the held area of the side.
constexpr double FlatShare = 0.9;
constexpr double Equal = 1e-6;           // relative difference below which areas count as equal
constexpr double UpperShare = 1.0 / 1.5; // factor on the area of an upper side

struct Side
{
  int axis;
  bool isUpper;
  double held = 0.0; ///< area within HeldDepth, projected along the axis, mm²
  double flat = 0.0; ///< area within FlatDepth, projected along the axis, mm²

  double rank() const { return this->isUpper ? UpperShare * this->held : this->held; }
};

void measure(const BodyMesh& mesh, const double* bounds, double heldDepth, Side& side)
{
  side.held = 0.0;
  side.flat = 0.0;
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
    side.held += depth <= heldDepth * extent ? std::max(0.0, outward) : 0.0;
    side.flat += depth <= FlatDepth * extent ? std::max(0.0, outward) : 0.0;
  }
}

/// Rounds a depth to two significant digits.
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
  Side* best = &sides.front();
  for (Side& side : sides)
  {
    measure(mesh, bounds.data(), HeldDepth, side);
    best = side.rank() > (1.0 + Equal) * best->rank() ? &side : best;
  }
  const std::string name = joined("xyz"[best->axis], best -> isUpper ? "+" : "-");
  if (best->flat >= FlatShare * best->held)
  {
    return name;
  }
  std::array<double, 3> length{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    length[axis] = bounds[2 * axis + 1] - bounds[2 * axis];
  }
  const double extent = length[static_cast<std::size_t>(best->axis)];
  const double box = length[0] * length[1] * length[2] / extent;
  int step = 1;
  while (best->held < Support * box && step < MostSteps)
  {
    ++step;
    measure(mesh, bounds.data(), step * HeldDepth, *best);
  }
  return joined(name, ":", rounded(step * HeldDepth * extent));
}
} // namespace palpate
