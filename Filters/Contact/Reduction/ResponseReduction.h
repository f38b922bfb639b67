// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseReduction_h
#define palpate_ResponseReduction_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// The forms of a reduced response, the fewest numbers first.
enum class ReducedForm
{
  OneLaw,   ///< every point has the same curve: no number per point
  Scale,    ///< one law for the body, times one number per point
  Basis,    ///< a few laws, combined with as many numbers per point
  Samples,  ///< a curve of its own per point, in fewer samples
  Unchanged ///< no smaller form is within the tolerance
};

/// How much a reduction may change the forces, and the largest number of laws.
struct ReductionSettings
{
  double tolerance = 0.01; ///< see reduceResponse
  int mostLaws = 8;        ///< of a basis; 1 to 16
};

/**
 * A response in fewer numbers. OneLaw, Scale and Basis: `basis`, `laws` rows of n forces then n
 * stiffnesses, and `coefficient`, `laws` per point (OneLaw: all 1, or 0 for points without
 * response). Samples: `force` and `stiffness`, n per point. Unchanged: none of them.
 */
struct ReducedResponse
{
  ReducedForm form = ReducedForm::Unchanged;
  int samples = 0;
  int laws = 0;
  std::vector<float> basis;
  std::vector<float> coefficient;
  std::vector<float> force;
  std::vector<float> stiffness;

  int numbersPerPoint = 0;        ///< stored, without normal, range and status
  double largestError = 0.0;      ///< relative error of the force, over all points and depths
  std::size_t worstPoint = 0;     ///< point of that error
  double largestSlopeError = 0.0; ///< of dF/dδ, over the point's largest dF/dδ
};

/**
 * The fewest numbers per point that reproduce every curve within a tolerance.
 *
 * Error of a point: the largest |F' - F| over depths up to its range, divided by F at that depth,
 * or by F_1 before the first sample, where the force goes to zero. It is evaluated at every point,
 * four times per interval between samples, from the numbers as they are stored (float); between
 * these depths it may be a tenth larger.
 *
 * Laws are the leading eigenvectors of the curves' Gram matrix, each curve divided by its force at
 * full range and each column by the mean there, so that small depths count as much as large ones (a
 * proper orthogonal decomposition); coefficients by least squares of the relative error. The
 * smallest number of laws whose error is within the tolerance is chosen; if there is none, the
 * fewest samples per point; if those are not fewer than before, nothing changes.
 *
 * Laws do not depend on the range: curves of different ranges need more of them.
 *
 * tolerance > 0; below about 1e-6 the rounding of floats prevails. Arrays in either form; points
 * without response (by status) are ignored. Same bits for any number of threads. Cost: about 3 µs
 * per point, core and number of laws tried, of which all except the last are tried on 4096 points.
 */
PALPATE_EXPORT ReducedResponse reduceResponse(
  const ResponseArrays& arrays, const ReductionSettings& settings);
} // namespace palpate

#endif
