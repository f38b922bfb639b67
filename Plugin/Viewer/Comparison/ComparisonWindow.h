// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComparisonWindow_h
#define palpate_ComparisonWindow_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * Runs --compare in a window, with a session on each body. The mouse moves both tools to the same
 * point. The keys 1 to 9 choose the tool, m chooses the colours of the bodies, and q closes the
 * window. After the window is closed, the results at the last contact are printed. Returns "" or an
 * error.
 */
std::string runComparisonWindow(const ViewerOptions& options);
} // namespace palpate

#endif
