// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StiffnessBound_h
#define palpate_StiffnessBound_h

#include <cstddef>

namespace palpate
{
/// Returns an upper bound of the stiffness of any combined motion of contacts with the compliance
/// matrix `compliance`. This is the largest eigenvalue of the inverse matrix, overestimated by a
/// factor of at most rows^(1/16). Infinite if the matrix is not positive definite. Overwrites both
/// matrices. Costs 4 rows³ multiply-adds.
double stiffnessBound(double* compliance, double* spare, std::size_t rows) noexcept;
} // namespace palpate

#endif
