// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/KernelError.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Of what of H is no bending, times the square of the turn from facet to facet.
constexpr double OfFacets = 0.8;

/// Of the compliance of a half-space, times (a/d)^4: what of a contact of radius a at a distance d
/// from what is held is missed, in any mesh alike, where nodes are CoarseBesideHeld of that apart
/// or more; less by the square of it where they are closer. Of 45 contacts on the underside of a
/// bunny, a/d from 0.6 to 1, nodes 2.3 mm apart, each solved on a fine mesh of its own, 42 are
/// within; the median is 0.2. On elements of a sixth of the length it is 0.06.
constexpr double BesideHeld = 0.5;
constexpr double CoarseBesideHeld = 0.75;

double missedBesideHeld(const KernelSite& site, double radius)
{
  const double under = std::min(1.0, radius / site.toHeld);
  const double coarse = std::min(1.0, site.spacing / (CoarseBesideHeld * site.toHeld));
  return BesideHeld * std::pow(under, 4) * coarse * coarse / (2.0 * site.reducedModulus * radius);
}
} // namespace

double meshError(const ContactKernel& kernel, const KernelSite& site, double radius)
{
  const double self = std::abs(kernel.coefficients(0, 0));
  const double turn = 2.0 * kernel.gap.drop[1] / (radius * radius) * site.spacing;
  const double direct = std::min(self, site.elements.direct);
  const Eigen::Vector4d parts(site.elements.error * site.spacing / (site.spacing + radius),
    site.elements.bending * (self - direct), direct * OfFacets * std::min(1.0, turn * turn),
    kernel.spread);
  const double elements = site.missed.isKnown()
    ? std::hypot(site.missed.beside(parts.head<3>().norm(), radius), kernel.spread)
    : parts.norm();
  return std::hypot(elements, missedBesideHeld(site, radius));
}

double missedByOne(const ContactKernel& kernel, const KernelSite& site, double radius)
{
  const double under = radius / site.limit;
  return std::abs(kernel.coefficients(0, 0)) *
    std::min(1.0, site.nearestSource / site.limit + under * under);
}
} // namespace palpate
