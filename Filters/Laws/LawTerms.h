// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LawTerms_h
#define palpate_LawTerms_h

#include "Mechanics/FiniteStrain/StrainLaw.h"

namespace palpate
{
/// Options for the terms of a response and of its error beyond small strain on a flat surface; see
/// vtkToolContactResponse.
struct LawTerms
{
  bool curvature = true; ///< include the body's curvature under the tool
  StrainLaw strain;      ///< finite strain; `linear` means small strain
  /// Relative error of the force at which validity ends. With 0, validity is determined by
  /// ValidityRule.
  double errorTolerance = 0.05;
  bool storeError = true; ///< store the relative error of the force at each sample
  bool automatic = false; ///< omit terms that change the force only slightly
  /// Largest change of the force by the omitted terms, relative to the force.
  double changeTolerance = 0.01;
  bool edges = false; ///< contacts can leave the body over sharp edges (BodyEdges)
  double tilt = 0.0;  ///< largest tilt of the tool, degrees; 0 for an upright tool

  bool keepsError() const { return this->storeError && this->errorTolerance > 0.0; }
  /// Returns the options for small strain on a flat surface without edges. The law is valid until
  /// its first assumption fails.
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
