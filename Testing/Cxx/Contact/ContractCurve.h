// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ContractCurve_h
#define palpate_testing_ContractCurve_h

#include <vector>

namespace palpate::testing
{
/// Force and stiffness of a curve at a depth.
struct ContractValue
{
  double force = 0.0;
  double stiffness = 0.0;
  bool beyondRange = false;
};

/**
 * A literal implementation of the data contract, as an independent check of ResponseSampling and of
 * the filters: F(δ) = δ^m r(s) with s = √(δ/δ_max), where r is the cubic Hermite interpolant of
 * r_i = F_i/δ_i^m with slopes from the chain rule, in long double. Below δ_1 the curve is a power
 * law, beyond δ_max it is the tangent.
 */
struct ContractCurve
{
  double exponent;
  double range;
  std::vector<double> force;     ///< F_1 … F_n
  std::vector<double> stiffness; ///< K_1 … K_n

  ContractValue evaluate(double depth) const;
};
} // namespace palpate::testing

#endif
