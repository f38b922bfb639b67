// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StiffnessBound_h
#define palpate_StiffnessBound_h

#include <cstddef>

namespace palpate
{
/// No motion of contacts is stiffer than this whose compliances are these, so many rows: the
/// largest eigenvalue of the inverse, no more than rows^(1/16) too large. Infinite if the matrix is
/// not positive definite. Both it and the spare one are overwritten. 4 rows³ multiply-adds.
double stiffnessBound(double* compliance, double* spare, std::size_t rows) noexcept;
} // namespace palpate

#endif
