// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary triangles as a body. The body is built and its defects are counted. In a tick on this
// body, an enumeration finds no triangle nearer than the reported triangle, and every force is
// finite. Input: numbers of points and triangles, coordinates, indices (also invalid indices),
// tips.
#include "AnyTips.h"
#include "SampleBodies.h"
#include "SampleResponses.h"
#include "Contact/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
/// Returns the smallest distance, by enumeration of the triangles that the kernel uses.
double smallestDistance(const PackedMesh& mesh, const Vector3& tip)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
  {
    smallest = std::min(smallest, mesh.project(tip, static_cast<std::int32_t>(t)).squaredDistance);
  }
  return std::sqrt(smallest);
}

/// Largest local coordinate.
double sizeOf(const PackedMesh& mesh)
{
  double largest = 0.0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 corner = mesh.corner(static_cast<std::int32_t>(t), k);
      largest = std::max(largest, corner.cwiseAbs().maxCoeff());
    }
  }
  return largest;
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider input(data, size);
  const auto points = input.ConsumeIntegralInRange<std::size_t>(1, 40);
  const auto triangles = input.ConsumeIntegralInRange<std::size_t>(1, 60);
  std::vector<double> coordinates(3 * points);
  for (double& coordinate : coordinates)
  {
    coordinate = anyNumber(input);
  }
  std::vector<std::int32_t> corners(3 * triangles);
  for (std::int32_t& corner : corners)
  {
    corner = input.ConsumeIntegralInRange<std::int32_t>(0, 31) > 0
      ? input.ConsumeIntegralInRange<std::int32_t>(0, static_cast<std::int32_t>(points) - 1)
      : input.ConsumeIntegral<std::int32_t>();
  }
  ResponseStore store(points);
  const ContactBody body(coordinates.data(), points, corners.data(), triangles, store.arrays());
  require(body.surface.triangleCount() + body.surface.defects().notFinite +
        body.surface.defects().badIndex + body.surface.defects().degenerate +
        body.surface.defects().repeatedTriangles + body.surface.defects().hiddenTriangles ==
      triangles,
    "each triangle takes part or is counted");
  for (std::size_t t = 0; t < body.surface.triangleCount(); ++t)
  {
    const std::int32_t of = body.surface.inputTriangle(static_cast<std::int32_t>(t));
    require(of >= 0 && of < static_cast<std::int64_t>(triangles), "a triangle is one of the input");
  }
  const Vector3 tip(anyNumber(input), anyNumber(input), anyNumber(input));
  const SurfacePoint closest = body.tree.closest(tip);
  const bool reaches = tip.allFinite() && body.surface.triangleCount() > 0;
  require(
    (closest.triangle >= 0) == reaches, "a finite tip has a closest triangle if there is one");
  if (reaches && !body.tree.isBeyondHorizon(body.surface.toLocal(tip)))
  {
    const double smallest = smallestDistance(body.surface, body.surface.toLocal(tip));
    // Both distances are computed in double from the same coordinates, which are at most as large
    // as the body.
    require(
      std::abs(closest.signedDistance) <= smallest * (1.0 + 1e-9) + 1e-12 * sizeOf(body.surface),
      "no triangle is closer than the closest");
  }
  feelAround(body, triangles, input);
  return 0;
}
