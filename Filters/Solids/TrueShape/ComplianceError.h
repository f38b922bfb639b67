// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComplianceError_h
#define palpate_ComplianceError_h

#include "Solids/FiniteElements/PatchCompliance.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Returns the error of the compliances of a body's surface due to the elements, mm/N, >= 0, one
 * value per surface point. The error is estimated at about ten well separated points. At the other
 * points, it is a factor times the error that ElementError predicts. The factor is interpolated
 * from the ten points with weights of 1/distance². All values are NaN if none of the ten points can
 * be pressed.
 *
 * The error at a sample point is 2 |C - C'| + 4 e. C' is a second compliance on the same elements,
 * computed with the singular field subtracted (SubtractedLoad). The difference shows the error of
 * the patches. e is the energy of the difference between the elements' stresses and smoothed
 * stresses (energyErrors). It represents the error that both methods share, such as excess
 * stiffness in bending. The factors are chosen such that the bound holds for hexahedra and linear
 * and quadratic tetrahedra on layers and plates, with one or more elements through the thickness
 * and ν up to 0.49.
 *
 * `compliances` is the result of patchCompliances() for all points of a factorised body. Cost: ten
 * times one solution plus 100 µs per element, on threadCount() threads. The result does not depend
 * on the number of threads. It is empty if the observer stopped the work.
 */
PALPATE_EXPORT std::vector<double> complianceErrors(
  const ElasticBody& body, const PatchCompliances& compliances, const WorkObserver& observer);
} // namespace palpate

#endif
