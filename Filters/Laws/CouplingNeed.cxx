// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/CouplingNeed.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate
{
namespace
{
constexpr double SearchStep = 0.99; // ratio of consecutive distances in the search

/// The data of one point for its coupling with other points.
struct CoupledPoint
{
  double stiffness = 0.0; ///< N/mm, at half of the range
  double modulus = 0.0;   ///< E*, MPa; 0 if only the modes couple contacts
  double thickness = 0.0; ///< mm; 0 for a half-space
  double global = 0.0;    ///< compliance of the modes, mm/N

  double softness() const { return this->modulus > 0.0 ? this->stiffness / this->modulus : 0.0; }
};

CoupledPoint pointOf(const ResponseArrays& arrays, const ResponseField& curves, std::size_t i)
{
  const CouplingTerms& terms = arrays.coupling;
  const double depth = 0.5 * static_cast<double>(arrays.range[i]);
  CoupledPoint point;
  point.stiffness = curves.evaluate(static_cast<std::int32_t>(i), depth).stiffness;
  point.modulus = terms.localModulus ? static_cast<double>(terms.localModulus[i]) : terms.modulus;
  point.thickness =
    terms.localThickness ? static_cast<double>(terms.localThickness[i]) : terms.thickness;
  const auto count = static_cast<std::size_t>(terms.modes ? terms.modeCount : 0);
  for (std::size_t m = 0; m < count; ++m)
  {
    const auto mode = static_cast<double>(terms.modes[count * i + m]);
    point.global += mode * mode;
  }
  return point;
}

/// Returns the relative change |K C(r)| of the force by a second tool at the distance r.
double changeAt(const CoupledPoint& point, const CouplingLaw& law, double distance)
{
  const double share = law.isLayered() ? law.at(distance / point.thickness).value : 1.0;
  const double local =
    point.modulus > 0.0 ? std::abs(share) / (Pi * point.modulus * distance) : 0.0;
  return point.stiffness * (local + point.global);
}
} // namespace

CouplingNeed couplingNeed(const ResponseArrays& arrays, double tolerance)
{
  CouplingNeed need;
  const CouplingTerms& terms = arrays.coupling;
  if (!terms.areFelt())
  {
    return need;
  }
  const ResponseField curves(arrays);
  CoupledPoint widest;
  double global = 0.0;
  for (std::size_t i = 0; i < arrays.points; ++i)
  {
    if (arrays.isUsable(i))
    {
      const CoupledPoint point = pointOf(arrays, curves, i);
      global = std::max(global, point.stiffness * point.global);
      widest = point.softness() >= widest.softness() ? point : widest;
    }
  }
  const CouplingLaw law = terms.knots
    ? CouplingLaw(std::vector<CouplingKnot>(terms.knots, terms.knots + CouplingLaw::KnotCount))
    : CouplingLaw();
  need.apart = !(widest.modulus > 0.0) ? 0.0
    : law.isLayered() ? 2.0 * law.contactRadius(widest.stiffness, widest.modulus, widest.thickness)
                      : widest.softness();
  need.change = need.apart > 0.0 ? changeAt(widest, law, need.apart) : global;
  need.isFelt = need.change > tolerance;
  if (global > tolerance)
  {
    need.reach = Infinity;
    return need;
  }
  // On a half-space the change decreases to the tolerance at this distance; on a layer this happens
  // at a smaller distance.
  need.reach = widest.softness() / (Pi * (tolerance - global));
  while (need.reach > need.apart && changeAt(widest, law, need.reach) < SearchStep * tolerance)
  {
    need.reach *= SearchStep;
  }
  return need;
}

std::string couplingReason(const CouplingNeed& need, const CouplingTerms& terms, double tolerance)
{
  if (!terms.areFelt())
  {
    return {};
  }
  if (!need.isFelt)
  {
    return joined("the interaction of tools is left out: equal tools side by side change the force "
                  "by no more than ",
      inPercent(need.change), ", within ", inPercent(tolerance));
  }
  const std::string sideBySide = need.apart > 0.0
    ? joined(", side by side (", std::round(100.0 * need.apart) / 100.0, " mm) by up to ",
        inPercent(need.change))
    : std::string();
  return std::isinf(need.reach)
    ? joined("tools that press at once interact at any distance: the body as a whole gives way, "
             "which changes the force of equal tools by more than ",
        inPercent(tolerance), sideBySide)
    : joined("tools that press at once interact: equal tools closer than ",
        std::ceil(10.0 * need.reach) / 10.0, " mm change the force by more than ",
        inPercent(tolerance), sideBySide);
}
} // namespace palpate
