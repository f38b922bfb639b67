// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LawTerms_h
#define palpate_LawTerms_h

#include "Mechanics/FiniteStrain/StrainLaw.h"

namespace palpate
{
/// The terms of a response beyond small strain on a flat surface, and of its error; see
/// vtkToolContactResponse.
struct LawTerms
{
  bool curvature = true;         ///< the body's curvature under the tool
  StrainLaw strain;              ///< linear: small strain
  double errorTolerance = 0.05;  ///< error of the force at which validity ends; 0: by ValidityRule
  bool storeError = true;        ///< keeps the error of each sample
  bool automatic = false;        ///< leaves out terms that change the force little
  double changeTolerance = 0.01; ///< relative to the force, of such terms
  bool edges = false;            ///< contacts leave over sharp edges (BodyEdges)
  double tilt = 0.0;             ///< the largest of the tool, degrees; 0: it is upright

  bool keepsError() const { return this->storeError && this->errorTolerance > 0.0; }
  /// Small strain on a flat surface, valid until its first assumption breaks.
  static LawTerms plain() { return { false, {}, 0.0, false }; }
};
} // namespace palpate

#endif
