// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/TrueShape/ContactHarmonics.h"

#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// d ln F / d ln a at a sample, by its neighbours.
double growth(const std::vector<ContactSample>& samples, std::size_t i)
{
  const std::size_t low = i > 0 ? i - 1 : 0;
  const std::size_t high = std::min(i + 1, samples.size() - 1);
  return std::log(samples[high].force / samples[low].force) /
    std::log(samples[high].radius / samples[low].radius);
}

/// Of the part of second order that a surface's shape has, what third order may do. Measured on
/// random waves against contacts without an angle mean (SurfaceGapTest).
constexpr double LeftOfGap = 0.4;
/// How far smooth patches lie off the body that has the same points: of the geometric mean of how
/// far facets lie off them, and of how uneven their edges are. Measured on bumps, those that the
/// points describe and those that they do not (GapOfSurfaceTest), and on scans of a bunny and a
/// dragon of which a third, a tenth or a twentieth of the points was left.
constexpr double LeftOfFacets = 1.0 / 3.0;
/// g² of what is left of a gap, over its mean square.
constexpr double OfRoughness = 30.0;
} // namespace

void addHarmonics(std::vector<ContactSample>& samples, std::size_t growing,
  const std::vector<ContactKernel>& kernels, const std::vector<double>& stiffness, double modulus)
{
  std::vector<double> parts(samples.size(), 0.0);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    ContactSample& s = samples[i];
    if (!(s.deflection > 0.0 && s.force > 0.0))
    {
      continue;
    }
    const ContactKernel& kernel = kernels[i];
    // da/dF; 0 where the radius stays.
    const double grows = i < growing && growing > 1 ? growth(samples, i) : Infinity;
    const double widens = grows > 0.0 ? s.radius / (s.force * grows) : 0.0;
    const double torque = 4.0 / 3.0 * modulus * s.radius * s.radius * s.radius;
    const auto leaning = [&](const Eigen::Vector2d& slope)
    { return 2.0 * modulus * s.radius * s.radius * slope.squaredNorm() * widens; };
    const Eigen::Vector2d turned = kernel.gap.lean + kernel.tilt * s.force;
    const double tilt =
      kernel.tilt.dot(turned) * torque + leaning(turned) - leaning(kernel.gap.lean);
    const double gap = leaning(kernel.gap.lean) + 0.5 * modulus * kernel.gap.waves * widens;
    const double rough = 0.5 * modulus * OfRoughness * kernel.gap.left * widens;
    const double open = LeftOfFacets * std::sqrt(kernel.gap.facets * kernel.gap.uneven);
    parts[i] = tilt + gap;
    s.harmonics = tilt / s.deflection;
    s.gap += stiffness[i] / s.force * (LeftOfGap * gap + rough);
    s.surface = stiffness[i] / s.force * open;
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    samples[i].deflection -= parts[i];
  }
}
} // namespace palpate
