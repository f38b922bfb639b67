// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/StrainTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostNodes = 4;
// Fraction of the last root over which c is extrapolated linearly. With this extrapolation the
// slope of a curve that ends with the table does not depend on which nodes near the end are
// evaluated.
constexpr double LinearFraction = 0.25;

/// The nodes around a position, and their weights from Lagrange's polynomials.
struct Weights
{
  std::size_t begin = 0;
  std::size_t count = 1;
  std::array<double, MostNodes> value = { 1.0, 0.0, 0.0, 0.0 };
  std::array<double, MostNodes> slope{};
};

/// Returns the weights of the nodes at `x`. `node(i)` must be ascending; `x` is clamped to the
/// range of the nodes.
template <class Node>
Weights weightsAt(std::size_t nodes, const Node& node, double x)
{
  Weights weights;
  if (nodes < 2)
  {
    return weights;
  }
  const double place = std::clamp(x, node(0), node(nodes - 1));
  std::size_t above = 1;
  while (above + 1 < nodes && node(above) < place)
  {
    ++above;
  }
  weights.count = std::min(MostNodes, nodes);
  weights.begin = std::min(above < 2 ? 0 : above - 2, nodes - weights.count);
  for (std::size_t i = 0; i < weights.count; ++i)
  {
    const double own = node(weights.begin + i);
    double product = 1.0;
    double slope = 0.0;
    for (std::size_t j = 0; j < weights.count; ++j)
    {
      if (j == i)
      {
        continue;
      }
      const double other = node(weights.begin + j);
      slope = (slope * (place - other) + product) / (own - other);
      product *= (place - other) / (own - other);
    }
    weights.value[i] = product;
    weights.slope[i] = slope;
  }
  return weights;
}
} // namespace

StrainTable::StrainTable(
  Axes axes, std::vector<double> factors, const StrainReach& reach, bool constant, double error)
  : Given(std::move(axes))
  , Factors(std::move(factors))
  , Reach(reach)
  , Constant(constant)
  , Error(error)
{
  const std::size_t columns = this->Given.roots.size();
  for (std::size_t begin = 0; begin < this->Factors.size(); begin += columns)
  {
    std::size_t known = 0;
    while (known<columns&& this->Factors[begin + known]> 0.0)
    {
      ++known;
    }
    this->Known.push_back(known == 0 ? 0.0 : this->Given.roots[known - 1]);
    const double last = known == 0 ? 1.0 : this->Factors[begin + known - 1];
    const std::size_t lowers = std::max<std::size_t>(this->Given.seconds.size(), 1);
    const std::size_t heights = std::max<std::size_t>(this->Given.thicknesses.size(), 1);
    const bool isThickest = (this->Known.size() - 1) / lowers % heights == heights - 1;
    this->ThickestEnds = this->ThickestEnds || (isThickest && known < columns);
    std::fill(this->Factors.begin() + static_cast<std::ptrdiff_t>(begin + known),
      this->Factors.begin() + static_cast<std::ptrdiff_t>(begin + columns), last);
  }
}

StrainTable::Course StrainTable::course(double poissonRatio, double thickness, double second) const
{
  const Axes& axes = this->Given;
  const std::size_t columns = axes.roots.size();
  const auto held = [](const std::vector<double>& nodes, double value)
  { return nodes.empty() ? 0.0 : std::clamp(value, nodes.front(), nodes.back()); };
  const auto over = [](const std::vector<double>& nodes, std::size_t asked, double value)
  {
    return asked < 2 ? Weights{}
                     : weightsAt(
                         asked, [&](std::size_t i) { return std::log(nodes[i]); }, std::log(value));
  };
  // If a row of the thickest layer ends early, the thickest layer is not used for thicknesses
  // between thinner layers.
  const std::size_t all = axes.thicknesses.size();
  const bool isBetween = this->ThickestEnds && all > 2 && thickness <= axes.thicknesses[all - 2];
  const Weights ratio = weightsAt(
    axes.ratios.size(), [&](std::size_t i) { return axes.ratios[i]; }, poissonRatio);
  const Weights height = over(axes.thicknesses, isBetween ? all - 1 : all, thickness);
  const Weights lower = over(axes.seconds, axes.seconds.size(), second);

  Course course;
  course.Table = this;
  course.Deepest = this->Reach.at(held(axes.thicknesses, thickness), held(axes.seconds, second));
  const std::size_t heights = std::max<std::size_t>(axes.thicknesses.size(), 1);
  const std::size_t lowers = std::max<std::size_t>(axes.seconds.size(), 1);
  for (std::size_t n = 0; n < ratio.count * height.count * lower.count; ++n)
  {
    const std::size_t i = n / (height.count * lower.count);
    const std::size_t j = n / lower.count % height.count;
    const std::size_t l = n % lower.count;
    const double weight = ratio.value[i] * height.value[j] * lower.value[l];
    if (weight == 0.0)
    {
      continue; // the weight of this row is 0, so that its end does not matter
    }
    const std::size_t row =
      ((ratio.begin + i) * heights + height.begin + j) * lowers + lower.begin + l;
    course.Known = std::min(course.Known, this->Known[row]);
    const double* factors = this->Factors.data() + row * columns;
    course.Factors[0] += weight * (this->Constant ? factors[0] : 1.0);
    for (std::size_t k = 0; k < columns; ++k)
    {
      course.Factors[k + 1] += weight * factors[k];
    }
  }
  return course;
}

StrainFactor StrainTable::Course::at(double depth) const
{
  const std::vector<double>& roots = this->Table->Given.roots;
  const double known = this->Known;
  const double root = std::sqrt(std::max(depth, 0.0) / this->Deepest);
  // There is one more node than roots: the node at depth 0.
  const Weights place = weightsAt(
    roots.size() + 1, [&](std::size_t i) { return i == 0 ? 0.0 : roots[i - 1]; }, root);
  StrainFactor found{ 0.0, 0.0, this->Table->Error };
  for (std::size_t k = 0; k < place.count; ++k)
  {
    const double c = this->Factors[place.begin + k];
    found.factor += place.value[k] * c;
    found.slope += place.slope[k] * c;
  }
  const bool beyond = root > known;
  const double further = known < roots.back() ? 0.0 : std::max(0.0, root - known);
  const double straight = std::min(further, LinearFraction * known);
  const double slope = found.slope; // with respect to the root
  found.factor += slope * straight;
  const bool moves =
    depth > 0.0 && (!beyond || (further > 0.0 && further < LinearFraction * known));
  found.slope = moves ? slope * 0.5 * root / depth : 0.0;
  if (beyond && !this->Table->Constant)
  {
    // Beyond the end the error increases: c may change as much as it changed over the same distance
    // before the end, and its slope may change by half.
    const double asBefore =
      std::max(std::abs(found.factor - 1.0), this->Table->Error) * (root / known - 1.0);
    const double bent = std::abs(slope) * (0.5 * straight + (further - straight));
    found.error += std::max(asBefore, bent);
  }
  return found;
}
} // namespace palpate
