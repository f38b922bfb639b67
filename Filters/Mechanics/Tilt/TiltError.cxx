// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltError.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Returns the error of the table of tilts on a half-space.
double tableError(const TiltedLayer& contact) noexcept
{
  constexpr double wholeEnd = 1.0; // value of `rim` up to which the whole flat end touches
  // Value of `rim` above which only a small part of a flat end touches.
  constexpr double smallPart = 3.0;
  constexpr double ofWholeEnd = 0.006;
  constexpr double ofPointed = 0.005;
  constexpr double asIfUpright = 1e-9;
  if (contact.rim > wholeEnd)
  {
    return contact.rim > smallPart ? 0.03 : 0.02;
  }
  return contact.rim > 0.0 ? ofWholeEnd : contact.stretch > 1.0 + asIfUpright ? ofPointed : 0.0;
}
} // namespace

double tiltError(const TiltedLayer& contact) noexcept
{
  const double stretch = std::max(1.0, contact.stretch);
  const double radius = contact.radius * std::sqrt(stretch);
  const double cube = radius * radius * radius;
  const double square = contact.rim * contact.rim;
  const double ofLayer = cube / (cube + 0.22) *
    std::max(0.36 * (1.0 - std::pow(stretch, -1.2)), 0.18 * square / (1.0 + square));
  return std::max(ofLayer, tableError(contact));
}
} // namespace palpate
