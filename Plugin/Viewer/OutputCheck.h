// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OutputCheck_h
#define palpate_OutputCheck_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/// Checks before the session starts whether its files can be written at the end. Returns "" or the
/// reason why a file cannot be written. The output folder is not checked, because it is created
/// when needed.
std::string outputProblem(const ViewerOptions& options);
} // namespace palpate

#endif
