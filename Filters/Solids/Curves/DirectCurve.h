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

/// Settings for the curves of direct contact.
struct DirectTerms
{
  const AxisymmetricTool* tool = nullptr;
  ElasticMaterial material;
  double depth = 1.0;           ///< depth at the end of the curves, mm
  double errorTolerance = 0.05; ///< error that limits Validity, > 0
  /// The correction for half-spaces; null for small strain.
  const StrainCorrection* strain = nullptr;
  /// Whether the contact is solved at finite strain, with the Neo-Hookean law.
  bool solvesFiniteStrain = false;
};

/// A contact on one mesh. It contains the solution at finite strain, or the solution at small
/// strain, which is later corrected for finite strain.
struct DirectPress
{
  ContactCurve finite;
  std::unique_ptr<DirectContact> small;
};

/// Returns whether the forces on two meshes agree at the depth `terms.depth`. Their relative
/// difference must not exceed the larger of the tolerance and the error of a single mesh.
PALPATE_EXPORT bool meshesAgree(
  const DirectPress& finer, const DirectPress& coarser, const DirectTerms& terms);

/// Result of direct contact at a point, as stored in the array `Direct`.
enum class DirectOutcome : unsigned char
{
  NotPressed = 0,
  Replaced = 1, ///< the point has the curve of direct contact
  Kept = 2,     ///< the point keeps its former curve, whose error is smaller
  Failed = 3    ///< no converged contact was found
};

/**
 * Replaces a point's curve by the curve of direct contact if the estimated error of the new curve
 * at `terms.depth` is smaller than the error of the former curve, or smaller than the difference of
 * the two curves. On entry, the spans contain the former curve with its errors.
 *
 * If finite strain is solved, the force is that of the finer mesh. The error is the root of the sum
 * of the squares of three parts: the difference of the two meshes and 0.01 (Elements); the error
 * due to small strain in the surrounding body (Strain, see pressAtFiniteStrain); and the error of
 * storage.
 *
 * Otherwise the force is the mean of two forces, corrected for finite strain. One is computed with
 * pressures along the mean normal, the other with each pressure along the normal of its facet. The
 * error has these parts: half of the difference of the two forces, because the theory of small
 * displacements cannot decide between them (Curvature); the error of the elements (Elements); the
 * error of finite strain or of its correction (Strain); and the error of storage.
 *
 * The result is Failed if one of the meshes has no contact up to `terms.depth`. At small strain,
 * the result is also Failed if the tool touches another place before it reaches the point, and the
 * distance that remains to the point exceeds `terms.depth`.
 *
 * At small depths, the contact is no larger than a facet. Therefore the curve approaches the former
 * curve in proportion to √δ below the first sample at which direct contact has the smaller error.
 */
PALPATE_EXPORT DirectOutcome takeDirectCurve(std::size_t point, const DirectPress& finer,
  const DirectPress& coarser, const DirectTerms& terms, const ResponseSampling& sampling,
  const ResponseSpans& spans);
} // namespace palpate

#endif
