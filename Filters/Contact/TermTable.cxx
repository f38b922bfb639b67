// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/TermTable.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Checks that all strengths and compliances are finite and not negative.
std::string faultOfPointRelaxation(const ResponseArrays& response)
{
  const RelaxationTerms& terms = response.relaxation;
  const auto check = [&response](const float* values, std::size_t components, const char* what)
  {
    const std::size_t count = values ? response.points * components : 0;
    const float* wrong = std::find_if_not(
      values, values + count, [](float value) { return value >= 0.0F && std::isfinite(value); });
    return wrong == values + count ? std::string()
                                   : joined(what, " of ", *wrong, " at point ",
                                       static_cast<std::size_t>(wrong - values) / components);
  };
  return firstFault([&] { return check(terms.strength, terms.series.count, "a relaxation"); },
    [&] { return check(terms.elasticCompliance, 1, "an elastic compliance"); });
}
} // namespace

const std::array<TermRow, 4> TermTable = { {
  { ContractArray::Use::Edges, "has edges that cannot be used: ",
    [](const ResponseArrays& response)
    { return response.edges.areFelt() ? faultOfEdges(response.edges) : std::string(); } },
  { ContractArray::Use::Relaxation, "has ", faultOfPointRelaxation },
  { ContractArray::Use::Coupling, "couples wrongly: ",
    [](const ResponseArrays& response)
    { return faultOfCoupling(response.coupling, response.points); } },
  { ContractArray::Use::Tilt, "has tilts that cannot be used: ",
    [](const ResponseArrays& response)
    {
      return response.tilt.areFelt() ? faultOfTiltViews(response.tilt, response.points)
                                     : std::string();
    } },
} };

std::string faultOfTerms(const ResponseArrays& response)
{
  for (const TermRow& term : TermTable)
  {
    const std::string fault = term.fault(response);
    if (!fault.empty())
    {
      return term.isWrong + fault;
    }
  }
  return {};
}
} // namespace palpate
