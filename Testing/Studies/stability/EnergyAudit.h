// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_EnergyAudit_h
#define palpate_testing_EnergyAudit_h

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace palpate::testing
{
/**
 * The books of a sampled loop, kept beside it from where the mass really was: work of the motor,
 * Σ F_k · d_k with d_k = x_{k+1} - x_k (the force is held), and what the device's own damping takes
 * at least, b |d_k|²/T. Their difference is what a hand gets out of device and scene together. From
 * a moment at which the tip is free, and the scene holds nothing, it never rises if they are
 * passive.
 */
class EnergyAudit
{
public:
  /// `delay` in ticks: so much later a force acts.
  EnergyAudit(double damping, double period, int delay)
    : Credit(damping / period)
    , Pending(static_cast<std::size_t>(delay) + 1, Eigen::Vector3d::Zero())
  {
  }

  /// Ends a hold at a place (m).
  void moved(const Eigen::Vector3d& position)
  {
    if (this->HasPlace)
    {
      const Eigen::Vector3d way = position - this->Place;
      this->Work += this->Pending[this->Next].dot(way);
      this->Damped += this->Credit * way.squaredNorm();
      this->Most = std::max(this->Most, this->generated() - this->Least);
    }
    this->Place = position;
    this->HasPlace = true;
  }
  /// What the motor is told now. `isFree`: the tip touches nothing.
  void told(const Eigen::Vector3d& force, bool isFree)
  {
    this->Least = isFree ? std::min(this->Least, this->generated()) : this->Least;
    this->Pending[this->Next] = force;
    this->Next = (this->Next + 1) % this->Pending.size();
  }

  double work() const noexcept { return this->Work; } ///< on the mass, J
  /// Got out since a free moment, at its most, J; since the beginning if there was none.
  double mostGenerated() const noexcept { return this->Most; }

private:
  double generated() const noexcept { return this->Work - this->Damped; }

  double Credit;
  std::vector<Eigen::Vector3d> Pending;
  std::size_t Next = 0; ///< the force that acts now, once told() has been called for this tick
  bool HasPlace = false;
  Eigen::Vector3d Place = Eigen::Vector3d::Zero();
  double Work = 0.0;
  double Damped = 0.0;
  double Most = 0.0;
  double Least = 0.0; ///< of generated() where the tip was free
};
} // namespace palpate::testing

#endif
