// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialRuns_h
#define palpate_TrialRuns_h

#include "ViewerOptions.h"
#include "ViewerScene.h"

#include <string>

namespace palpate
{
/// Runs the comparison in a window. The space bar switches between X and Y, and the keys 1 and 2
/// answer. The window does not reveal which alternative is X. Returns "" or an error.
std::string runTrialWindow(const ViewerOptions& options, const ViewerScene& scene);

/**
 * Runs the comparison without a display. Answers are read from the standard input, one per line. An
 * answer is 1 or 2. With a physical device, the input s switches between X and Y. Without a
 * physical device, the simulated hand presses both alternatives in virtual time, and its forces are
 * printed so that they can be compared. Returns "" or an error.
 */
std::string runTrialConsole(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
