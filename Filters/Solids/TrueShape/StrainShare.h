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
  double radius = 0.0;    ///< contact radius, mm
};

/// Correction of a SmallStrainContact for finite strain, and the error of the corrected force.
struct StrainShare
{
  double force = 0.0;      ///< change of the force, N
  double deflection = 0.0; ///< change of δ at the corrected force, mm
  double error = 0.0;      ///< relative error of the force
};

/**
 * Computes the correction of a contact for finite strain. Finite strain multiplies the local part
 * of the contact, as on a half-space under the same force. The remaining deflection of the body
 * grows with the force. If `strain` is null, there is no correction, and the error is the neglected
 * effect of finite strain. Cost: microseconds.
 */
PALPATE_EXPORT StrainShare strainShare(const AxisymmetricTool& tool, const StrainCorrection* strain,
  const ElasticMaterial& material, const SmallStrainContact& contact);
} // namespace palpate

#endif
