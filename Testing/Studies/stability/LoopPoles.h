// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_LoopPoles_h
#define palpate_testing_LoopPoles_h

#include <vector>

namespace palpate::testing
{
/**
 * The largest |z| of the poles of a linear loop, identified from its motion alone. The readings x_k
 * around any rest position satisfy d_{k+n} = Σ a_i d_{k+i} with d_k = x_{k+1} - x_k. The a_i come
 * from least squares; the poles are the eigenvalues of their companion matrix. Below 1 the loop is
 * stable. Needs 2 order + 1 readings; a few more average out rounding.
 */
double largestPole(const std::vector<double>& readings, int order);
/// As largestPole(), only for poles that oscillate by more than 0.01 rad per tick; 0 if there is
/// none. Slow creep, as in a body that relaxes, has poles so near 1 that they cannot be
/// distinguished from 1.
double largestSwingingPole(const std::vector<double>& readings, int order);
} // namespace palpate::testing

#endif
