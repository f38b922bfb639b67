// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/DeflectionTable.h"

#include "Laws/ContactField.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr double HalfParameter = 0.5; // q at the end of the first segment for a tool without a kink
constexpr double LongestReach = 1e3;  // largest reach of a table, in contact radii
constexpr int Last = DeflectionTable::Intervals;

/// Returns q at the distance r. `sine` is r/a within the contact and a/r outside.
double parameterOf(double sine)
{
  return sine / (1.0 + std::sqrt(std::max(0.0, 1.0 - sine * sine)));
}

double sineOf(double q)
{
  return 2.0 * q / (1.0 + q * q);
}
} // namespace

DeflectionTable::DeflectionTable(const ContactField& field, double reach, double edge)
{
  const double a = field.contactRadius();
  if (field.isEmpty() || !(a > 0.0))
  {
    return;
  }
  const double corner = field.kinkRadius();
  this->radius = static_cast<float>(a);
  this->kink = static_cast<float>(corner > 0.0 ? parameterOf(corner / a) : HalfParameter);
  this->far = static_cast<float>(parameterOf(1.0 / std::clamp(reach / a, 1.01, LongestReach)));
  for (int i = 0; i < Nodes; ++i)
  {
    const SurfaceDisplacement u = field.local(this->distanceOf(i));
    Node& node = this->nodes[static_cast<std::size_t>(i)];
    node[0] = static_cast<float>(u.radial);
    node[1] = static_cast<float>(u.normal);
  }
  for (int i = 0; i < Nodes; ++i)
  {
    const double r = this->distanceOf(i);
    const auto before = this->at(std::abs(r - edge));
    const auto after = this->at(r + edge);
    const double mirrored = r < edge ? -1.0 : 1.0; // u_r is an odd function of r
    Node& node = this->nodes[static_cast<std::size_t>(i)];
    node[2] = static_cast<float>((after[0] - mirrored * before[0]) / (2.0 * edge));
    node[3] = static_cast<float>((after[1] - before[1]) / (2.0 * edge));
  }
}

/// Returns the distance r of a node, mm.
double DeflectionTable::distanceOf(int node) const
{
  const double a = static_cast<double>(this->radius);
  const double tip = static_cast<double>(this->kink);
  const double end = static_cast<double>(this->far);
  const double share = static_cast<double>(node % (Last + 1)) / Last;
  switch (node / (Last + 1))
  {
    case 0:
      return a * sineOf(tip * share);
    case 1:
      return a * sineOf(tip + (1.0 - tip) * share);
    default:
      return a / sineOf(end + (1.0 - end) * share);
  }
}

/// Returns u_r and u_z at the distance r, interpolated as in the shader.
std::array<double, 2> DeflectionTable::at(double r) const
{
  const double a = static_cast<double>(this->radius);
  const bool outside = r >= a;
  const double q = parameterOf(outside ? a / r : r / a);
  const bool tip = !outside && q < static_cast<double>(this->kink);
  const auto begin = static_cast<double>(outside ? this->far : tip ? 0.0F : this->kink);
  const auto end = static_cast<double>(tip ? this->kink : 1.0F);
  const double t = Last * std::clamp((q - begin) / (end - begin), 0.0, 1.0);
  const int i = std::min(static_cast<int>(t), Last - 1);
  const auto first = static_cast<std::size_t>((outside ? 2 : tip ? 0 : 1) * (Last + 1) + i);
  const auto between = [this, first, share = t - i](std::size_t component)
  {
    return (1.0 - share) * static_cast<double>(this->nodes[first][component]) +
      share * static_cast<double>(this->nodes[first + 1][component]);
  };
  return { between(0), between(1) };
}
} // namespace palpate
