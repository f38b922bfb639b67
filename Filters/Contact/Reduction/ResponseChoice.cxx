// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/ResponseChoice.h"

#include "Mechanics/ContactRegime.h"
#include "Contact/Reduction/LawChoice.h"
#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/ResponseContract.h"
#include "Contact/Reduction/SpringChoice.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
/// Regime, validity, depths and ranges of the points that have a response.
void lookAtPoints(ResponseChoice& choice, const ReducibleCurves& curves,
  const ChoiceEvidence& evidence, const ChoiceSettings& settings)
{
  std::size_t shapeless = 0;
  std::size_t beyond = 0;
  std::array<std::size_t, ResponseLimitCount> limits{};
  for (std::size_t i = 0; i < curves.count(); ++i)
  {
    const std::size_t p = curves.point(i);
    const double range = curves.range(i);
    const double depth = settings.depth > 0.0 ? settings.depth : 0.5 * range;
    choice.range.add(range, i == 0);
    choice.depth.add(depth, i == 0);
    shapeless += evidence.verdict &&
        evidence.verdict[p] == static_cast<std::uint8_t>(RegimeVerdict::PointForceSuffices)
      ? 1
      : 0;
    if (evidence.validity && depth > static_cast<double>(evidence.validity[p]))
    {
      ++beyond;
      ++limits[evidence.limit ? std::min<std::size_t>(evidence.limit[p], ResponseLimitCount - 1)
                              : 0];
    }
  }
  const auto all = static_cast<double>(curves.count());
  choice.regimeKnown = evidence.verdict != nullptr;
  choice.shapelessShare = static_cast<double>(shapeless) / all;
  choice.validityKnown = evidence.validity != nullptr;
  choice.beyondShare = static_cast<double>(beyond) / all;
  choice.firstLimit =
    static_cast<int>(std::max_element(limits.begin(), limits.end()) - limits.begin());
}
} // namespace

ResponseChoice chooseResponse(
  const ResponseArrays& arrays, const ChoiceEvidence& evidence, const ChoiceSettings& settings)
{
  ResponseChoice choice;
  choice.exponent = arrays.exponent;
  choice.numbersPerPoint = arrays.basis ? arrays.laws : 2 * arrays.samples;
  const ReducibleCurves curves(arrays);
  choice.points = curves.count();
  if (curves.count() == 0)
  {
    return choice;
  }
  lookAtPoints(choice, curves, evidence, settings);
  if (!chooseSprings(choice, arrays, curves, settings))
  {
    chooseLaws(choice, arrays, curves, settings);
  }
  return choice;
}
} // namespace palpate
