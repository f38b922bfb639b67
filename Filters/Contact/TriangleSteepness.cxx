// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TriangleSteepness.h"

#include "Contact/TrianglePlane.h"

#include <algorithm>
#include <array>

namespace palpate
{
float steepnessOf(const PackedMesh& mesh, std::int32_t triangle)
{
  const auto cornersOf = [&mesh](std::int32_t t) -> std::array<Vector3, 3> {
    return { mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2) };
  };
  const TrianglePlane plane(cornersOf(triangle));
  double slope = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const auto corner = static_cast<std::size_t>(k);
    mesh.visitAround(mesh.corners(triangle)[corner],
      [&](std::int32_t other)
      {
        // The neighbour across the edge that ends here was met where that begins.
        if (other != triangle && other != mesh.neighbour(triangle, (k + 2) % 3))
        {
          slope = std::max(slope, plane.slopeTo(cornersOf(other), corner, slope));
        }
      });
  }
  const double rounded = 0.5 * slope / plane.smallestAltitude() * (1.0 + 1e-6); // up, in float
  return static_cast<float>(rounded);
}
} // namespace palpate
