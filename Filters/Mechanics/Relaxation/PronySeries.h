// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PronySeries_h
#define palpate_PronySeries_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <string>

namespace palpate
{
/**
 * The relaxation of a material as a Prony series: E(t)/E_∞ = ψ(t) = 1 + Σ p_i e^(-t/τ_i). Poisson's
 * ratio is constant. p_i is relative to the slow modulus E_∞. The literature often gives fractions
 * g_i of the instantaneous modulus; then p_i = g_i/(1 - Σ g).
 */
struct PronySeries
{
  static constexpr std::size_t LargestCount = 4;

  std::size_t count = 0;
  std::array<double, LargestCount> strength{}; ///< p_i >= 0
  std::array<double, LargestCount> time{};     ///< τ_i, s, > 0

  bool relaxes() const noexcept { return this->total() > 0.0; }
  /// Returns P = Σ p_i. The instantaneous modulus is 1 + P times the slow modulus.
  double total() const noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->count; ++i)
    {
      sum += this->strength[i];
    }
    return sum;
  }
  void add(double branchStrength, double seconds) noexcept
  {
    this->strength[this->count] = branchStrength;
    this->time[this->count] = seconds;
    ++this->count;
  }
};

/// Returns the fault of a series with the branch and the value, or "". A series without branches is
/// valid.
PALPATE_EXPORT std::string faultOfRelaxation(const PronySeries& series);

/// Returns ψ(t) for t >= 0, s.
PALPATE_EXPORT double relaxationAt(const PronySeries& series, double seconds);

/// Returns the force at the end of a press at constant speed, divided by the slow force. `seconds`
/// is the duration t of the press, and the slow curve is f ∝ δ^m (Lee and Radok 1960). With
/// Kummer's function M = ₁F₁, the ratio is 1 + Σ p_i M(1; m+1; -t/τ_i). A modulus measured in such
/// a press is the slow modulus times this ratio.
PALPATE_EXPORT double rampFactor(const PronySeries& series, double exponent, double seconds);

/// Reads text of the form "0.5:0.1,0.3:2", with strength:seconds for each branch; "" means no
/// branches. Returns a fault, or
/// "". `series` is changed only if there is no fault.
PALPATE_EXPORT std::string parsePronySeries(const std::string& text, PronySeries& series);
/// Returns the series as text from which the same bits are read back.
PALPATE_EXPORT std::string textOf(const PronySeries& series);
} // namespace palpate

#endif
