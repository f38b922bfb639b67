// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CouplingModes_h
#define palpate_CouplingModes_h

#include "Solids/FiniteElements/PatchCompliance.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
constexpr int MostCouplingModes = 16;

/**
 * Compliance of a body: motion at one place of its surface under a force at another place, both
 * along the normals of their places, without the local dent: C_ij ≈ Σ_m φ_m(i) φ_m(j), symmetric
 * and positive semi-definite.
 *
 * The modes follow from the fields of landmarks (RegularField) by Nyström's method, as in
 * GlobalModes, but only from the normal parts and with positive eigenvalues, so that the sum is an
 * energy. Together with the half-space's 1/(πE*r) between places that face the same way
 * (BodyCoupling) the sum is the whole compliance.
 */
struct CouplingModes
{
  /// φ_m at each surface point, one row per mode: √(mm/N), inward along the normal. Zero rows if
  /// the body has fewer modes. No rows if the observer stopped the work.
  Eigen::MatrixXd values;
  /// Root mean square of C_ij - Σ φ φ over pairs of landmarks, relative to that of C_ij.
  double neglected = 0.0;
};

/// Computes the `count` largest modes (1 to MostCouplingModes) of a factorised body, from
/// LandmarksPerMode times as many landmarks among the points with a valid compliance. Cost: one
/// solution per landmark.
PALPATE_EXPORT CouplingModes couplingModes(const ElasticBody& body,
  const PatchCompliances& compliances, double radius, int count, const WorkObserver& observer);
} // namespace palpate

#endif
