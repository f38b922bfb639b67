// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltError.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
double tiltError(const TiltedLayer& contact) noexcept
{
  const double stretch = std::max(1.0, contact.stretch);
  const double radius = contact.radius * std::sqrt(stretch);
  const double cube = radius * radius * radius;
  const double square = contact.rim * contact.rim;
  return cube / (cube + 0.22) *
    std::max(0.36 * (1.0 - std::pow(stretch, -1.2)), 0.18 * square / (1.0 + square));
}
} // namespace palpate
