// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialRuns_h
#define palpate_TrialRuns_h

#include "ViewerOptions.h"
#include "ViewerScene.h"

#include <string>

namespace palpate
{
/// The comparison in a window: space switches, 1 and 2 answer; nothing reveals which is which.
/// Returns an error, or "".
std::string runTrialWindow(const ViewerOptions& options, const ViewerScene& scene);

/**
 * The comparison without a display, answers from the standard input, a line each: 1 or 2; with a
 * physical device also s, which switches. The simulated hand presses both in virtual time, and its
 * forces are printed for the answer. Returns an error, or "".
 */
std::string runTrialConsole(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
