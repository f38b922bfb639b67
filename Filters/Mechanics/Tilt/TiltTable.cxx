// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/TiltTable.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Tilt/TiltedFlat.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// A position between evenly spaced nodes of [0, 1].
struct Cell
{
  std::size_t lower;
  double share;
};

Cell cellAt(double place, int nodes) noexcept
{
  const int cells = nodes - 1;
  const double position = std::clamp(place, 0.0, 1.0) * cells;
  const int lower = std::min(static_cast<int>(position), cells - 1);
  return { static_cast<std::size_t>(lower), position - lower };
}

/// The cubic Hermite basis over a cell, in the order lower value, lower slope, upper value, upper
/// slope. Slopes are with respect to the position in the cell.
struct Basis
{
  std::array<double, 4> value;
  std::array<double, 4> slope;
  std::array<double, 4> bend;
};

Basis basisAt(const Cell& cell, int nodes) noexcept
{
  const double t = cell.share;
  const double cells = nodes - 1;
  const double width = 1.0 / cells;
  const double u = 1.0 - t;
  return { { (1.0 + 2.0 * t) * u * u, width * t * u * u, t * t * (3.0 - 2.0 * t),
             -width * t * t * u },
    { -6.0 * t * u * cells, u * (1.0 - 3.0 * t), 6.0 * t * u * cells, t * (3.0 * t - 2.0) },
    { (12.0 * t - 6.0) * cells * cells, (6.0 * t - 4.0) * cells, (6.0 - 12.0 * t) * cells * cells,
      (6.0 * t - 2.0) * cells } };
}

/// η and its derivatives with respect to x and y.
struct PlaneValue
{
  double value = 0.0;
  double byX = 0.0;
  double byY = 0.0;
  double byXTwice = 0.0;
};

/// Adds the contribution of a node with the values η, η_x, η_y, η_xy, multiplied by `weight`. `x`
/// and `y` are 0 for the lower end and 2 for the upper end of the cell.
void add(PlaneValue& sum, const double* node, double weight, const Basis& alongX, std::size_t x,
  const Basis& alongY, std::size_t y) noexcept
{
  const auto along = [&](const std::array<double, 4>& bx, const std::array<double, 4>& by)
  {
    return weight *
      ((node[0] * bx[x] + node[1] * bx[x + 1]) * by[y] +
        (node[2] * bx[x] + node[3] * bx[x + 1]) * by[y + 1]);
  };
  sum.value += along(alongX.value, alongY.value);
  sum.byX += along(alongX.slope, alongY.value);
  sum.byY += along(alongX.value, alongY.slope);
  sum.byXTwice += along(alongX.bend, alongY.value);
}
} // namespace

TiltTable::TiltTable(const TiltTerms& terms, const double* drops, const double* nodes)
  : Terms(terms)
  , Drops(drops, drops + dropCount(terms))
  , Nodes(nodes, nodes + nodeCount(terms))
{
}

std::string faultOfTilts(const TiltTerms& terms)
{
  constexpr double rightAngle = 1.5707963267948966;
  const auto count = [](const char* what, int is, int least, int most) -> std::string
  {
    return is >= least && is <= most
      ? ""
      : joined("the number of ", what, " must be ", least, " to ", most, ", but is ", is);
  };
  if (!(terms.range > 0.0 && std::isfinite(terms.range)))
  {
    return joined("the range of tilts must be positive and finite (mm), but is ", terms.range);
  }
  if (!(terms.largest > 0.0 && terms.largest < rightAngle))
  {
    return joined("the largest tilt must lie between 0 and pi/2 (rad), but is ", terms.largest);
  }
  if (!(terms.dropScale >= 0.0 && std::isfinite(terms.dropScale)))
  {
    return joined(
      "the scale of the drop must be finite and not negative, but is ", terms.dropScale);
  }
  for (const std::string& fault : { count("depths", terms.depths, 2, TiltTerms::MostNodes),
         count("angles", terms.angles, 2, TiltTerms::MostNodes),
         count("drops", terms.drops, 2, TiltTerms::MostNodes),
         count("laws", terms.laws, 1, TiltTerms::MostLaws) })
  {
    if (!fault.empty())
    {
      return fault;
    }
  }
  return {};
}

std::string TiltTable::faultOf(const TiltTerms& terms, const double* drops, const double* nodes)
{
  std::string fault = faultOfTilts(terms);
  if (!fault.empty())
  {
    return fault;
  }
  const auto firstBad = [](const double* values, std::size_t number)
  {
    return static_cast<std::size_t>(
      std::find_if(values, values + number, [](double value) { return !std::isfinite(value); }) -
      values);
  };
  const std::size_t drop = firstBad(drops, dropCount(terms));
  if (drop < dropCount(terms))
  {
    return joined("value ", drop, " of the drops is not finite");
  }
  const std::size_t node = firstBad(nodes, nodeCount(terms));
  return node < nodeCount(terms) ? joined("value ", node, " of the nodes is not finite") : "";
}

DeepestPoint TiltTable::deepest(double angle) const noexcept
{
  const Cell cell = cellAt(angle / this->Terms.largest, this->Terms.drops);
  const Basis basis = basisAt(cell, this->Terms.drops);
  const double* node = this->Drops.data() + 2 * cell.lower;
  const double largest = this->Terms.largest;
  const auto along = [&](const std::array<double, 4>& b)
  { return node[0] * b[0] + largest * node[1] * b[1] + node[2] * b[2] + largest * node[3] * b[3]; };
  const bool isBeyond = this->isBeyond(angle);
  return { along(basis.value), isBeyond ? 0.0 : along(basis.slope) / largest };
}

TiltFactor TiltTable::at(double depth, double angle, const double* weights) const noexcept
{
  const TiltTerms& terms = this->Terms;
  const double x = std::sqrt(depth / terms.range);
  const double y = angle / terms.largest;
  const Cell atX = cellAt(x, terms.depths);
  const Cell atY = cellAt(y, terms.angles);
  const Basis alongX = basisAt(atX, terms.depths);
  const Basis alongY = basisAt(atY, terms.angles);
  const std::size_t row = 4 * static_cast<std::size_t>(terms.angles);
  PlaneValue sum;
  for (std::size_t law = 0; law < static_cast<std::size_t>(terms.laws); ++law)
  {
    if (weights[law] == 0.0)
    {
      continue;
    }
    const double* node = this->Nodes.data() +
      row * (law * static_cast<std::size_t>(terms.depths) + atX.lower) + 4 * atY.lower;
    add(sum, node, weights[law], alongX, 0, alongY, 0);
    add(sum, node + 4, weights[law], alongX, 0, alongY, 2);
    add(sum, node + row, weights[law], alongX, 2, alongY, 0);
    add(sum, node + row + 4, weights[law], alongX, 2, alongY, 2);
  }
  const double xByDepth = x > 1.0 ? 0.0 : 0.5 * x / depth;
  const double xByDepthTwice = -0.5 * xByDepth / depth;
  const double yByAngle = this->isBeyond(angle) ? 0.0 : 1.0 / terms.largest;
  const TiltFactor smooth{ sum.value, sum.byX * xByDepth,
    sum.byXTwice * xByDepth * xByDepth + sum.byX * xByDepthTwice, sum.byY * yByAngle };
  if (!(terms.dropScale > 0.0))
  {
    return smooth;
  }
  const DeepestPoint deepest = this->deepest(angle);
  const double ratio = terms.dropScale * deepest.drop / depth;
  const TiltedFlatTerm rho = tiltedFlatWork(ratio);
  const double rhoByDepth = -rho.slope * ratio / depth;
  const double rhoByDepthTwice = (rho.bend * ratio + 2.0 * rho.slope) * ratio / (depth * depth);
  const double rhoByAngle = rho.slope * terms.dropScale * deepest.offset / depth;
  return { rho.value * smooth.value, rhoByDepth * smooth.value + rho.value * smooth.byDepth,
    rhoByDepthTwice * smooth.value + 2.0 * rhoByDepth * smooth.byDepth +
      rho.value * smooth.byDepthTwice,
    rhoByAngle * smooth.value + rho.value * smooth.byAngle };
}
} // namespace palpate
