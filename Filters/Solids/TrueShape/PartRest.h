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
  Eigen::Vector3d place; ///< undeformed position, mm
  double weight;         ///< area that the piece represents, mm²
};

/**
 * The body around a part that was cut out of it. Under loads L on a place of the part's surface,
 * the part has the motion `motion`, and the surrounding body stores the energy ½ Lᵀ W L. By Betti's
 * theorem, W follows from the motions. It is the compliance of the place minus the compliance that
 * is due to the energy stored in the part itself.
 */
struct PartRest
{
  Eigen::MatrixXd motion; ///< displacements of all nodes, mm; one column per load
  Eigen::MatrixXd energy; ///< the matrix W of the stored energy
  Eigen::MatrixXd turns;  ///< rotation of the place, rad; 3 × loads
};

/**
 * Computes the data of the surrounding body. `part` is the part at small strain; it has one
 * material. `moved` contains the motions of the part under forces and moments. `place` contains the
 * surface pieces of the place. A combination of the six loads is used only if it moves the place by
 * more than 1/200 of the indentation of a half-space by a contact of `radius` (mm). On coarse
 * cells, the stored energy of the other combinations is not reliable and may be negative.
 */
PartRest restAround(const ElasticBody& part, const std::vector<SurfacePiece>& place,
  const UnitMotion& moved, double radius);
} // namespace palpate

#endif
