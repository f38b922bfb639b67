// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Edges/EdgeLaw.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::size_t Ratios = 3;
constexpr std::array<double, Ratios> TableRatios = { 0.3, 0.45, 0.5 };

struct TableRow
{
  double exponent;
  double u;
  std::array<std::array<double, 2>, Ratios> psi; ///< value and slope of Ψ
};

constexpr TableRow Table[] = {
#include "Contact/Edges/EdgeLawTable.inc"
};

/// The position u = -end at which a rigid tool with the force exponent `exponent` loses contact
/// with the edge of a quarter space. For the flat end, `end` is larger than the theoretical value
/// 1, see EdgeLaw.
struct Leaving
{
  double exponent;
  double end;
};
constexpr std::array<Leaving, 3> Ends = { { { 1.0, 1.175 }, { 1.5, 1.4142135623730951 },
  { 2.0, 1.5707963267948966 } } };

struct Spline
{
  std::vector<double> at;
  std::vector<double> value;
  std::vector<double> slope;

  EdgeLaw::Value evaluate(double u) const
  {
    const auto above = std::upper_bound(this->at.begin() + 1, this->at.end() - 1, u);
    const auto i = static_cast<std::size_t>(above - this->at.begin());
    const double h = this->at[i] - this->at[i - 1];
    const double t = (u - this->at[i - 1]) / h;
    const double rise = this->value[i] - this->value[i - 1];
    const double a = h * this->slope[i - 1];
    const double b = 3.0 * rise - 2.0 * a - h * this->slope[i];
    const double c = a + h * this->slope[i] - 2.0 * rise;
    return { this->value[i - 1] + t * (a + t * (b + t * c)), (a + t * (2.0 * b + t * 3.0 * c)) / h,
      0.0 };
  }
};

/// Returns the weights of the tabulated Poisson's ratios, for Lagrange interpolation of ln ψ.
std::array<double, Ratios> weightsOf(double poissonRatio)
{
  const double x = std::log(pointLoadSoftness(poissonRatio));
  std::array<double, Ratios> node{};
  std::transform(TableRatios.begin(), TableRatios.end(), node.begin(),
    [](double ratio) { return std::log(pointLoadSoftness(ratio)); });
  // The parabola is valid only between the nodes. Below the first node, linear extrapolation
  // through the first two nodes is used.
  if (x < node[0])
  {
    const double part = (x - node[0]) / (node[1] - node[0]);
    return { 1.0 - part, part, 0.0 };
  }
  std::array<double, Ratios> weight{};
  for (std::size_t i = 0; i < Ratios; ++i)
  {
    weight[i] = 1.0;
    for (std::size_t j = 0; j < Ratios; ++j)
    {
      weight[i] *= i == j ? 1.0 : (x - node[j]) / (node[i] - node[j]);
    }
  }
  return weight;
}

/// Spline for one exponent of the table, from u = -end to u = 8. Its last slope is that of the tail
/// u/(u + k).
Spline splineOf(const Leaving& tool, double poissonRatio)
{
  const std::array<double, Ratios> weight = weightsOf(poissonRatio);
  Spline spline;
  spline.at = { -tool.end };
  spline.value = { 0.0 };
  spline.slope = { 0.0 };
  for (const TableRow& row : Table)
  {
    if (row.exponent == tool.exponent)
    {
      double value = 0.0;
      double slope = 0.0;
      for (std::size_t i = 0; i < Ratios; ++i)
      {
        value += weight[i] * row.psi[i][0];
        slope += weight[i] * row.psi[i][1];
      }
      spline.at.push_back(row.u);
      spline.value.push_back(value);
      spline.slope.push_back(slope);
    }
  }
  const double last = spline.value.back();
  spline.slope.back() = last * (1.0 - last) / spline.at.back(); // slope of u/(u + k)
  return spline;
}
} // namespace

std::string faultOfEdges(const EdgeTerms& terms)
{
  const auto isWithin = [](double value, double least, double most)
  { return value >= least && value <= most; };
  constexpr double most = 1e9; // mm
  if (!isWithin(terms.exponent, 0.0, 100.0) || terms.exponent == 0.0)
  {
    return joined("the exponent must be above 0, at most 100, but is ", terms.exponent);
  }
  if (!isWithin(terms.radius, 0.0, most) || terms.radius == 0.0)
  {
    return joined("the contact radius (mm) must be positive, but is ", terms.radius);
  }
  if (!isWithin(terms.poissonRatio, 0.0, 0.5))
  {
    return joined("Poisson's ratio must lie between 0 and 0.5, but is ", terms.poissonRatio);
  }
  return isWithin(terms.extent, 0.0, most)
    ? ""
    : joined("the extent (mm) must not be negative, but is ", terms.extent);
}

EdgeTerms edgeTermsOf(const AxisymmetricTool& tool, double deflection, double poissonRatio)
{
  EdgeTerms terms;
  terms.exponent =
    std::max(1.0, tool.stiffness(deflection, 1.0) * deflection / tool.force(deflection, 1.0));
  terms.radius = tool.contactRadius(deflection) / std::pow(deflection, terms.exponent - 1.0);
  terms.poissonRatio = poissonRatio;
  return terms;
}

EdgeLaw::EdgeLaw(const EdgeTerms& terms)
  : IsInCurves(terms.isInCurves)
{
  const double m = std::clamp(terms.exponent, Ends.front().exponent, Ends.back().exponent);
  const std::size_t lower = m < Ends[1].exponent ? 0 : 1;
  const double part =
    (m - Ends[lower].exponent) / (Ends[lower + 1].exponent - Ends[lower].exponent);
  this->End = (1.0 - part) * Ends[lower].end + part * Ends[lower + 1].end;
  this->CellWidth = (TailStart + this->End) / static_cast<double>(Cells);
  const std::array<Spline, 2> splines = { splineOf(Ends[lower], terms.poissonRatio),
    splineOf(Ends[lower + 1], terms.poissonRatio) };
  for (std::size_t node = 0; node < this->Nodes.size(); ++node)
  {
    const double u = static_cast<double>(node) * this->CellWidth - this->End;
    Node& found = this->Nodes[node];
    found = {};
    for (std::size_t k = 0; k < 2; ++k)
    {
      // The splines of different exponents end at different u. Beyond the edge (u < 0) each spline
      // is stretched to the common end; the stretch is zero at the edge itself.
      const double stretch = Ends[lower + k].end / this->End - 1.0;
      const double x = u < 0.0 ? u / this->End : 0.0;
      const Value one = splines[k].evaluate(u * (1.0 + stretch * x * x));
      const double weight = k == 0 ? 1.0 - part : part;
      found.value += weight * one.share;
      found.slope += weight * one.slope * (1.0 + 3.0 * stretch * x * x);
    }
    found.value = node == 0 ? 0.0 : found.value;
    found.slope = node == 0 ? 0.0 : found.slope;
  }
  this->Tail = TailStart * (1.0 / this->Nodes.back().value - 1.0);
}

EdgeLaw::Value EdgeLaw::rightEdge(double u) const noexcept
{
  if (this->IsInCurves)
  {
    if (u >= 0.0)
    {
      return {};
    }
    const double x = 1.0 + u / this->End; // x is 1 at the edge
    return x > 0.0 ? Value{ x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) / this->End,
      6.0 * (1.0 - 2.0 * x) / (this->End * this->End) }
                   : Value{ 0.0, 0.0, 0.0 };
  }
  if (u >= TailStart)
  {
    const double sum = u + this->Tail;
    return { u / sum, this->Tail / (sum * sum), -2.0 * this->Tail / (sum * sum * sum) };
  }
  const double place = (u + this->End) / this->CellWidth;
  if (!(place > 0.0))
  {
    return { 0.0, 0.0, 0.0 };
  }
  const std::size_t i = std::min(static_cast<std::size_t>(place), Cells - 1);
  const Node& lower = this->Nodes[i];
  const Node& upper = this->Nodes[i + 1];
  const double t = place - static_cast<double>(i);
  const double rise = upper.value - lower.value;
  const double a = this->CellWidth * lower.slope;
  const double b = 3.0 * rise - 2.0 * a - this->CellWidth * upper.slope;
  const double c = a + this->CellWidth * upper.slope - 2.0 * rise;
  return { lower.value + t * (a + t * (b + t * c)),
    (a + t * (2.0 * b + t * 3.0 * c)) / this->CellWidth,
    (2.0 * b + 6.0 * t * c) / (this->CellWidth * this->CellWidth) };
}

EdgeLaw::Value EdgeLaw::at(double u, double sharpness) const noexcept
{
  const Value right = this->rightEdge(u);
  if (sharpness == 1.0 || this->IsInCurves)
  {
    return right;
  }
  const double sum = right.share + sharpness * (1.0 - right.share);
  const double first = sharpness / (sum * sum);
  const double second = -2.0 * sharpness * (1.0 - sharpness) / (sum * sum * sum);
  return { right.share / sum, first * right.slope,
    first * right.bend + second * right.slope * right.slope };
}

double pointLoadSoftness(double poissonRatio)
{
  constexpr std::array<double, 6> ratio = { 0.0, 0.15, 0.25, 0.3, 0.45, 0.5 };
  constexpr std::array<double, 6> value = { 1.3653, 1.5166, 1.7107, 1.8448, 2.4487, 2.7481 };
  const double nu = std::clamp(poissonRatio, 0.0, 0.5);
  std::size_t i = 1;
  while (i + 1 < ratio.size() && nu > ratio[i])
  {
    ++i;
  }
  // 1/ψ is nearly linear in ν: for ν >= 0.3 it is within 0.15 % of 0.809 - 0.890 ν.
  const double part = (nu - ratio[i - 1]) / (ratio[i] - ratio[i - 1]);
  return 1.0 / ((1.0 - part) / value[i - 1] + part / value[i]);
}

double edgeSharpness(double poissonRatio, double turn)
{
  constexpr double most = 2.0 * Pi / 3.0;
  const double t = std::tan(0.5 * std::min(turn, most));
  if (t > 1.0)
  {
    return std::pow(t, 3.4);
  }
  // The strain at the surface is proportional to 1 - 2ν. Its contribution is (1+ν)(1-2ν)² 2/9,
  // compared with that of cos² inside the body, whose mean is 1/3.
  const double n = 1.0 - 2.0 * poissonRatio;
  const double skin = (1.0 + poissonRatio) * n * n * 2.0 / 9.0;
  const double part = 0.65 * skin / (1.0 / 3.0 + skin);
  return (1.0 - part) * t * t * t + part * t;
}
} // namespace palpate
