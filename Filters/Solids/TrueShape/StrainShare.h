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

/// What finite strain adds to such a contact, or may.
struct StrainShare
{
  double force = 0.0;      ///< N
  double deflection = 0.0; ///< mm, under the force with that
  double error = 0.0;      ///< of the force, relative
};

/**
 * Finite strain multiplies what is local of a contact, as on a half-space under the same force;
 * what the body gives way otherwise grows with the force. `strain` null: the body is taken at small
 * strain, and the error tells what that may miss. Cost: microseconds.
 */
PALPATE_EXPORT StrainShare strainShare(const AxisymmetricTool& tool, const StrainCorrection* strain,
  const ElasticMaterial& material, const SmallStrainContact& contact);
} // namespace palpate

#endif
