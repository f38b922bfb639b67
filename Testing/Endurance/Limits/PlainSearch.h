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
 * is skipped only if the distance of its first corner and its longest edge exclude it.
 * The search uses the coordinates that the kernel stores. roundedBy() compares them with the
 * coordinates of the input.
 */
class PlainSearch
{
public:
  explicit PlainSearch(const PackedMesh& mesh);

  /// The triangle in the result has its number in the input.
  testing::Nearest nearest(const Vector3& tip) const;

  /// Returns the largest distance of a stored coordinate from `points` (x, y, z each), mm.
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
