// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/PartOverlap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
using Vector3 = Eigen::Vector3d;
// Distance of the tested points from the surface, as a fraction of the size of the surface.
constexpr double Away = 1e-5;

/// Returns the k-th point of a sequence that covers a triangle evenly (Roberts' R2). No point of
/// the sequence is above an edge of a regular mesh.
Vector3 placeOn(const std::array<Vector3, 3>& corners, std::size_t k)
{
  const auto part = [k](double first, double step)
  {
    const double sum = first + step * static_cast<double>(k);
    return sum - std::floor(sum);
  };
  double x = part(0.6823, 0.7548776662466927);
  double y = part(0.4302, 0.5698402909980532);
  if (x + y > 1.0)
  {
    x = 1.0 - x;
    y = 1.0 - y;
  }
  return corners[0] + x * (corners[1] - corners[0]) + y * (corners[2] - corners[0]);
}
} // namespace

PartOverlap::PartOverlap(const std::vector<TriangleColumns::Corners>& surface, double size,
  const TriangleColumns& solid, const Eigen::AlignedBox3d& box)
{
  if (surface.empty())
  {
    return;
  }
  const auto isIn = [&](const Vector3& place)
  { return box.contains(place) && solid.crossingsAbove(place) % 2 == 1; };
  const std::size_t each = std::max<std::size_t>(1, Places / surface.size());
  std::size_t within = 0;
  std::size_t on = 0;
  for (const TriangleColumns::Corners& corners : surface)
  {
    const Vector3 outward =
      Away * size * (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (std::size_t k = 0; k < each; ++k)
    {
      const Vector3 place = placeOn(corners, k);
      const bool isOutsideIn = isIn(place + outward);
      const bool isInsideIn = isIn(place - outward);
      within += isOutsideIn && isInsideIn;
      on += isOutsideIn != isInsideIn;
    }
  }
  const auto all = static_cast<double>(each * surface.size());
  this->inside = static_cast<double>(within) / all;
  this->touching = static_cast<double>(on) / all;
}
} // namespace palpate
