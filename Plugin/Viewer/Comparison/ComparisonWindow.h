// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComparisonWindow_h
#define palpate_ComparisonWindow_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * Runs --compare in a window, with a session on each body. One mouse moves both tools to the same
 * place. Keys 1 to 9 choose the tool, m the colours of the bodies, q ends. Returns when the window
 * is closed, after printing the results at the last contact. Returns "" or an error.
 */
std::string runComparisonWindow(const ViewerOptions& options);
} // namespace palpate

#endif
