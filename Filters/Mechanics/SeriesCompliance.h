// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SeriesCompliance_h
#define palpate_SeriesCompliance_h

#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/// One point of a curve F(δ): force (N), dF/dδ (N/mm), and the local part of the deflection (mm).
struct SeriesPoint
{
  double force = 0.0;
  double stiffness = 0.0;
  double localDeflection = 0.0;
  /// False if no stable point exists, because a negative compliance has folded the curve.
  bool stable = true;
};

/**
 * Computes local and global deformation in series: δ = δ_local(F; tool) + C F.
 *
 * The global deformation is C F. The structural compliance C (mm/N) does not depend on the tool
 * (St. Venant, Castigliano). The law of the tool gives the local deformation. A negative C (a rigid
 * base close to the surface) is allowed until 1 + C dF/dδ_local = 0, where the curve folds. The
 * equation is solved by Newton's method, which is monotone because F(δ_local) is convex. Cost:
 * about five evaluations of the local law.
 */
PALPATE_EXPORT SeriesPoint seriesResponse(
  const IndentationLaw& local, double reducedModulus, double compliance, double deflection);
} // namespace palpate

#endif
