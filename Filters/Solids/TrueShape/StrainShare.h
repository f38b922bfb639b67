// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainShare_h
#define palpate_StrainShare_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
class AxisymmetricTool;
class StrainCorrection;

/// A contact at small strain, on a body of any shape.
struct SmallStrainContact
{
  double force = 0.0;     ///< N
  double stiffness = 0.0; ///< N/mm
  double radius = 0.0;    ///< mm
};

/// Correction of such a contact for finite strain, and its error.
struct StrainShare
{
  double force = 0.0;      ///< N
  double deflection = 0.0; ///< change of δ at the corrected force, mm
  double error = 0.0;      ///< relative error of the force
};

/**
 * Finite strain multiplies the local part of a contact, as on a half-space under the same force.
 * The remaining deflection of the body grows with the force. `strain` null: small strain, with the
 * neglected effect as the error. Cost: microseconds.
 */
PALPATE_EXPORT StrainShare strainShare(const AxisymmetricTool& tool, const StrainCorrection* strain,
  const ElasticMaterial& material, const SmallStrainContact& contact);
} // namespace palpate

#endif
