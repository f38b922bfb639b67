// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PartRest_h
#define palpate_PartRest_h

#include "Solids/FiniteElements/UnitLoads.h"

#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A piece of a body's surface, which moves as six nodes do, by their shares.
struct SurfacePiece
{
  std::array<std::int32_t, 6> nodes;
  std::array<double, 6> shape;
  Eigen::Vector3d place; ///< undeformed, mm
  double weight;         ///< mm²
};

/**
 * What is around a part that was cut out of a larger body: how it moves the part with loads L on a
 * place of its surface, and the energy ½ Lᵀ W L that it stores. W follows from the motions by
 * Betti's theorem: what the loads move the place by, less what the part itself stores meanwhile.
 */
struct PartRest
{
  Eigen::MatrixXd motion; ///< displacements of all nodes (mm) × loads
  Eigen::MatrixXd energy; ///< W
  Eigen::MatrixXd turns;  ///< 3 × loads: of the place, rad
};

/**
 * Of a part of one material, small strain, the motions by forces and moments being known, the place
 * in pieces. Of the six kinds of load are kept those that move the place by more than a
 * two-hundredth of what a contact of `radius` (mm) on a half-space gives way by: coarse cells do
 * not tell what others store, which can come out as less than nothing.
 */
PartRest restAround(const ElasticBody& part, const std::vector<SurfacePiece>& place,
  const UnitMotion& moved, double radius);
} // namespace palpate

#endif
