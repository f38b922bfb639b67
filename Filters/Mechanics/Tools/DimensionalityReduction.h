// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DimensionalityReduction_h
#define palpate_DimensionalityReduction_h

#include <functional>
#include <vector>

/**
 * Contact of any axisymmetric profile on a half-space, from its reduced profile g(x)
 * (Popov and Hess, Method of Dimensionality Reduction, 2015, ch. 3 and 11).
 *
 * Results are per unit reduced modulus: p/E* (dimensionless), u_z (mm), load/E* (mm²). `step` is δ
 * - g(a): 0 for a tool with a smooth rim, δ for a flat end.
 *
 * `kinks` are the radii, ascending, at which g is not analytic. After a kink g may start like a
 * square root, and at the axis like any positive power. The integrals are computed from kink to
 * kink. They are transformed so that the integrand is also analytic at the start of each piece,
 * with 32 Gauss points next to the start and 64 on the rest. Accuracy: about 1e-11 if g has no
 * singularity within 1 % of a beyond a, for r/a down to 1e-10 and for r as near as 1e-7 to a kink.
 */
namespace palpate::reduction
{
using Function = std::function<double(double)>;
using Radii = std::vector<double>;

/// Returns g(x) = ∫_0^x x f'(r) dr/√(x²-r²), x > 0. `kinks` are the kinks of the profile's slope
/// f'.
double reducedProfile(const Function& profileSlope, double x, const Radii& kinks = {});

/// Returns g'(x) = ∫_0^x (f' + r f'') dr/√(x²-r²) + Σ [f']_k k/√(x²-k²). [f']_k are the jumps of
/// the slope at the kinks below x. `curvature` is f''.
double reducedSlope(
  const Function& profileSlope, const Function& curvature, double x, const Radii& kinks = {});

/// Returns F/E* = 2 ∫_0^a (δ-g) dx.
double force(const Function& profile, double a, double deflection, const Radii& kinks = {});

/// Returns p(r)/E* = (1/π) [∫_r^a g'(x) dx/√(x²-r²) + step/√(a²-r²)], 0 <= r <= a. On the axis it
/// is +inf if g'(0) > 0.
double pressure(const Function& slope, double r, double a, double step, const Radii& kinks = {});

/// Returns u_z(r) = (2/π) ∫_0^a (δ-g) dx/√(r²-x²), r > a.
double normalDisplacementOutside(
  const Function& profile, double r, double a, double deflection, const Radii& kinks = {});

/// Returns the load within the radius r, 0 < r < a, divided by E*: 2 [∫_0^a (δ-g) dx - ∫_r^a (δ-g)
/// t dt/√(t²-r²)], integrated by parts so that it keeps its relative accuracy as r → 0.
double loadInside(const Function& slope, double r, double a, double step, const Radii& kinks = {});
} // namespace palpate::reduction

#endif
