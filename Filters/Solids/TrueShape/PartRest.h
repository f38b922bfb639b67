// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PartRest_h
#define palpate_PartRest_h

#include "Solids/FiniteElements/UnitLoads.h"

#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A piece of a body's surface. Its motion is the weighted mean of the motions of six nodes.
struct SurfacePiece
{
  std::array<std::int32_t, 6> nodes;
  std::array<double, 6> shape;
  Eigen::Vector3d place; ///< undeformed, mm
  double weight;         ///< mm²
};

/**
 * The body around a part that was cut out of it: the motion of the part under loads L on a place of
 * its surface, and the energy ½ Lᵀ W L that the surrounding body stores. By Betti's theorem W
 * follows from the motions: it is the compliance of the place minus the part that is due to the
 * energy stored in the part itself.
 */
struct PartRest
{
  Eigen::MatrixXd motion; ///< displacements of all nodes (mm) × loads
  Eigen::MatrixXd energy; ///< W
  Eigen::MatrixXd turns;  ///< 3 × loads: rotation of the place, rad
};

/**
 * Computes the data of the surrounding body. `part`: the part, of one material, at small strain.
 * `moved`: its motions under forces and moments. `place`: the pieces of the place. A combination of
 * the six loads is used only if it moves the place by more than 1/200 of the indentation of a
 * half-space by a contact of `radius` (mm). On coarse cells the stored energy of the other
 * combinations is not reliable and may be negative.
 */
PartRest restAround(const ElasticBody& part, const std::vector<SurfacePiece>& place,
  const UnitMotion& moved, double radius);
} // namespace palpate

#endif
