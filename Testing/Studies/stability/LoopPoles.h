// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_LoopPoles_h
#define palpate_testing_LoopPoles_h

#include <vector>

namespace palpate::testing
{
/**
 * The largest |z| of the poles of a linear loop, told from its motion alone. Its readings x_k about
 * any place of rest obey d_{k+n} = Σ a_i d_{k+i} with d_k = x_{k+1} - x_k; the a_i by least
 * squares, the poles are the eigenvalues of their companion matrix. Below 1 the loop is stable.
 * Needs 2 order + 1 readings; a few more average rounding out.
 */
double largestPole(const std::vector<double>& readings, int order);
/// The same of the poles that swing by more than 0.01 rad a tick; 0 if none does. What creeps, as a
/// body that relaxes, has poles so near 1 that rounding tells nothing of them.
double largestSwingingPole(const std::vector<double>& readings, int order);
} // namespace palpate::testing

#endif
