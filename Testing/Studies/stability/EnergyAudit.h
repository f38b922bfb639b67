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
 * Energy balance of a sampled loop, computed from the true positions of the mass: work of the
 * motor, Σ F_k · d_k with d_k = x_{k+1} - x_k (the force is held), minus a lower bound of the
 * dissipation by the device's own damping, b |d_k|²/T. The difference is the energy that a hand
 * gains from device and scene together. Counted from a moment at which the tip is free and the
 * scene stores no energy, it never rises if device and scene are passive.
 */
class EnergyAudit
{
public:
  /// `delay`: ticks until a force acts.
  EnergyAudit(double damping, double period, int delay)
    : Credit(damping / period)
    , Pending(static_cast<std::size_t>(delay) + 1, Eigen::Vector3d::Zero())
  {
  }

  /// Ends a hold period at this position (m).
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
  /// Sets the force of the motor from now on. `isFree`: the tip has no contact.
  void told(const Eigen::Vector3d& force, bool isFree)
  {
    this->Least = isFree ? std::min(this->Least, this->generated()) : this->Least;
    this->Pending[this->Next] = force;
    this->Next = (this->Next + 1) % this->Pending.size();
  }

  double work() const noexcept { return this->Work; } ///< work on the mass, J
  /// Largest energy gained since a free moment, J; since the beginning if there was none.
  double mostGenerated() const noexcept { return this->Most; }

private:
  double generated() const noexcept { return this->Work - this->Damped; }

  double Credit;
  std::vector<Eigen::Vector3d> Pending;
  std::size_t Next = 0; ///< index of the force that acts now, once the force of this tick is set
  bool HasPlace = false;
  Eigen::Vector3d Place = Eigen::Vector3d::Zero();
  double Work = 0.0;
  double Damped = 0.0;
  double Most = 0.0;
  double Least = 0.0; ///< smallest value of generated() at free moments
};
} // namespace palpate::testing

#endif
