// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_UnitLoads_h
#define palpate_UnitLoads_h

#include "Solids/FiniteElements/ElasticBody.h"

#include <array>

namespace palpate
{
/// How nodes move, 3 × nodes, under a force of 1 N along x, y, z at a place, and a moment of 1 N mm
/// about x, y, z through it.
struct UnitMotion
{
  Eigen::Vector3d about = Eigen::Vector3d::Zero(); ///< the place, mm
  std::array<Eigen::Matrix3Xd, 6> nodes;           ///< mm
};

/// A place in an element, by its own coordinates (ElasticElement.h).
struct ElementPlace
{
  std::int32_t element = -1;
  Eigen::Vector3d xi = Eigen::Vector3d::Zero();
};

/**
 * Of a body's nodes, the loads being on the nodes of one element beside the place: what is some
 * elements away knows their resultant alone (St. Venant). What of them is on held nodes moves
 * nothing. Empty where memory is short. Cost: six solutions.
 */
PALPATE_EXPORT UnitMotion unitMotion(
  const ElasticBody& body, const Eigen::Vector3d& place, const ElementPlace& beside);

/**
 * Of a part that was cut out of a larger body and is held on the cut, all loads of which are on
 * that: `cut` tells how the nodes there move in the larger one, and is not used elsewhere.
 * Cost: six solutions. Empty where memory is short.
 */
PALPATE_EXPORT UnitMotion motionFromCut(const ElasticBody& part, UnitMotion cut);
} // namespace palpate

#endif
