// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OutputCheck_h
#define palpate_OutputCheck_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/// Why a file of the end of the session cannot be written, or "", to be checked before the start.
/// The output folder is not checked, since it is created when needed.
std::string outputProblem(const ViewerOptions& options);
} // namespace palpate

#endif
