// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FloatCurve_h
#define palpate_FloatCurve_h

namespace palpate
{
/// The samples of one point's curve as arrays hold them, for ResponseSampling::evaluate(). A view.
struct FloatCurve
{
  const float* forces;      ///< N
  const float* stiffnesses; ///< N/mm
  double force(int i) const noexcept { return static_cast<double>(this->forces[i]); }
  double stiffness(int i) const noexcept { return static_cast<double>(this->stiffnesses[i]); }
};
} // namespace palpate

#endif
