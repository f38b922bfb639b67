// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BaseDepth_h
#define palpate_BaseDepth_h

#include <cstddef>

namespace palpate
{
/// Criteria of the dark base under brighter tissue along a ray of grey values.
struct BaseCriteria
{
  double baseValue;         ///< below it, a sample is dark
  std::ptrdiff_t edge;      ///< samples over which an edge is spread, > 0
  std::ptrdiff_t darkCount; ///< least number of dark samples of a base
};

/**
 * Where the first dark base begins, in samples from the start of a ray; +inf where there is none.
 *
 * The ray begins at the first sample that is not dark, and ends at the first that is not finite. A
 * dark run is a base if it is long enough and its lowest value, within an edge, is at most half the
 * highest value of the tissue within an edge above it. The base begins where the grey level falls
 * through the mean of the two, which is where a sharp edge lies, however it was blurred by partial
 * volume.
 */
double findBaseDepth(const double* grey, std::size_t count, const BaseCriteria& criteria);
} // namespace palpate

#endif
