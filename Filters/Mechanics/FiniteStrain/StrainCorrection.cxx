// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/StrainCorrection.h"

#include "Mechanics/FiniteStrain/FiniteIndentation.h"
#include "Mechanics/FiniteStrain/NeoHookeTables.h"
#include "Mechanics/FiniteStrain/StrainCache.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// c is straight over √δ near 0; the mesh knows nothing of contacts of a few elements.
const std::vector<double> SolvedRoots = { 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0 };
constexpr double LargestRatio = 0.495;       // of those that are solved for
constexpr int RatioNodes = 4;                // unless there is but one value
constexpr double ThicknessStep = 2.0;        // between nodes, at most
constexpr double SolvedError = 0.003;        // of c: mesh, far field and interpolation
constexpr double BeyondLargestRatio = 0.006; // c from 0.495 to 0.5 at δ = R
constexpr double Fillet = 0.1;               // of the contact radius, at corners
constexpr double CornerError = 0.01;         // of c: that fillet against one half as large

std::vector<double> ratioNodes(const StrainBodies& bodies)
{
  const double first = std::min(bodies.leastRatio, LargestRatio);
  const double last = std::min(bodies.mostRatio, LargestRatio);
  std::vector<double> ratios = { first };
  for (int i = 1; last > first && i < RatioNodes; ++i)
  {
    ratios.push_back(first + (last - first) * i / (RatioNodes - 1));
  }
  return ratios;
}

std::vector<double> thicknessNodes(double thinnest, double thickest)
{
  const double steps = std::ceil(std::log(thickest / thinnest) / std::log(ThicknessStep) - 1e-9);
  const int count = std::max(0, static_cast<int>(steps));
  std::vector<double> nodes = { thinnest };
  for (int i = 1; i <= count; ++i)
  {
    nodes.push_back(thinnest * std::pow(thickest / thinnest, static_cast<double>(i) / count));
  }
  return nodes;
}

ToolOutline outlineOf(const AxisymmetricTool& tool, double deepest)
{
  const double radius = tool.contactRadius(deepest);
  return { tool, 3.0 * radius, Fillet * radius };
}

/// Forces at the roots of `deepest`, as far as there is an equilibrium.
FiniteCurve forcesOf(const AxisymmetricTool& tool, FiniteLayer layer, StrainModel model, bool slips,
  double deepest, const std::function<bool(double)>& goOn)
{
  layer.model = model;
  FiniteProblem problem;
  problem.layers = { layer };
  problem.slipBase = slips;
  problem.contactRadius = tool.contactRadius(deepest);
  for (const double root : SolvedRoots)
  {
    problem.depths.push_back(deepest * root * root);
  }
  return pressTool(outlineOf(tool, deepest), problem, goOn);
}

/// Solves for one table, or reads what was solved for before. Empty where `goOn` ended it.
class TableMaker
{
public:
  TableMaker(const AxisymmetricTool& tool, const StrainLaw& law, LayerBase base, double deepest)
    : Tool(tool)
    , Law(law)
    , Base(base)
    , Deepest(deepest)
  {
  }

  std::unique_ptr<StrainTable> make(
    const StrainTable::Axes& axes, const std::function<bool(double)>& goOn) const
  {
    const std::string key = this->key(axes);
    const std::size_t rows = axes.ratios.size() * std::max<std::size_t>(1, axes.thicknesses.size());
    std::vector<double> factors = readStrainCache(key, rows * axes.roots.size());
    if (factors.empty())
    {
      factors = this->solve(axes, rows, goOn);
      if (factors.empty())
      {
        return nullptr;
      }
      writeStrainCache(key, factors);
    }
    const bool hasCorner = !outlineOf(this->Tool, this->Deepest).fillets().empty();
    return std::make_unique<StrainTable>(axes, std::move(factors),
      std::vector<double>{ this->Deepest }, false, SolvedError + (hasCorner ? CornerError : 0.0));
  }

private:
  std::string key(const StrainTable::Axes& axes) const
  {
    std::string key = joined("finite strain 1|", this->Tool.specification(), "|",
      describe(this->Law), "|", static_cast<int>(this->Base), "|", shortestDecimals(this->Deepest));
    for (const std::vector<double>* axis : { &axes.ratios, &axes.thicknesses, &axes.roots })
    {
      key += "|";
      for (const double value : *axis)
      {
        key += shortestDecimals(value) + ",";
      }
    }
    return key;
  }

  std::vector<double> solve(
    const StrainTable::Axes& axes, std::size_t rows, const std::function<bool(double)>& goOn) const
  {
    std::vector<double> factors;
    std::size_t done = 0;
    for (const double ratio : axes.ratios)
    {
      for (std::size_t j = 0; j < rows / axes.ratios.size(); ++j)
      {
        FiniteLayer layer;
        layer.poissonsRatio = ratio;
        layer.youngsModulus = 1.0;
        layer.parameter = this->Law.parameter;
        if (!axes.thicknesses.empty())
        {
          layer.thickness = axes.thicknesses[j];
        }
        bool ended = false;
        const auto part = [&](double from, double width)
        {
          return [&, from, width](double fraction)
          {
            const double all = (static_cast<double>(done) + from + width * fraction);
            ended = ended || (goOn && !goOn(all / static_cast<double>(rows)));
            return !ended;
          };
        };
        const bool slips = this->Base == LayerBase::Slip;
        const FiniteCurve small =
          forcesOf(this->Tool, layer, StrainModel::Linear, slips, this->Deepest, part(0.0, 0.3));
        const FiniteCurve finite =
          forcesOf(this->Tool, layer, this->Law.model, slips, this->Deepest, part(0.3, 0.7));
        if (ended)
        {
          return {};
        }
        for (std::size_t k = 0; k < axes.roots.size(); ++k)
        {
          const bool known = k < small.points.size() && k < finite.points.size();
          factors.push_back(known ? finite.points[k].force / small.points[k].force : 0.0);
        }
        ++done;
      }
    }
    return factors;
  }

  const AxisymmetricTool& Tool;
  const StrainLaw& Law;
  LayerBase Base;
  double Deepest;
};
} // namespace

StrainCorrection::Value StrainCorrection::at(
  double depth, double poissonsRatio, double thickness) const
{
  const StrainTable* table = thickness > 0.0 ? this->Layers.get() : this->HalfSpace.get();
  if (!table)
  {
    return {};
  }
  Value found = table->at(depth, std::min(poissonsRatio, LargestRatio), thickness);
  found.error += poissonsRatio > LargestRatio ? BeyondLargestRatio : 0.0;
  return found;
}

std::string makeStrainCorrection(const AxisymmetricTool& tool, const StrainLaw& law,
  const StrainBodies& bodies, double deepest, const std::function<bool(double)>& goOn,
  std::unique_ptr<StrainCorrection>& made)
{
  made.reset();
  if (law.model == StrainModel::Linear)
  {
    return {};
  }
  std::string fault = checkStrainEnergy(law.model, law.parameter);
  if (!fault.empty())
  {
    return fault;
  }
  const bool hasLayers = bodies.thickest > 0.0;
  auto correction = std::make_unique<StrainCorrection>();
  const TableMaker maker(tool, law, bodies.base, deepest);
  const auto half = [&](double from, double width)
  {
    return [&goOn, from, width](double fraction) { return !goOn || goOn(from + width * fraction); };
  };
  const double forHalfSpace = bodies.hasHalfSpace && hasLayers ? 0.5 : 1.0;
  if (bodies.hasHalfSpace)
  {
    std::unique_ptr<StrainTable> table =
      law.model == StrainModel::NeoHooke ? neoHookeOnHalfSpace(tool, deepest) : nullptr;
    if (!table)
    {
      table = maker.make({ ratioNodes(bodies), {}, SolvedRoots }, half(0.0, forHalfSpace));
    }
    if (!table)
    {
      return {};
    }
    correction->setHalfSpace(std::move(table));
  }
  if (hasLayers)
  {
    std::unique_ptr<StrainTable> table =
      law.model == StrainModel::NeoHooke && bodies.base == LayerBase::Bonded
      ? neoHookeOnLayers(tool, bodies.thinnest, bodies.thickest, deepest)
      : nullptr;
    if (!table)
    {
      table = maker.make(
        { ratioNodes(bodies), thicknessNodes(bodies.thinnest, bodies.thickest), SolvedRoots },
        half(1.0 - forHalfSpace, forHalfSpace));
    }
    if (!table)
    {
      return {};
    }
    correction->setLayers(std::move(table));
  }
  made = std::move(correction);
  return {};
}
} // namespace palpate
