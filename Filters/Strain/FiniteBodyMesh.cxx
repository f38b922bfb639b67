// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a FiniteBody: its elements, fixed displacements and indices of the unknowns.
#include "Strain/FiniteBody.h"

#include "Strain/GradedMesh.h"
#include "Strain/QuadraticLine.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/ReducedModulus.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double Growth = 1.6;
// Distance at which the nodes of a half-space are fixed, in contact radii.
constexpr double FarAway = 1000.0;
// Stiffness of the penalty, as a multiple of E* divided by the contact radius.
constexpr double PenaltyFactor = 300.0;
constexpr double ElementsPerFillet = 5.0;
// Radius of the hole at the centre of a ball, as a fraction of the ball's radius. Closer to the
// centre the elements would have no width.
constexpr double CentralHole = 0.02;

/// Returns (r, z) of the point at the distance `along` from the axis, measured along the surface,
/// and at the depth `below` the surface. The surface on the axis is at z = 0.
Eigen::Vector2d placeOf(double bodyRadius, double along, double below)
{
  if (bodyRadius == 0.0)
  {
    return { along, -below };
  }
  const double angle = along / bodyRadius;
  const double half = std::sin(0.5 * angle);
  return { (bodyRadius - below) * std::sin(angle),
    -below - 2.0 * (bodyRadius - below) * half * half };
}

/// Returns the distance at which the mesh of a half-space ends. It is larger if the layers above
/// are stiffer.
double farEnd(const FiniteProblem& problem, double above)
{
  double stiffest = 1.0;
  for (const FiniteLayer& layer : problem.layers)
  {
    stiffest = std::max(stiffest, layer.youngsModulus / problem.layers.back().youngsModulus);
  }
  return above + FarAway * stiffest * problem.contactRadius;
}

/// Returns the depth of the mesh. `above` is the thickness of the finite layers. The mesh of a ball
/// extends almost to the centre.
double meshBottom(const FiniteProblem& problem, double above, bool isHalfSpace)
{
  const bool isWholeBall = isHalfSpace && problem.bodyRadius > 0.0;
  return isWholeBall ? (1.0 - CentralHole) * problem.bodyRadius
    : isHalfSpace    ? farEnd(problem, above)
                     : above;
}

/// Returns the width of the mesh along the surface. On a ball the mesh extends to the plane of
/// symmetry, in a cavity to its opposite end.
double meshWidth(const FiniteProblem& problem, double above, bool isHalfSpace)
{
  const double curved = problem.bodyRadius;
  return curved > 0.0 ? 0.5 * Pi * curved
    : curved < 0.0    ? -Pi * curved
    : isHalfSpace     ? farEnd(problem, above)
                      : 2.0 * problem.contactRadius + 10.0 * above;
}
} // namespace

FiniteBody::FiniteBody(const ToolOutline& tool, const FiniteProblem& problem)
  : Tool(tool)
{
  const double a = problem.contactRadius;
  const double edge = problem.edge * a;
  double thickness = 0.0;
  std::vector<double> interfaces;
  this->IsLinear = true;
  for (const FiniteLayer& layer : problem.layers)
  {
    const double e = layer.youngsModulus;
    const double nu = layer.poissonRatio;
    this->Materials.push_back({ StrainEnergy(layer.model, e / (2.0 * (1.0 + nu)), layer.parameter),
      e / (3.0 * (1.0 - 2.0 * nu)) });
    this->IsLinear = this->IsLinear && layer.model == StrainModel::Linear;
    thickness += layer.thickness;
    interfaces.push_back(thickness);
  }
  const FiniteLayer& top = problem.layers.front();
  this->Penalty = PenaltyFactor * reducedModulus(top.youngsModulus, top.poissonRatio) / a;
  const bool isHalfSpace = std::isinf(thickness);
  interfaces.pop_back();
  const double above = isHalfSpace ? (interfaces.empty() ? 0.0 : interfaces.back()) : thickness;
  const double curved = problem.bodyRadius;
  const bool isWholeBall = isHalfSpace && curved > 0.0;
  const double bottom = meshBottom(problem, above, isHalfSpace);
  const double width = meshWidth(problem, above, isHalfSpace);

  std::vector<FineRange> across = { { 0.0, 1.1 * a, edge } };
  std::vector<FineRange> down = { { 0.0, 1.05 * a, edge } };
  for (const auto& [from, to] : tool.fillets())
  {
    const double fine = std::min(edge, (to - from) / ElementsPerFillet);
    across.push_back({ from - (to - from), to + (to - from), fine });
    down.push_back({ 0.0, 0.0, fine });
  }
  const std::vector<double> rs = gradedDivision(width, across, Growth);
  const std::vector<double> zs = gradedDivision(bottom, down, Growth, interfaces);
  const auto columns = 2 * static_cast<int>(rs.size()) - 1;
  const auto rows = 2 * static_cast<int>(zs.size()) - 1;
  const auto nodeAt = [columns](int column, int row) { return row * columns + column; };

  this->UnknownOf.assign(2 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  for (int row = 0; row < rows; ++row) // rows are numbered from the surface downwards
  {
    for (int column = 0; column < columns; ++column)
    {
      const auto node = 2 * static_cast<std::size_t>(nodeAt(column, row));
      const bool isBottom = row == rows - 1;
      const bool isOuter = column == columns - 1;
      const bool isBase = isBottom && !isWholeBall;
      const bool isHeldR = column == 0 || (isOuter && !(curved > 0.0)) ||
        (isBase && !(problem.slipBase && !isHalfSpace));
      const bool isHeldZ = isBase || (isOuter && (isHalfSpace || curved > 0.0) && !(curved < 0.0));
      this->UnknownOf[node] = isHeldR ? -1 : static_cast<int>(this->Unknowns++);
      this->UnknownOf[node + 1] = isHeldZ ? -1 : static_cast<int>(this->Unknowns++);
    }
  }
  for (std::size_t k = 0; k + 1 < zs.size(); ++k)
  {
    const double middle = 0.5 * (zs[k] + zs[k + 1]);
    const auto layer = static_cast<std::size_t>(
      std::upper_bound(interfaces.begin(), interfaces.end(), middle) - interfaces.begin());
    for (std::size_t i = 0; i + 1 < rs.size(); ++i)
    {
      Element element{ {}, layer, {} };
      for (int j = 0; j < 3; ++j)
      {
        for (int m = 0; m < 3; ++m)
        {
          // The local coordinate y of the element points upwards, like z.
          const auto node = 3 * static_cast<std::size_t>(j) + static_cast<std::size_t>(m);
          element.nodes[node] =
            nodeAt(2 * static_cast<int>(i) + m, 2 * static_cast<int>(k) + 2 - j);
          element.places.col(static_cast<Eigen::Index>(node)) = placeOf(curved,
            rs[i] + 0.5 * m * (rs[i + 1] - rs[i]), zs[k + 1] + 0.5 * j * (zs[k] - zs[k + 1]));
        }
      }
      this->Elements.push_back(element);
    }
  }
  // The outline of the tool has no upper end in the model. Therefore the tool must not touch the
  // other side of a cavity.
  const double touchable = curved != 0.0 ? Pi / 3.0 * std::abs(curved) : width;
  for (std::size_t i = 0; i + 1 < rs.size() && rs[i + 1] <= touchable; ++i)
  {
    const double length = rs[i + 1] - rs[i];
    for (std::size_t g = 0; g < QuadraticLine::GaussCount; ++g)
    {
      const Eigen::Vector2d place =
        placeOf(curved, rs[i] + 0.5 * length * (1.0 + QuadraticLine::GaussNode[g]), 0.0);
      const int column = 2 * static_cast<int>(i);
      this->Surface.push_back(
        { { column, column + 1, column + 2 }, QuadraticLine::shapes(QuadraticLine::GaussNode[g]),
          place, QuadraticLine::GaussWeight[g] * 0.5 * length * 2.0 * Pi * place.x() });
    }
  }
  this->makePattern();
}

void FiniteBody::makePattern()
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto each = [this](const Element& element, auto&& visit)
  {
    for (int i = 0; i < ElementUnknowns; ++i)
    {
      const int row = this->unknownOf(element, i);
      for (int k = 0; k <= i; ++k)
      {
        const int column = this->unknownOf(element, k);
        visit(row, column);
      }
    }
  };
  for (const Element& element : this->Elements)
  {
    each(element,
      [&entries](int row, int column)
      {
        if (row >= 0 && column >= 0)
        {
          entries.emplace_back(std::max(row, column), std::min(row, column), 0.0);
        }
      });
  }
  this->Tangent.resize(this->Unknowns, this->Unknowns);
  this->Tangent.setFromTriplets(entries.begin(), entries.end());
  this->Tangent.makeCompressed();
  const int* outer = this->Tangent.outerIndexPtr();
  const int* inner = this->Tangent.innerIndexPtr();
  this->ValueOf.reserve(this->Elements.size() * ElementUnknowns * (ElementUnknowns + 1) / 2);
  for (const Element& element : this->Elements)
  {
    each(element,
      [&](int row, int column)
      {
        int found = -1;
        if (row >= 0 && column >= 0)
        {
          const int low = std::min(row, column);
          found = static_cast<int>(
            std::lower_bound(inner + outer[low], inner + outer[low + 1], std::max(row, column)) -
            inner);
        }
        this->ValueOf.push_back(found);
      });
  }
}
} // namespace palpate
