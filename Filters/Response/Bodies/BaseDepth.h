// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BaseDepth_h
#define palpate_BaseDepth_h

#include <cstddef>

namespace palpate
{
/// Criteria for a dark base under brighter tissue along a ray of grey values.
struct BaseCriteria
{
  double baseValue;         ///< grey value; a sample below this value is dark
  std::ptrdiff_t edge;      ///< width of a blurred edge in samples, > 0
  std::ptrdiff_t darkCount; ///< smallest number of dark samples of a base
};

/**
 * Returns the start of the first dark base as a number of samples from the start of a ray. Returns
 * +inf if the ray has no base.
 *
 * The search begins at the first sample that is not dark, and ends at the first sample that is not
 * finite. A run of dark samples is a base if it is long enough, and if its lowest value within one
 * edge width is at most half the highest value of the tissue within one edge width above the run.
 * The base begins where the grey level falls through the mean of these two values. This level gives
 * the position of a sharp edge for any blur by the partial-volume effect.
 */
double findBaseDepth(const double* grey, std::size_t count, const BaseCriteria& criteria);
} // namespace palpate

#endif
