// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DisplayCheck_h
#define palpate_DisplayCheck_h

#include <string>

namespace palpate
{
/// Why nothing can be drawn, or "". Without an X server that answers, VTK would abort the process
/// at the first picture.
std::string displayProblem();
} // namespace palpate

#endif
