// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/HalfSpaceField.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
Eigen::Vector3d boussinesqDisplacement(const Eigen::Vector3d& at, double poissonRatio)
{
  constexpr double pi = 3.14159265358979323846;
  const double z = std::max(at[2], 0.0);
  const double distance = std::sqrt(at[0] * at[0] + at[1] * at[1] + z * z);
  const double scale = (1.0 + poissonRatio) / (2.0 * pi * distance); // 1/(4πG R) for E = 1
  const double radial = z / (distance * distance) - (1.0 - 2.0 * poissonRatio) / (distance + z);
  return scale *
    Eigen::Vector3d(
      radial * at[0], radial * at[1], z * z / (distance * distance) + 2.0 * (1.0 - poissonRatio));
}
} // namespace palpate
