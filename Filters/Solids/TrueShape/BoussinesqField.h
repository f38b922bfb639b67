// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BoussinesqField_h
#define palpate_BoussinesqField_h

#include "Solids/FiniteElements/ElasticElement.h"

namespace palpate
{
/**
 * Field in the half-space z >= 0 under a force of 1 N along +z at the origin of its surface
 * (Boussinesq 1885; Johnson 1985, eq. 3.18 and 3.19), in mm and MPa.
 *
 * The field is continued analytically to z < 0. There it also has no body forces, but is singular
 * on the axis x = y = 0. It is infinite at the origin. The field depends only on the position.
 * Therefore the body in which it is evaluated may have any shape.
 */
class BoussinesqField
{
public:
  explicit BoussinesqField(const ElasticMaterial& material)
    : Shear(material.youngsModulus / (2.0 * (1.0 + material.poissonRatio)))
    , PoissonRatio(material.poissonRatio)
  {
  }

  Eigen::Vector3d displacement(const Eigen::Vector3d& at) const;
  Eigen::Matrix3d strain(const Eigen::Vector3d& at) const;
  /// Returns the stress at a position. It does not depend on E.
  Eigen::Matrix3d stress(const Eigen::Vector3d& at) const;

private:
  /// Returns 4πG times the symmetric part of the displacement gradient.
  Eigen::Matrix3d scaledStrain(const Eigen::Vector3d& at) const;

  double Shear;
  double PoissonRatio;
};
} // namespace palpate

#endif
