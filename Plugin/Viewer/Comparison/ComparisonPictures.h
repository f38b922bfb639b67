// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComparisonPictures_h
#define palpate_ComparisonPictures_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * Runs --compare without a window. The tools perform the same motion on both bodies, in virtual
 * time. The function writes these files to the output folder:
 * - comparison.png: the bodies under the first tool at the end of the press, with the curves of all
 * tools and the verdicts;
 * - regime.png: λ, sensitivity and verdict over both bodies;
 * - strip.csv and block.csv: the trajectories.
 *
 * Prints the results. Returns "" or an error.
 */
std::string runComparison(const ViewerOptions& options);
} // namespace palpate

#endif
