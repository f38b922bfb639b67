// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationStep_h
#define palpate_RelaxationStep_h

#include "Mechanics/Relaxation/PronySeries.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/// Coefficients of a material's branches for a time step of length T in which the depth changes at
/// constant speed.
struct RelaxationStep
{
  using Branches = std::array<double, PronySeries::LargestCount>;

  std::size_t count = 0;
  Branches decay{};    ///< e_i = e^(-T/τ_i)
  Branches gain{};     ///< (τ_i/T)(1 - e_i): fraction of an increment that remains at the end
  Branches strength{}; ///< p_i
  /// Σ p_i gain_i. The stiffness for an increment is 1 + this value times the slow stiffness.
  double stiffening = 0.0;

  RelaxationStep() = default;
  /// `seconds` >= 0 is the length of the step. With 0, the increment does not decay.
  RelaxationStep(const PronySeries& series, double seconds) noexcept
    : count(series.count)
    , strength(series.strength)
  {
    for (std::size_t i = 0; i < this->count; ++i)
    {
      const double x = seconds / series.time[i];
      this->gain[i] = meanDecay(x);
      this->decay[i] = x < Little ? 1.0 - x * this->gain[i] : std::exp(-x);
    }
    this->sum();
  }
  /// Sets the strengths.
  void setStrength(const Branches& strengths) noexcept
  {
    this->strength = strengths;
    this->sum();
  }

  /// Returns the factor 1 + Σ p_i tanh(x_i)/x_i, x_i = T/(2 τ_i). A servo loop with the period of
  /// the step is passive with a relaxing spring of slow stiffness K if it is passive with an
  /// elastic spring whose stiffness is K times this factor (Colgate and Schenkel). tanh(x_i)/x_i is
  /// computed as 2 gain_i/(1 + e_i).
  double sampledStiffening() const noexcept
  {
    double sum = 1.0;
    for (std::size_t i = 0; i < this->count; ++i)
    {
      sum += 2.0 * this->strength[i] * this->gain[i] / (1.0 + this->decay[i]);
    }
    return sum;
  }

  /// Returns (1 - e^-x)/x.
  static double meanDecay(double x) noexcept
  {
    if (!(x < Little))
    {
      return (1.0 - std::exp(-x)) / x;
    }
    // The terms are in groups of four, which are independent of each other. The first omitted term,
    // x^11/12!, is 5e-16.
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double low = (1.0 - x * (1.0 / 2)) + x2 * (1.0 / 6 - x * (1.0 / 24));
    const double middle = (1.0 / 120 - x * (1.0 / 720)) + x2 * (1.0 / 5040 - x * (1.0 / 40320));
    const double high = 1.0 / 362880 - x * (1.0 / 3628800) + x2 * (1.0 / 39916800);
    return low + x4 * (middle + x4 * high);
  }

private:
  /// Below this x the Taylor polynomial is exact to rounding.
  static constexpr double Little = 0.25;

  void sum() noexcept
  {
    this->stiffening = 0.0;
    for (std::size_t i = 0; i < this->count; ++i)
    {
      this->stiffening += this->strength[i] * this->gain[i];
    }
  }
};
} // namespace palpate

#endif
