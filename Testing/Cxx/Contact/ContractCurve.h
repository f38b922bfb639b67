// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ContractCurve_h
#define palpate_testing_ContractCurve_h

#include <vector>

namespace palpate::testing
{
struct Response
{
  double force = 0.0;
  double stiffness = 0.0;
  bool beyondRange = false;
};

/**
 * A literal implementation of the data contract, as an independent check of ResponseSampling: F(δ)
 * = δ^m r(s), s = √(δ/δ_max), r the cubic Hermite interpolant of r_i = F_i/δ_i^m with slopes from
 * the chain rule, in long double.
 */
struct ContractCurve
{
  double exponent;
  double range;
  std::vector<double> force;     ///< F_1 … F_n
  std::vector<double> stiffness; ///< K_1 … K_n

  Response evaluate(double depth) const;
};
} // namespace palpate::testing

#endif
