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
 * The closest point of a surface by looking at every triangle: in long double, those apart that
 * their longest edge and the distance of their first corner put out of the question.
 *
 * Takes the coordinates as the kernel keeps them, which roundedBy() compares with those of the
 * input.
 */
class PlainSearch
{
public:
  explicit PlainSearch(const PackedMesh& mesh);

  /// The triangle is one of the input.
  testing::Nearest nearest(const Vector3& tip) const;

  /// How far the kernel's coordinates lie from `points` (x, y, z each) at most, mm.
  double roundedBy(const std::vector<double>& points) const;

private:
  struct Triangle
  {
    std::array<Eigen::Vector3f, 3> corner; ///< about Centre
    float reach;                           ///< of the first corner, mm, rounded up
  };
  const PackedMesh& Mesh;
  std::vector<Triangle> Triangles;
};
} // namespace palpate::endurance

#endif
