// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_UnitLoads_h
#define palpate_UnitLoads_h

#include "Solids/FiniteElements/ElasticBody.h"

#include <array>

namespace palpate
{
/// Displacements of the nodes, 3 × nodes, under six unit loads at a position: forces of 1 N along
/// x, y, z, and moments of 1 N mm about x, y, z through the position.
struct UnitMotion
{
  Eigen::Vector3d about = Eigen::Vector3d::Zero(); ///< position of the loads, mm
  /// Displacements of the nodes, mm, one matrix per load.
  std::array<Eigen::Matrix3Xd, 6> nodes;
};

/// A position in an element, in the element's own coordinates (ElasticElement.h).
struct ElementPlace
{
  std::int32_t element = -1;
  Eigen::Vector3d xi = Eigen::Vector3d::Zero();
};

/**
 * Computes the motion of a body's nodes under unit loads at `place`. The loads are applied to the
 * nodes of the element `beside`, which is near `place`. At a distance of a few elements, only the
 * resultant of the loads matters (St. Venant). Loads on held nodes have no effect. The result is
 * empty if there is not enough memory. Cost: six solutions.
 */
PALPATE_EXPORT UnitMotion unitMotion(
  const ElasticBody& body, const Eigen::Vector3d& place, const ElementPlace& beside);

/**
 * Computes the motion of a part that was cut out of a larger body and is held on the cut. All loads
 * act on the part. `cut` contains the motion of the nodes on the cut in the larger body. Its values
 * at other nodes are not used. The result is empty if there is not enough memory. Cost: six
 * solutions.
 */
PALPATE_EXPORT UnitMotion motionFromCut(const ElasticBody& part, UnitMotion cut);
} // namespace palpate

#endif
