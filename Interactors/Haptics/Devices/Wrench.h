// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Wrench_h
#define palpate_Wrench_h

#include <Eigen/Core>

namespace palpate
{
/// A force and a torque about the tool's tip, on the hand. The device's frame; N, N m.
struct Wrench
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();

  bool isFinite() const noexcept { return this->force.allFinite() && this->torque.allFinite(); }
  /// Each shortened to no more than it may be, N and N m; finite.
  Wrench within(double maximumForce, double maximumTorque) const noexcept
  {
    return { shortened(this->force, maximumForce), shortened(this->torque, maximumTorque) };
  }

private:
  static Eigen::Vector3d shortened(const Eigen::Vector3d& vector, double most) noexcept
  {
    const double size = vector.norm();
    return (size > most ? most / size : 1.0) * vector;
  }
};
} // namespace palpate

#endif
