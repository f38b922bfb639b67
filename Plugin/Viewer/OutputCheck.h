// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OutputCheck_h
#define palpate_OutputCheck_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/// Returns "", or the reason why a file cannot be written at the end of the session. Must be called
/// before the start. The output folder is not checked, since it is created when needed.
std::string outputProblem(const ViewerOptions& options);
} // namespace palpate

#endif
