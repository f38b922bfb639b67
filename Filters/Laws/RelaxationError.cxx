// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/RelaxationError.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::array<int, 4> Elements = { 0, 4, 8, 16 };
constexpr std::array<int, 5> Choices = { 0, 4, 8, 16, 32 };

struct TableRow
{
  double exponent;
  std::array<double, Elements.size()> error;
};
// Columns QLV_U, C4^2, C8^2 and C16^2 of tick_variants.csv: the largest errors over all runs at
// full depth.
constexpr std::array<TableRow, 3> Table = { { { 1.0, { 7.3e-5, 7.3e-5, 7.3e-5, 7.3e-5 } },
  { 1.5, { 0.1025, 0.0400, 0.0126, 0.0040 } }, { 2.0, { 0.1200, 0.0812, 0.0295, 0.0091 } } } };

/// Returns the error for one column of the table. A column is one number of elements.
double errorAt(std::size_t column, double exponent)
{
  const std::size_t lower = exponent < Table[1].exponent ? 0 : 1;
  const TableRow& a = Table[lower];
  const TableRow& b = Table[lower + 1];
  const double part = (std::max(exponent, a.exponent) - a.exponent) / (b.exponent - a.exponent);
  return a.error[column] + part * (b.error[column] - a.error[column]);
}

} // namespace

double relaxationError(int elements, double exponent)
{
  if (elements < Elements[1])
  {
    return errorAt(0, exponent);
  }
  std::size_t lower = 1;
  while (lower + 2 < Elements.size() && elements >= Elements[lower + 1])
  {
    ++lower;
  }
  const double fewer = errorAt(lower, exponent);
  const double more = errorAt(lower + 1, exponent);
  const double doublings = std::log2(static_cast<double>(elements) / Elements[lower]);
  return fewer * std::pow(more / fewer, doublings);
}

RelaxationNeed relaxationNeed(const RelaxationTerms& terms, std::size_t points, double tolerance)
{
  RelaxationNeed need;
  const std::size_t branches = terms.series.count;
  need.strength = terms.isPerPoint() ? 0.0 : terms.series.total();
  for (std::size_t i = 0; terms.isPerPoint() && i < points; ++i)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < branches; ++k)
    {
      sum += static_cast<double>(terms.strength[branches * i + k]);
    }
    need.strength = std::max(need.strength, sum);
  }
  need.isFelt = need.strength > tolerance;
  if (!need.isFelt)
  {
    return need;
  }
  const auto errorWith = [&](int elements)
  { return std::min(relaxationError(elements, terms.exponent), need.strength); };
  need.simplest = errorWith(0);
  for (const int choice : Choices)
  {
    need.elements = choice;
    need.error = errorWith(choice);
    if (need.error <= tolerance)
    {
      break;
    }
  }
  return need;
}

std::string relaxationReason(
  const RelaxationNeed& need, const PronySeries& series, double tolerance)
{
  if (series.count == 0)
  {
    return {};
  }
  if (!need.isFelt)
  {
    return joined("relaxation is left out: it adds ", inPercent(need.strength),
      " to the force at most, within ", inPercent(tolerance));
  }
  std::string words = need.elements == 0
    ? joined("the body relaxes, quasi-linear suffices (Relaxation Elements 0): off by ",
        inPercent(need.error))
    : joined("the body relaxes, in ", need.elements, " elements (Relaxation Elements): off by ",
        inPercent(need.error));
  words += " of the largest force";
  words += need.error > tolerance ? joined(", more than ", inPercent(tolerance)) : "";
  words += need.elements > 0 ? joined("; quasi-linear by ", inPercent(need.simplest)) : "";
  const auto [least, most] =
    std::minmax_element(series.time.begin(), series.time.begin() + series.count);
  return words +
    joined("; the speed of the tool is not known: a press that takes much longer than ", *most,
      " s has the force of the slow response, a press much shorter than ", *least,
      " s a force up to ", inPercent(need.strength), " larger");
}
} // namespace palpate
