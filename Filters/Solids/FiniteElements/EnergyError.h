// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EnergyError_h
#define palpate_EnergyError_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Returns the energy of the difference between the elements' stresses σ and smoothed stresses σ*, ∫
 * (σ* - σ) : D⁻¹ : (σ* - σ) dV, N mm, for each displacement of all nodes (3 × nodes, mm). σ* is
 * interpolated from the mean stress at each node over elements of nearly equal modulus (Zienkiewicz
 * and Zhu 1987). The integral estimates the square of the error in the energy norm. Under a force
 * of 1 N, the integral is the error of the compliance in mm/N.
 *
 * Cost: 20 µs per element, plus 2 µs per displacement. Thread-safe.
 */
PALPATE_EXPORT std::vector<double> energyErrors(
  const ElasticBody& body, const std::vector<Eigen::Matrix3Xd>& displacements);

/// The error is at most this factor times the estimate. This holds for hexahedra and for linear and
/// quadratic tetrahedra on layers and plates with one or more elements through the thickness.
constexpr double BoundOfEnergy = 4.0;
} // namespace palpate

#endif
