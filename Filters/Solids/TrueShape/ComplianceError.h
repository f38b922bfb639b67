// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComplianceError_h
#define palpate_ComplianceError_h

#include "Solids/FiniteElements/PatchCompliance.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * How far the compliances of a body's surface may be off by its elements, mm/N, >= 0, one per
 * surface point. Estimated at some ten points, well apart; at the others in the proportion in which
 * the elements let expect it by their place (ElementError), the proportion carried by the inverse
 * square of the distance. NaN everywhere if none of those points can be pressed.
 *
 * There 2 |C - C'| + 4 e: C' is found another way on the same elements, with the singular field
 * subtracted (SubtractedLoad), which shows what the patches do; e, the energy that the elements'
 * stresses lack of smooth ones (energyErrors), what both have in common, as stiffness against
 * bending. The factors are such that it holds for hexahedra, linear and quadratic tetrahedra on
 * layers and plates, from one element through the thickness on, and ν to 0.49.
 *
 * `compliances` as of patchCompliances() for all points, of a factorised body. Cost: that of a
 * solution and 100 µs per element, ten times, on threadCount() threads; the same for any number.
 * Empty when the observer stopped it.
 */
PALPATE_EXPORT std::vector<double> complianceErrors(
  const ElasticBody& body, const PatchCompliances& compliances, const WorkObserver& observer);
} // namespace palpate

#endif
