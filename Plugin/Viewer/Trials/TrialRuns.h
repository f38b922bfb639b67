// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialRuns_h
#define palpate_TrialRuns_h

#include "ViewerOptions.h"
#include "ViewerScene.h"

#include <string>

namespace palpate
{
/// The comparison in a window: the space bar switches, 1 and 2 answer. Nothing reveals which
/// alternative is X. Returns "" or an error.
std::string runTrialWindow(const ViewerOptions& options, const ViewerScene& scene);

/**
 * The comparison without a display. Answers are read from the standard input, one per line: 1 or 2;
 * with a physical device also s, which switches. Without one, the simulated hand presses both
 * alternatives in virtual time, and its forces are printed for the answer. Returns "" or an error.
 */
std::string runTrialConsole(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
