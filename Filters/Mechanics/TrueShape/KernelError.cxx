// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/TrueShape/KernelError.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Of what of H is no bending, times the square of the turn from facet to facet.
constexpr double OfFacets = 0.8;
} // namespace

double meshError(const ContactKernel& kernel, const KernelSite& site, double radius)
{
  const double self = std::abs(kernel.coefficients(0, 0));
  const double turn = 2.0 * kernel.gap.drop[1] / (radius * radius) * site.spacing;
  const double direct = std::min(self, site.elements.direct);
  const Eigen::Vector4d parts(site.elements.error * site.spacing / (site.spacing + radius),
    site.elements.bending * (self - direct), direct * OfFacets * std::min(1.0, turn * turn),
    kernel.spread);
  return site.missed.isKnown()
    ? std::hypot(site.missed.beside(parts.head<3>().norm(), radius), kernel.spread)
    : parts.norm();
}

double missedByOne(const ContactKernel& kernel, const KernelSite& site, double radius)
{
  const double under = radius / site.limit;
  return std::abs(kernel.coefficients(0, 0)) *
    std::min(1.0, site.nearestSource / site.limit + under * under);
}
} // namespace palpate
