// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/BoussinesqField.h"

#include "Mechanics/Numerics/Constants.h"

#include <cmath>

namespace palpate
{
Eigen::Vector3d BoussinesqField::displacement(const Eigen::Vector3d& at) const
{
  const double distance = at.norm();
  const double z = at[2];
  const double cube = distance * distance * distance;
  const double radial = z / cube - (1.0 - 2.0 * this->PoissonRatio) / (distance * (distance + z));
  return Eigen::Vector3d(radial * at[0], radial * at[1],
           z * z / cube + 2.0 * (1.0 - this->PoissonRatio) / distance) /
    (4.0 * Pi * this->Shear);
}

Eigen::Matrix3d BoussinesqField::scaledStrain(const Eigen::Vector3d& at) const
{
  const double x = at[0];
  const double y = at[1];
  const double z = at[2];
  const double square = at.squaredNorm();
  const double distance = std::sqrt(square);
  const double cube = square * distance;
  const double fifth = 3.0 / (cube * square);
  const double compressible = 1.0 - 2.0 * this->PoissonRatio;
  // The factor x/(R(R+z)) of the displacement, and the common factors of its derivatives.
  const double a = 1.0 / (distance * (distance + z));
  const double turn = compressible * a * a * (2.0 + z / distance);
  const double plane = z / cube - compressible * a;
  const double mixed = turn - fifth * z;
  Eigen::Matrix3d strain;
  strain(0, 0) = plane + mixed * x * x;
  strain(1, 1) = plane + mixed * y * y;
  strain(0, 1) = strain(1, 0) = mixed * x * y;
  strain(2, 2) = 2.0 * z / cube - fifth * z * z * z - 2.0 * (1.0 - this->PoissonRatio) * z / cube;
  // Sum of ∂u_x/∂z and ∂u_z/∂x. Their terms in 1/R³ cancel.
  strain(0, 2) = strain(2, 0) = -fifth * x * z * z;
  strain(1, 2) = strain(2, 1) = -fifth * y * z * z;
  return strain;
}

Eigen::Matrix3d BoussinesqField::strain(const Eigen::Vector3d& at) const
{
  return this->scaledStrain(at) / (4.0 * Pi * this->Shear);
}

Eigen::Matrix3d BoussinesqField::stress(const Eigen::Vector3d& at) const
{
  // The dilatation is -2(1-2ν) z/R³, so the term with Lamé's λ needs no division by 1-2ν.
  const double distance = at.norm();
  Eigen::Matrix3d stress = this->scaledStrain(at);
  stress.diagonal().array() -= 2.0 * this->PoissonRatio * at[2] / (distance * distance * distance);
  return stress / (2.0 * Pi);
}
} // namespace palpate
