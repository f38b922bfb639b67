// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Tilt/TiltViews.h"

#include "Mechanics/JoinedText.h"

#include <cmath>

namespace palpate
{
std::string faultOfTiltViews(const TiltViews& views, std::size_t points)
{
  std::string fault = TiltTable::faultOf(views.terms, views.drops, views.nodes);
  if (!fault.empty() || (views.terms.laws == 1 && !views.weight))
  {
    return fault;
  }
  if (!views.weight)
  {
    return joined("there are ", views.terms.laws, " laws of tilts, but no weights of the points");
  }
  constexpr double rounding = 1e-4; // tolerance for the rounding of floats
  const auto laws = static_cast<std::size_t>(views.terms.laws);
  for (std::size_t i = 0; i < points; ++i)
  {
    double sum = 0.0;
    for (std::size_t law = 0; law < laws; ++law)
    {
      sum += static_cast<double>(views.weight[laws * i + law]);
    }
    if (!(std::abs(sum - 1.0) <= rounding))
    {
      return joined("the weights of tilts at point ", i, " must have the sum 1, but have ", sum);
    }
  }
  return {};
}
} // namespace palpate
