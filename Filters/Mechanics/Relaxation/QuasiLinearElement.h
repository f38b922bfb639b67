// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_QuasiLinearElement_h
#define palpate_QuasiLinearElement_h

#include "Mechanics/Relaxation/RelaxationStep.h"

#include <cstddef>

namespace palpate
{
/**
 * A single relaxing element, a simpler alternative to RelaxationElements. Instead of the depth it
 * uses the force of the curve, y = f(δ) (quasi-linear, Fung). It is exact for a flat-ended tool and
 * during loading; otherwise the error is at most 10 to 12 % of the largest force. It is intended
 * for curves that are not convex, and for cases in which speed is more important than accuracy.
 */
class QuasiLinearElement
{
public:
  void reset() noexcept { *this = {}; }
  /// Sets the state of equilibrium at the force `force`, N.
  void rest(double force) noexcept
  {
    this->reset();
    this->Slow = force;
  }
  /// Converts the state to a curve that is `factor` times as stiff.
  void scale(double factor) noexcept
  {
    this->Slow *= factor;
    for (double& strain : this->Strain)
    {
      strain *= factor;
    }
  }
  /// Computes one time step to the slow force f(δ), N (0 without contact). Returns the force, N.
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
  /// Alternative to press() for an element that does not separate: computes one time step with an
  /// increment of the slow force of either sign. Returns the memory force, N.
  double follow(double increment, const RelaxationStep& step) noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      this->Strain[i] = this->Strain[i] * step.decay[i] + step.gain[i] * increment;
      sum += step.strength[i] * this->Strain[i];
    }
    this->Slow += increment;
    this->Force = 1.0; // marks the element as in contact, because the force may be tensile
    return sum;
  }

  /// Returns the result of follow() without changing the state.
  double foresee(double increment, const RelaxationStep& step) const noexcept
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < step.count; ++i)
    {
      sum += step.strength[i] * (this->Strain[i] * step.decay[i] + step.gain[i] * increment);
    }
    return sum;
  }

  /// As RelaxationElements::growthByExchange(), but multiplied by a stiffness, N².
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
  /// Returns Σ p_i s_i²/2, N².
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
  /// As RelaxationElements::exchange().
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
