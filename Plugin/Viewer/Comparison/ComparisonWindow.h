// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComparisonWindow_h
#define palpate_ComparisonWindow_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/**
 * --compare in a window: a session on each body, one mouse moves the tool of both to the same
 * place. Keys 1 to 9 choose the tool, m the colours of the bodies, q ends; then prints the results
 * at the last contact. Returns when the window is closed; an error, or "".
 */
std::string runComparisonWindow(const ViewerOptions& options);
} // namespace palpate

#endif
