// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationElements_h
#define palpate_RelaxationElements_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace palpate
{
/// What a stretch of time does to the branches of a material whose depth moves evenly in it.
struct RelaxationStep
{
  using Branches = std::array<double, PronySeries::LargestCount>;

  std::size_t count = 0;
  Branches decay{};        ///< e_i = e^(-T/τ_i)
  Branches gain{};         ///< (τ_i/T)(1 - e_i): of an increment, what is left of it at the end
  Branches strength{};     ///< p_i
  double stiffening = 0.0; ///< Σ p_i gain_i: an increment feels 1 + this times as stiff

  RelaxationStep() = default;
  /// `seconds` >= 0; at 0 all of an increment is left.
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
  /// The same of other strengths.
  void setStrength(const Branches& strengths) noexcept
  {
    this->strength = strengths;
    this->sum();
  }

  /// (1 - e^-x)/x.
  static double meanDecay(double x) noexcept
  {
    if (!(x < Little))
    {
      return (1.0 - std::exp(-x)) / x;
    }
    // In fours, which do not wait for each other; x^11/12! is 5e-16.
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double low = (1.0 - x * (1.0 / 2)) + x2 * (1.0 / 6 - x * (1.0 / 24));
    const double middle = (1.0 / 120 - x * (1.0 / 720)) + x2 * (1.0 / 5040 - x * (1.0 / 40320));
    const double high = 1.0 / 362880 - x * (1.0 / 3628800) + x2 * (1.0 / 39916800);
    return low + x4 * (middle + x4 * high);
  }

private:
  /// Below it Taylor's polynomial is right to the last digit.
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

/**
 * A foundation that relaxes: elements side by side, each of which begins at its own gap g_j below
 * the surface, carries
 *   q = u + Σ p_i s_i,   ds_i/dt = du/dt - s_i/τ_i,
 * u its own depth, δ - g_j as long as it touches, and pulls at nothing: untouched it creeps back
 * with q = 0. The force of a slow curve f is F = Σ w_j q_j, with w_j the steps of the slope of the
 * chords of f between the gaps: exact, as the gaps get close, for every body and tool whose contact
 * areas are nested (Lee and Radok 1960; Ting 1966), whatever is done: presses, holds, releases, new
 * touches of a dent that has not yet come back. What an element does depends on depth and time
 * alone, not on f: elements are shared by curves that are blended.
 *
 * A step is exact for a depth that moves evenly in it. Cost: 2 to 4 ns per element and branch.
 * Nothing allocates or throws.
 */
class RelaxationElements
{
private:
  template <class Array>
  static auto head(Array& values, Eigen::Index count) noexcept
  {
    using Numbers =
      std::conditional_t<std::is_const_v<Array>, const Eigen::ArrayXd, Eigen::ArrayXd>;
    return Eigen::Map<Numbers>(values.data(), count);
  }

public:
  static constexpr std::size_t LargestCount = 33;
  using Values = std::array<double, LargestCount>;

  /// All at rest, untouched.
  void reset() noexcept
  {
    this->Awake = 0;
    this->Touched = 0;
    this->Depth.fill(0.0);
    this->Force.fill(0.0);
    for (Values& strain : this->Strain)
    {
      strain.fill(0.0);
    }
  }

  /// As if the depth had been this for long. `gaps` (mm, increasing) are those of `count` elements.
  void rest(double depth, const Values& gaps, std::size_t count) noexcept
  {
    this->reset();
    for (; this->Awake < count && depth > gaps[this->Awake]; ++this->Awake)
    {
      this->Depth[this->Awake] = depth - gaps[this->Awake];
      this->Force[this->Awake] = this->Depth[this->Awake];
    }
    this->Touched = this->Awake;
  }

  /// Time passes, first part: where each element would be if nothing touched it. To be followed by
  /// press().
  void relax(const RelaxationStep& step) noexcept
  {
    const auto n = static_cast<Eigen::Index>(this->Awake);
    const double stiffening = step.stiffening;
    auto free = head(this->Free, n);
    free = stiffening * head(this->Depth, n);
    for (std::size_t i = 0; i < step.count; ++i)
    {
      auto strain = head(this->Strain[i], n);
      strain *= step.decay[i];
      free -= step.strength[i] * strain;
    }
    free /= 1.0 + stiffening;
  }

  /// Second part: the tool is at this depth, mm; -∞ where it touches nothing.
  void press(
    double depth, const Values& gaps, std::size_t count, const RelaxationStep& step) noexcept
  {
    this->wake(depth, gaps, count);
    const auto n = static_cast<Eigen::Index>(this->Awake);
    auto free = head(this->Free, n);
    auto own = head(this->Depth, n);
    auto force = head(this->Force, n);
    force = free.max(depth - head(gaps, n)); // for now the new depths
    for (std::size_t i = 0; i < step.count; ++i)
    {
      head(this->Strain[i], n) += step.gain[i] * (force - own);
    }
    own = force;
    force = (1.0 + step.stiffening) * (own - free);
    this->fallAsleep();
    for (this->Touched = 0; this->Touched<this->Awake&& this->Force[this->Touched]> 0.0;)
    {
      ++this->Touched;
    }
  }

  /// Σ w_j q_j that press() would give at another depth, between relax() and it.
  double forceAt(double depth, const Values& gaps, std::size_t count, const Values& weights,
    const RelaxationStep& step) const noexcept
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < count && (j < this->Awake || depth > gaps[j]); ++j)
    {
      const double free = j < this->Awake ? this->Free[j] : 0.0;
      const double over = depth - gaps[j] - free;
      sum += over > 0.0 ? weights[j] * over : 0.0;
    }
    return (1.0 + step.stiffening) * sum;
  }

  /// How many may carry something; the others are as they were made.
  std::size_t awake() const noexcept { return this->Awake; }
  /// Whether anything is touched: the first element is, when any is.
  bool isTouched() const noexcept { return this->Touched > 0; }
  /// q_j, mm; 0 of one that is not touched.
  const Values& force() const noexcept { return this->Force; }

  /// Σ w_j q_j.
  double forceOf(const Values& weights) const noexcept
  {
    const auto n = static_cast<Eigen::Index>(this->Awake);
    return (head(weights, n) * head(this->Force, n)).sum();
  }
  /// Of it, what memory adds: Σ w_j (q_j - (δ - g_j)⁺).
  double memoryOf(const Values& weights, double depth, const Values& gaps) const noexcept
  {
    const auto n = static_cast<Eigen::Index>(this->Awake);
    return (head(weights, n) * (head(this->Force, n) - (depth - head(gaps, n)).max(0.0))).sum();
  }
  /// Σ w_j over those that are touched, N/mm.
  double touchedStiffness(const Values& weights) const noexcept
  {
    return head(weights, static_cast<Eigen::Index>(this->Touched)).sum();
  }
  /// What the branches hold: Σ w_j Σ p_i s_i²/2, N mm.
  double storedEnergy(const Values& weights, const RelaxationStep& step) const noexcept
  {
    const auto n = static_cast<Eigen::Index>(this->Awake);
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      sum += 0.5 * step.strength[i] * (head(weights, n) * head(this->Strain[i], n).square()).sum();
    }
    return sum;
  }
  /// The same by the strength of one branch: Σ w_j s_i²/2.
  double energyByStrength(const Values& weights, std::size_t branch) const noexcept
  {
    const auto n = static_cast<Eigen::Index>(this->Awake);
    return 0.5 * (head(weights, n) * head(this->Strain[branch], n).square()).sum();
  }

  /// How storedEnergy() grows with a share of new material under the tool, see exchange(), over
  /// that share; N mm.
  double growthByExchange(
    const Values& weights, const RelaxationStep& step, double share) const noexcept
  {
    const auto n = static_cast<Eigen::Index>(this->Touched);
    const auto depth = head(this->Depth, n);
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      const auto strain = head(this->Strain[i], n);
      sum += step.strength[i] *
        (head(weights, n) * (depth - strain) *
          ((1.0 - 0.5 * share) * strain + (0.5 * share) * depth))
          .sum();
    }
    return sum;
  }

  /// A share of the material, 0 to 1, is replaced by such as was never touched: under the tool it
  /// is as good as pressed at once, beside it at rest.
  void exchange(double share, std::size_t branches) noexcept
  {
    const auto n = static_cast<Eigen::Index>(this->Touched);
    for (std::size_t i = 0; i < branches; ++i)
    {
      Values& strain = this->Strain[i];
      head(strain, n) += share * (head(this->Depth, n) - head(strain, n));
      for (std::size_t j = this->Touched; j < this->Awake; ++j)
      {
        strain[j] -= share * strain[j];
      }
    }
    for (std::size_t j = this->Touched; j < this->Awake; ++j)
    {
      this->Depth[j] -= share * this->Depth[j];
    }
  }

private:
  void wake(double depth, const Values& gaps, std::size_t count) noexcept
  {
    for (; this->Awake < count && depth > gaps[this->Awake]; ++this->Awake)
    {
      this->Free[this->Awake] = 0.0;
    }
  }
  void fallAsleep() noexcept
  {
    constexpr double little = 1e-12; // mm: of no force that could be felt
    for (; this->Awake > 0 && !(this->Force[this->Awake - 1] > 0.0); --this->Awake)
    {
      const std::size_t last = this->Awake - 1;
      double left = std::abs(this->Depth[last]);
      for (const Values& strain : this->Strain)
      {
        left += std::abs(strain[last]);
      }
      if (left > little)
      {
        return;
      }
      this->Depth[last] = 0.0;
      this->Force[last] = 0.0;
      for (Values& strain : this->Strain)
      {
        strain[last] = 0.0;
      }
    }
  }

  std::size_t Awake = 0;   ///< elements that were touched, and have not come back yet
  std::size_t Touched = 0; ///< those that are: the first ones, since contact areas are nested
  Values Depth{};          ///< u_j
  Values Force{};          ///< q_j
  Values Free{};           ///< u_j if nothing touched it
  std::array<Values, PronySeries::LargestCount> Strain{}; ///< s_i of each
};

/**
 * The same as one element in the force of the curve itself: y = f(δ) instead of a depth
 * (quasi-linear, Fung). Right for a flat-ended tool and on loading, within 10 to 12 % of the
 * largest force else; for curves that are not convex, or where few operations matter more.
 */
class QuasiLinearElement
{
public:
  void reset() noexcept { *this = {}; }
  /// As if the force had been this for long.
  void rest(double force) noexcept
  {
    this->reset();
    this->Slow = force;
  }
  /// To another curve, which is so many times as stiff.
  void scale(double factor) noexcept
  {
    this->Slow *= factor;
    for (double& strain : this->Strain)
    {
      strain *= factor;
    }
  }
  /// A step of time to a slow force f(δ), N; 0 where nothing is touched. The force.
  double press(double slow, const RelaxationStep& step) noexcept
  {
    double free = step.stiffening * this->Slow;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      this->Strain[i] *= step.decay[i];
      free -= step.strength[i] * this->Strain[i];
    }
    free /= 1.0 + step.stiffening;
    const double now = slow > free ? slow : free;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      this->Strain[i] += step.gain[i] * (now - this->Slow);
    }
    this->Slow = now;
    this->Force = (1.0 + step.stiffening) * (now - free);
    return this->Force;
  }
  /// Instead of press(): a step by an increment that may be of either sign, without a limit. What
  /// memory adds.
  double follow(double increment, const RelaxationStep& step) noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      this->Strain[i] = this->Strain[i] * step.decay[i] + step.gain[i] * increment;
      sum += step.strength[i] * this->Strain[i];
    }
    this->Slow += increment;
    this->Force = 1.0; // pulls too
    return sum;
  }

  /// What follow() would give.
  double foresee(double increment, const RelaxationStep& step) const noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      sum += step.strength[i] * (this->Strain[i] * step.decay[i] + step.gain[i] * increment);
    }
    return sum;
  }

  /// y; of one that is not touched where it has crept to.
  double slow() const noexcept { return this->Slow; }
  /// As of RelaxationElements, but times a stiffness: N².
  double growthByExchange(const RelaxationStep& step, double share) const noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      const double missing = this->Slow - this->Strain[i];
      sum += step.strength[i] * missing * (this->Strain[i] + 0.5 * share * missing);
    }
    return sum;
  }
  /// Σ p_i s_i²/2, N².
  double storedEnergy(const RelaxationStep& step) const noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      sum += 0.5 * step.strength[i] * this->Strain[i] * this->Strain[i];
    }
    return sum;
  }
  double energyByStrength(std::size_t branch) const noexcept
  {
    return 0.5 * this->Strain[branch] * this->Strain[branch];
  }
  /// As of RelaxationElements.
  void exchange(double share) noexcept
  {
    const bool isTouched = this->Force > 0.0;
    for (double& strain : this->Strain)
    {
      strain += share * ((isTouched ? this->Slow : 0.0) - strain);
    }
    this->Slow -= isTouched ? 0.0 : share * this->Slow;
  }

private:
  double Slow = 0.0;
  double Force = 0.0;
  RelaxationStep::Branches Strain{};
};
} // namespace palpate

#endif
