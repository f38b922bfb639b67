// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DimensionalityReduction_h
#define palpate_DimensionalityReduction_h

#include <functional>

/**
 * Contact of any axisymmetric profile on a half-space, from its reduced profile g(x)
 * (Popov and Hess, Method of Dimensionality Reduction, 2015, ch. 3 and 11).
 *
 * Results are per unit reduced modulus: p/E* (-), u_z (mm), load/E* (mm²). `step` is δ - g(a) >= 0:
 * 0 for a tool that touches smoothly, δ for a flat end. g must be analytic on (0, a); each
 * integral is transformed so that the integrand is analytic too, and one 64-point Gauss rule
 * reaches about 1e-11 while g has no singularity within 1 % of a beyond a.
 */
namespace palpate::reduction
{
using Function = std::function<double(double)>;

/// p(r)/E* = (1/π) [∫_r^a g'(x) dx/√(x²-r²) + step/√(a²-r²)], 0 <= r <= a.
double pressure(const Function& slope, double r, double a, double step);

/// u_z(r) = (2/π) [δ asin(a/r) - ∫_0^a g dx/√(r²-x²)], r > a.
double normalDisplacementOutside(const Function& profile, double r, double a, double deflection);

/// Load inside r over E*: 2 [∫_0^a (δ-g) dx - ∫_r^a (δ-g) t dt/√(t²-r²)], 0 < r < a, integrated by
/// parts so that it keeps its relative accuracy as r → 0.
double loadInside(const Function& profile, const Function& slope, double r, double a, double step);
} // namespace palpate::reduction

#endif
