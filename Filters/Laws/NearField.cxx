// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/NearField.h"

namespace palpate
{
double NearField::at(const Eigen::Vector3d& away) const
{
  const double r = away.norm();
  const double kappa = r > this->radius ? this->radius / r : 1.0;
  const Eigen::Vector3d known = kappa * away;
  return kappa * kappa * (this->depth + this->slope.dot(known) + known.dot(this->bend * known));
}

std::array<double, NearField::Numbers> numbersOf(const NearField& near)
{
  const Eigen::Matrix3d& q = near.bend;
  return { near.slope[0], near.slope[1], near.slope[2], near.depth, q(0, 0), q(1, 1), q(2, 2),
    near.radius, q(0, 1), q(1, 2), q(2, 0), near.reducedModulus };
}

NearField nearFieldOf(const std::array<double, NearField::Numbers>& numbers)
{
  NearField near;
  near.slope << numbers[0], numbers[1], numbers[2];
  near.depth = numbers[3];
  near.radius = numbers[7];
  near.bend << numbers[4], numbers[8], numbers[10], //
    numbers[8], numbers[5], numbers[9],             //
    numbers[10], numbers[9], numbers[6];
  near.reducedModulus = numbers[11];
  return near;
}
} // namespace palpate
