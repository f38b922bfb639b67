// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_PlainSearch_h
#define palpate_endurance_PlainSearch_h

#include "BruteForce.h"
#include "Contact/PackedMesh.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace palpate::endurance
{
/**
 * Finds the closest point of a surface by a search over every triangle, in long double. A triangle
 * is skipped only if its longest edge and the distance of its first corner exclude it.
 * The search uses the coordinates as the kernel stores them. roundedBy() compares these with the
 * coordinates of the input.
 */
class PlainSearch
{
public:
  explicit PlainSearch(const PackedMesh& mesh);

  /// The triangle number is that of the input.
  testing::Nearest nearest(const Vector3& tip) const;

  /// Largest distance of a kernel coordinate from `points` (x, y, z each), mm.
  double roundedBy(const std::vector<double>& points) const;

private:
  struct Triangle
  {
    std::array<Eigen::Vector3f, 3> corner; ///< relative to Centre
    float reach; ///< largest distance from the first corner, mm, rounded up
  };
  const PackedMesh& Mesh;
  std::vector<Triangle> Triangles;
};
} // namespace palpate::endurance

#endif
