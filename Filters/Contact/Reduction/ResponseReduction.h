// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseReduction_h
#define palpate_ResponseReduction_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// The forms of a reduced response, from the fewest to the most stored numbers.
enum class ReducedForm
{
  OneLaw,   ///< every point has the same curve; no number per point is stored
  Scale,    ///< one law for the body, multiplied by one number per point
  Basis,    ///< a few laws per body, with one number per point for each law
  Samples,  ///< a separate curve per point, with fewer samples
  Unchanged ///< no smaller form is within the tolerance
};

/// The permitted change of the forces, and the largest number of laws.
struct ReductionSettings
{
  double tolerance = 0.01; ///< permitted relative error; see reduceResponse()
  int mostLaws = 8;        ///< largest number of laws of a basis, 1 to 16
};

/**
 * A response with fewer stored numbers. OneLaw, Scale and Basis use `basis`, with `laws` rows of n
 * forces followed by n stiffnesses, and `coefficient`, with `laws` numbers per point. With OneLaw
 * the coefficients are 1, or 0 for points without response. Samples uses `force` and `stiffness`,
 * each with n numbers per point. Unchanged uses none of these arrays.
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

  int numbersPerPoint = 0;    ///< stored numbers per point, without normal, range and status
  double largestError = 0.0;  ///< largest relative error of the force over all points and depths
  std::size_t worstPoint = 0; ///< point with the largest error
  double largestSlopeError = 0.0; ///< error of dF/dδ, divided by the point's largest dF/dδ
};

/**
 * Finds the form with the fewest numbers per point that reproduces every curve within a tolerance.
 *
 * The error of a point is the largest |F' - F| over depths up to its range, divided by F at the
 * same depth. Before the first sample, where the force tends to zero, the divisor is F_1. The error
 * is evaluated at every point, at four depths per interval between samples, from the numbers as
 * they are stored (float). Between these depths it may be larger by a tenth.
 *
 * Laws are the leading eigenvectors of the curves' Gram matrix (a proper orthogonal decomposition).
 * Each curve is divided by its force at full range, and each column by its mean, so that small
 * depths count as much as large ones. The coefficients minimise the sum of squares of the relative
 * error. The smallest number of laws whose error is within the tolerance is chosen. If no number of
 * laws suffices, the smallest sufficient number of samples per point is chosen. If this number is
 * not smaller than before, the response is not changed.
 *
 * The laws do not depend on the range, so that curves with different ranges need more laws.
 *
 * The tolerance must be positive. Below about 1e-6 the rounding of floats dominates. The arrays may
 * be in either form. Points without response (by status) are ignored. The result is bit for bit the
 * same for any number of threads. Cost: about 3 µs per point on one core for each number of laws
 * tried; all numbers except the last are tried on 4096 points only.
 */
PALPATE_EXPORT ReducedResponse reduceResponse(
  const ResponseArrays& arrays, const ReductionSettings& settings);
} // namespace palpate

#endif
