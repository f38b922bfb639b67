// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectCurve_h
#define palpate_DirectCurve_h

#include "Contact/ResponseSampling.h"
#include "Laws/ResponseFiller.h"
#include "Solids/FiniteElements/ElasticElement.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/DirectContact.h"
#include "Solids/TrueShape/FiniteContact.h"

#include <cstddef>
#include <memory>

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
  bool solvesFiniteStrain = false;          ///< finite strain is solved for; the law is Neo-Hooke's
};

/// A contact on one mesh: at finite strain, or, where that is not solved for, what is to be
/// corrected for it.
struct DirectPress
{
  ContactCurve finite;
  std::unique_ptr<DirectContact> small;
};

/// Whether the forces on two meshes agree at the depth, within the tolerance or what one mesh
/// knows.
PALPATE_EXPORT bool meshesAgree(
  const DirectPress& finer, const DirectPress& coarser, const DirectTerms& terms);

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
 * Where finite strain is solved for the force is that of the finer mesh. Its error, the root of the
 * squares of: what the two meshes differ by, and a hundredth (Elements); what is around
 * moves as at small strain (Strain, pressAtFiniteStrain); storage.
 *
 * Otherwise it is the mean of those of pressures along the mean normal and along each its own, with
 * the correction for finite strain, and of the error are: half of what these two differ by, which
 * small displacements cannot decide (Curvature); Elements; what finite strain, or its correction,
 * lacks (Strain); storage.
 *
 * Failed: one of the meshes has no contact to that depth, or, at small strain, one that touches
 * before by more than that.
 *
 * Towards the surface, where the contact gets as small as its facets, the curve goes over to the
 * one that was there, by √δ, from the sample on at which that is better known.
 */
PALPATE_EXPORT DirectOutcome takeDirectCurve(std::size_t point, const DirectPress& finer,
  const DirectPress& coarser, const DirectTerms& terms, const ResponseSampling& sampling,
  const ResponseSpans& spans);
} // namespace palpate

#endif
