// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/VisibleDent.h"

#include "Solids/FiniteElements/HalfSpaceField.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double DentEnds = 0.5;            // cos 60°; beyond this angle the dent is not included
constexpr double DentIsWhole = 0.642787610; // cos 50°; up to this angle the whole dent is included
} // namespace

std::vector<double> dentFades(const BodySurface& surface, std::int32_t point)
{
  std::vector<double> fades(static_cast<std::size_t>(surface.pointTotal()), 0.0);
  std::vector<unsigned char> seen(fades.size(), 0);
  std::vector<std::int32_t> front = { point };
  seen[static_cast<std::size_t>(point)] = 1;
  while (!front.empty())
  {
    const std::int32_t at = front.back();
    front.pop_back();
    const double facing = std::clamp(
      (surface.normal(at).dot(surface.normal(point)) - DentEnds) / (DentIsWhole - DentEnds), 0.0,
      1.0);
    fades[static_cast<std::size_t>(at)] = facing * facing * (3.0 - 2.0 * facing);
    for (const std::int32_t* t = surface.trianglesBegin(at); t != surface.trianglesEnd(at); ++t)
    {
      for (const std::int32_t next : surface.triangle(*t))
      {
        if (!seen[static_cast<std::size_t>(next)] &&
          surface.normal(next).dot(surface.normal(point)) > DentEnds)
        {
          seen[static_cast<std::size_t>(next)] = 1;
          front.push_back(next);
        }
      }
    }
  }
  return fades;
}

Eigen::Vector3d dentAt(const BodySurface& surface, std::int32_t point, std::int32_t at,
  double nearest, double poissonRatio)
{
  const Eigen::Vector3d chord = surface.position(at) - surface.position(point);
  const Eigen::Vector3d& normal = surface.normal(at);
  // If the chord is along the normal, the zero vector remains zero.
  const Eigen::Vector3d away = (chord - chord.dot(normal) * normal).normalized();
  const Eigen::Vector3d flat = boussinesqDisplacement(
    Eigen::Vector3d(std::max(chord.norm(), nearest), 0.0, 0.0), poissonRatio);
  return flat[0] * away - flat[2] * surface.normal(point);
}
} // namespace palpate
