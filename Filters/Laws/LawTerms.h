// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LawTerms_h
#define palpate_LawTerms_h

#include "Mechanics/FiniteStrain/StrainLaw.h"

namespace palpate
{
/// The terms of a response and of its error beyond small strain on a flat surface; see
/// vtkToolContactResponse.
struct LawTerms
{
  bool curvature = true; ///< the body's curvature under the tool
  StrainLaw strain;      ///< linear: small strain
  /// Relative error of the force at which validity ends; 0: validity by ValidityRule.
  double errorTolerance = 0.05;
  bool storeError = true; ///< store the error of each sample
  bool automatic = false; ///< omit terms that change the force little
  /// Largest change of the force by omitted terms, relative to the force.
  double changeTolerance = 0.01;
  bool edges = true; ///< contacts can leave the body over sharp edges (BodyEdges)
  double tilt = 0.0; ///< largest tilt of the tool, degrees; 0: upright

  bool keepsError() const { return this->storeError && this->errorTolerance > 0.0; }
  /// Returns the terms for small strain on a flat surface without edges. The law is valid until its
  /// first assumption fails.
  static LawTerms plain()
  {
    LawTerms terms;
    terms.curvature = false;
    terms.errorTolerance = 0.0;
    terms.storeError = false;
    terms.edges = false;
    return terms;
  }
};
} // namespace palpate

#endif
