// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxationElements_h
#define palpate_RelaxationElements_h

#include "Mechanics/Relaxation/RelaxationStep.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace palpate
{
/**
 * A relaxing foundation of parallel elements. Element j begins at a depth (gap) g_j below the
 * surface and carries the force
 *   q = u + Σ p_i s_i,   ds_i/dt = du/dt - s_i/τ_i,
 * where u is the displacement of the element, which is δ - g_j during contact. An element carries
 * no tensile force. Out of contact it recovers with q = 0.
 *
 * The force for a slow curve f is F = Σ w_j q_j. The curve f is approximated by chords between the
 * gaps, and the weights w_j are the increments of the slopes of these chords. In the limit of close
 * gaps this is exact for every body and tool with nested contact areas (Lee and Radok 1960; Ting
 * 1966), and for any history: presses, holds, releases, and new contacts in a dent that has not
 * recovered. The state of an element depends only on depth and time, not on f. Therefore several
 * curves can share the elements.
 *
 * A step is exact if the depth changes at constant speed. Elements are computed in blocks of four,
 * except those that were never touched. A step takes about 40 ns for 17 elements and two branches.
 * No function allocates or throws.
 */
class RelaxationElements
{
private:
  template <class Array>
  static auto head(Array& values, std::size_t count) noexcept
  {
    using Numbers =
      std::conditional_t<std::is_const_v<Array>, const Eigen::ArrayXd, Eigen::ArrayXd>;
    return Eigen::Map<Numbers>(values.data(), static_cast<Eigen::Index>(count));
  }

public:
  static constexpr std::size_t LargestCount = 33;
  static constexpr std::size_t BlockSize = 4;
  /// One number per element, padded to complete blocks.
  using Values = std::array<double, (LargestCount + BlockSize - 1) / BlockSize * BlockSize>;

  /// Depths at which the elements begin, mm, ascending; infinite for elements that do not exist.
  class Gaps
  {
  public:
    Gaps() noexcept { this->Depths.fill(std::numeric_limits<double>::infinity()); }
    void add(double gap) noexcept { this->Depths[this->Count++] = gap; }
    std::size_t count() const noexcept { return this->Count; }
    double operator[](std::size_t j) const noexcept { return this->Depths[j]; }
    const Values& depths() const noexcept { return this->Depths; }

  private:
    std::size_t Count = 0;
    Values Depths;
  };

  /// Resets all elements to the initial state.
  void reset() noexcept { *this = {}; }

  /// Sets the state of equilibrium at a constant depth, mm.
  void rest(double depth, const Gaps& gaps) noexcept
  {
    this->reset();
    for (; this->Awake < gaps.count() && depth > gaps[this->Awake]; ++this->Awake)
    {
      this->Depth[this->Awake] = depth - gaps[this->Awake];
      this->Force[this->Awake] = this->Depth[this->Awake];
    }
    this->Touched = this->Awake;
  }

  /// First part of a time step: computes the displacement that each element would have without
  /// contact. press() must follow.
  void relax(const RelaxationStep& step) noexcept
  {
    withBranches(step.count, [&](auto branches) { this->relaxAll<branches>(step); });
  }

  /// Second part of a time step. `depth` is the depth of the tool, mm; -∞ if there is no contact.
  void press(double depth, const Gaps& gaps, const RelaxationStep& step) noexcept
  {
    while (this->Awake < gaps.count() && depth > gaps[this->Awake])
    {
      ++this->Awake;
    }
    withBranches(step.count, [&](auto branches) { this->pressAll<branches>(depth, gaps, step); });
    this->fallAsleep();
    this->Touched = 0;
    while (this->Touched<this->Awake&& this->Force[this->Touched]> 0.0)
    {
      ++this->Touched;
    }
  }

  /// Returns the Σ w_j q_j that press() would cause at `depth`. To be called between relax() and
  /// press().
  double forceAt(double depth, const Gaps& gaps, const Values& weights,
    const RelaxationStep& step) const noexcept
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < gaps.count() && (j < this->Awake || depth > gaps[j]); ++j)
    {
      const double over = depth - gaps[j] - this->Free[j];
      sum += over > 0.0 ? weights[j] * over : 0.0;
    }
    return (1.0 + step.stiffening) * sum;
  }

  /// Number of elements that may carry a force. The other elements are in their initial state.
  std::size_t awake() const noexcept { return this->Awake; }
  /// Returns whether any element is in contact. In this case the first element is in contact.
  bool isTouched() const noexcept { return this->Touched > 0; }

  /// Returns the force Σ w_j q_j, N.
  double forceOf(const Values& weights) const noexcept
  {
    return (head(weights, this->Awake) * head(this->Force, this->Awake)).sum();
  }
  /// Returns the memory force Σ w_j (q_j - (δ - g_j)⁺), N.
  double memoryOf(const Values& weights, double depth, const Gaps& gaps) const noexcept
  {
    const auto slow = (depth - head(gaps.depths(), this->Awake)).max(0.0);
    return (head(weights, this->Awake) * (head(this->Force, this->Awake) - slow)).sum();
  }
  /// Returns Σ w_j of the elements in contact, N/mm.
  double touchedStiffness(const Values& weights) const noexcept
  {
    return head(weights, this->Touched).sum();
  }
  /// Returns the energy of the branches, Σ w_j Σ p_i s_i²/2, N mm.
  double storedEnergy(const Values& weights, const RelaxationStep& step) const noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      sum += step.strength[i] * this->energyByStrength(weights, i);
    }
    return sum;
  }
  /// Returns the derivative of storedEnergy() with respect to the strength of one branch, Σ w_j
  /// s_i²/2.
  double energyByStrength(const Values& weights, std::size_t branch) const noexcept
  {
    const auto strain = head(this->Strain[branch], this->Awake);
    return 0.5 * (head(weights, this->Awake) * strain.square()).sum();
  }

  /// Returns the derivative of storedEnergy() with respect to the fraction of new material under
  /// the tool (exchange()), N mm.
  double growthByExchange(
    const Values& weights, const RelaxationStep& step, double share) const noexcept
  {
    const double half = 0.5 * share;
    const auto depth = head(this->Depth, this->Touched);
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      const auto strain = head(this->Strain[i], this->Touched);
      sum += step.strength[i] *
        (head(weights, this->Touched) * (depth - strain) * ((1.0 - half) * strain + half * depth))
          .sum();
    }
    return sum;
  }

  /// Replaces a fraction of the material, 0 to 1, by untouched material. In elements in contact the
  /// new material counts as pressed instantly; in the other elements it counts as at rest.
  void exchange(double share, std::size_t branches) noexcept
  {
    for (std::size_t i = 0; i < branches; ++i)
    {
      Values& strain = this->Strain[i];
      head(strain, this->Touched) +=
        share * (head(this->Depth, this->Touched) - head(strain, this->Touched));
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
  /// Four elements, starting at `first`.
  using Block = Eigen::Array<double, BlockSize, 1>;
  static auto blockOf(const Values& values, std::size_t first) noexcept
  {
    return Eigen::Map<const Block>(values.data() + first);
  }
  static auto blockOf(Values& values, std::size_t first) noexcept
  {
    return Eigen::Map<Block>(values.data() + first);
  }
  template <class Use>
  static void withBranches(std::size_t count, const Use& use) noexcept
  {
    switch (count)
    {
      case 1:
        return use(std::integral_constant<std::size_t, 1>());
      case 2:
        return use(std::integral_constant<std::size_t, 2>());
      case 3:
        return use(std::integral_constant<std::size_t, 3>());
      default:
        return use(std::integral_constant<std::size_t, PronySeries::LargestCount>());
    }
  }
  // Computes complete blocks. Elements that are not awake have depths, strains and free depths of
  // 0. These values remain 0, because the tool does not reach the gaps of these elements.
  template <std::size_t Branches>
  void relaxAll(const RelaxationStep& step) noexcept
  {
    const double softness = 1.0 / (1.0 + step.stiffening);
    for (std::size_t j = 0; j < this->Awake; j += BlockSize)
    {
      Block free = step.stiffening * blockOf(this->Depth, j);
      for (std::size_t i = 0; i < Branches; ++i)
      {
        const Block strain = step.decay[i] * blockOf(this->Strain[i], j);
        blockOf(this->Strain[i], j) = strain;
        free -= step.strength[i] * strain;
      }
      blockOf(this->Free, j) = softness * free;
    }
  }
  template <std::size_t Branches>
  void pressAll(double depth, const Gaps& gaps, const RelaxationStep& step) noexcept
  {
    for (std::size_t j = 0; j < this->Awake; j += BlockSize)
    {
      const Block free = blockOf(this->Free, j);
      const Block own = free.max(depth - blockOf(gaps.depths(), j));
      const Block increment = own - blockOf(this->Depth, j);
      for (std::size_t i = 0; i < Branches; ++i)
      {
        blockOf(this->Strain[i], j) += step.gain[i] * increment;
      }
      blockOf(this->Depth, j) = own;
      blockOf(this->Force, j) = (1.0 + step.stiffening) * (own - free);
    }
  }

  void fallAsleep() noexcept
  {
    constexpr double little = 1e-12; // mm; the force at this depth is negligible
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
      this->Free[last] = 0.0;
      for (Values& strain : this->Strain)
      {
        strain[last] = 0.0;
      }
    }
  }

  std::size_t Awake = 0; ///< number of elements that were touched and have not recovered
  /// Number of elements in contact; these are the first ones, because contact areas are nested.
  std::size_t Touched = 0;
  Values Depth{}; ///< u_j
  Values Force{}; ///< q_j
  Values Free{};  ///< u_j that an element would have without contact
  std::array<Values, PronySeries::LargestCount> Strain{}; ///< s_i of each element
};
} // namespace palpate

#endif
