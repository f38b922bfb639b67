// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectCurve_h
#define palpate_DirectCurve_h

#include "Contact/ResponseSampling.h"
#include "Laws/ResponseFiller.h"
#include "Mechanics/FiniteElements/ElasticElement.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/TrueShape/DirectContact.h"

#include <cstddef>

namespace palpate
{
class StrainCorrection;

/// How curves of direct contact are made.
struct DirectTerms
{
  const AxisymmetricTool* tool = nullptr;
  ElasticMaterial material;
  double depth = 1.0;                       ///< mm, to which curves go
  double errorTolerance = 0.05;             ///< to which Validity is found, > 0
  const StrainCorrection* strain = nullptr; ///< of half-spaces; null: small strain
};

/// What direct contact made of a point: the values of the array `Direct`.
enum class DirectOutcome : unsigned char
{
  NotPressed = 0,
  Replaced = 1, ///< the point's curve
  Kept = 2,     ///< the law's, which is better known
  Failed = 3    ///< no contact was found that settles
};

/**
 * Replaces a point's curve by that of direct contact, where its estimated error at `terms.depth` is
 * less than that of the curve that is there, or less than what the two differ by. The spans hold
 * the curve that is there, with its errors.
 *
 * The force is the mean of those of pressures along the mean normal and along each its own, on the
 * finer mesh. Its error, the root of the squares of: half of what these two differ by, which small
 * displacements cannot decide (Curvature); what the two meshes differ by, and a hundredth
 * (Elements); what finite strain, or its correction, lacks (Strain); storage. Towards the surface,
 * where the contact gets as small as its facets, the curve goes over to the one that was there, by
 * √δ, from the sample on at which that is better known.
 */
PALPATE_EXPORT DirectOutcome takeDirectCurve(std::size_t point, const DirectContact& finer,
  const DirectContact& coarser, const DirectTerms& terms, const ResponseSampling& sampling,
  const ResponseSpans& spans);
} // namespace palpate

#endif
