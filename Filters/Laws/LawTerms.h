// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LawTerms_h
#define palpate_LawTerms_h

#include "Mechanics/FiniteStrain/StrainEnergy.h"

namespace palpate
{
/// What a response takes into account beyond small strain on a flat surface, and what it tells of
/// its error; see vtkToolContactResponse.
struct LawTerms
{
  bool curvature = true;         ///< the body's sag under the tool
  StrainLaw strain;              ///< linear: small strain
  double errorTolerance = 0.05;  ///< of the force, that validity ends at; 0: as ValidityRule says
  bool storeError = true;        ///< keeps the error of each sample
  bool automatic = false;        ///< what changes the force little is left out
  double changeTolerance = 0.01; ///< of the force, relative: how little
  bool edges = false;            ///< sharp edges, as a contact leaves over them (BodyEdges)
  double tilt = 0.0;             ///< the largest of the tool, degrees; 0: it is upright

  bool keepsError() const { return this->storeError && this->errorTolerance > 0.0; }
  /// Small strain on a flat surface, valid until the first assumption breaks.
  static LawTerms plain() { return { false, {}, 0.0, false }; }
};
} // namespace palpate

#endif
