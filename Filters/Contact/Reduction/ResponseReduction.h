// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseReduction_h
#define palpate_ResponseReduction_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// The forms of a reduced response, the form with the fewest numbers first.
enum class ReducedForm
{
  OneLaw,   ///< every point has the same curve: no number per point
  Scale,    ///< one law for the body, multiplied by one number per point
  Basis,    ///< a few laws, combined by as many numbers per point
  Samples,  ///< a separate curve per point, with fewer samples
  Unchanged ///< no smaller form is within the tolerance
};

/// The permitted change of the forces, and the largest number of laws.
struct ReductionSettings
{
  double tolerance = 0.01; ///< see reduceResponse
  int mostLaws = 8;        ///< largest number of laws of a basis, 1 to 16
};

/**
 * A response with fewer numbers. OneLaw, Scale and Basis use `basis`, with `laws` rows of n forces
 * then n stiffnesses, and `coefficient`, with `laws` numbers per point (OneLaw: all 1, or 0 for
 * points without response). Samples uses `force` and `stiffness`, with n numbers each per point.
 * Unchanged uses none of them.
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

  int numbersPerPoint = 0;        ///< stored numbers, without normal, range and status
  double largestError = 0.0;      ///< relative error of the force, over all points and depths
  std::size_t worstPoint = 0;     ///< point of the largest error
  double largestSlopeError = 0.0; ///< error of dF/dδ, divided by the point's largest dF/dδ
};

/**
 * Finds the form with the fewest numbers per point that reproduces every curve within a tolerance.
 *
 * Error of a point: the largest |F' - F| over depths up to its range, divided by F at the same
 * depth, or by F_1 before the first sample, where the force tends to zero. The error is evaluated
 * at every point, at four depths per interval between samples, from the numbers as they are stored
 * (float); between these depths it may be larger by a tenth.
 *
 * Laws are the leading eigenvectors of the curves' Gram matrix (a proper orthogonal decomposition).
 * Each curve is divided by its force at full range, and each column by its mean, so that small
 * depths count as much as large ones. The coefficients minimise the squares of the relative error.
 * The smallest number of laws whose error is within the tolerance is chosen. If there is none, the
 * smallest number of samples per point is chosen; if it is not smaller than before, nothing is
 * changed.
 *
 * Laws do not depend on the range; curves of different ranges need more laws.
 *
 * The tolerance must be positive; below about 1e-6 the rounding of floats dominates. The arrays may
 * have either form; points without response (by status) are ignored. The result is bit for bit the
 * same for any number of threads. Cost: about 3 µs per point, core and number of laws tried, of
 * which all except the last are tried on 4096 points.
 */
PALPATE_EXPORT ReducedResponse reduceResponse(
  const ResponseArrays& arrays, const ReductionSettings& settings);
} // namespace palpate

#endif
