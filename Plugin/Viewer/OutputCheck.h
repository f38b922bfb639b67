// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OutputCheck_h
#define palpate_OutputCheck_h

#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/// Why a file that is to be written at the end cannot be, or "": said before anybody has begun.
/// The output folder is not asked about, since it is made when it is needed.
std::string outputProblem(const ViewerOptions& options);
} // namespace palpate

#endif
