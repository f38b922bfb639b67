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
 * Compliance of a body: the motion at one point of its surface under a unit force at another point,
 * without the local dent. Motion and force are along the normals at their points. C_ij ≈ Σ_m φ_m(i)
 * φ_m(j) is symmetric and positive semi-definite.
 *
 * The modes follow from the fields of landmarks (RegularField) by Nyström's method, as in
 * GlobalModes. Only the normal components and the positive eigenvalues are used, so that the sum is
 * an energy. The whole compliance is this sum plus 1/(πE*r) of the half-space between points with
 * similar normals (BodyCoupling).
 */
struct CouplingModes
{
  /// φ_m at each surface point, one row per mode, in √(mm/N), inward along the normal. If the body
  /// has fewer modes, the last rows are zero. If the observer stopped the work, there are no rows.
  Eigen::MatrixXd values;
  /// Root mean square of C_ij - Σ φ φ over pairs of landmarks, relative to the root mean square of
  /// C_ij.
  double neglected = 0.0;
};

/// Computes the `count` largest modes (1 to MostCouplingModes) of a factorised body. The number of
/// landmarks is LandmarksPerMode times `count`; they are chosen among the points with a valid
/// compliance. Cost: one solution per landmark.
PALPATE_EXPORT CouplingModes couplingModes(const ElasticBody& body,
  const PatchCompliances& compliances, double radius, int count, const WorkObserver& observer);
} // namespace palpate

#endif
