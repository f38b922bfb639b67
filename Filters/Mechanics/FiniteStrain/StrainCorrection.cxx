// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/StrainCorrection.h"

#include "Mechanics/FiniteStrain/FiniteOverSmall.h"
#include "Mechanics/FiniteStrain/NeoHookeTables.h"
#include "Mechanics/FiniteStrain/StrainSolution.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// c is linear in √δ near 0; the mesh cannot resolve contacts of a few elements.
const std::vector<double> SolvedRoots = { 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0 };
constexpr double LargestRatio = 0.495;       // of those that are solved for
constexpr int RatioNodes = 4;                // unless there is but one value
constexpr double ThicknessStep = 2.0;        // between nodes, at most
constexpr double DeepestFraction = 0.7;      // of the layers on a rigid base
constexpr double SolvedError = 0.003;        // of c: mesh, far field and interpolation
constexpr double BeyondLargestRatio = 0.006; // c from 0.495 to 0.5 at δ = R
constexpr double CornerError = 0.01;         // of c: a corner's fillet against one half as large

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

/// Deep enough for the thickest, and nowhere deeper than a fraction of the thickness.
StrainReach reachOf(double deepest, const StrainBodies& bodies)
{
  const LayerStack& stack = bodies.stack;
  if (stack.hasHalfSpace)
  {
    return { deepest };
  }
  StrainReach reach{ Infinity, DeepestFraction };
  for (std::size_t i = 2; i < stack.layers.size(); ++i)
  {
    reach.below += stack.layers[i].thickness;
  }
  const double most = reach.at(bodies.thickest, bodies.second.thickest);
  reach.endless = deepest < most ? 1.0 / (1.0 / deepest - 1.0 / most) : Infinity;
  return reach;
}

/// Neo-Hooke's table of layers; null outside its range.
std::unique_ptr<StrainTable> layersTable(
  const AxisymmetricTool& tool, const StrainBodies& bodies, double deepest)
{
  return bodies.base == LayerBase::Bonded && bodies.stack.layers.empty()
    ? neoHookeOnLayers(tool, bodies.thinnest, bodies.thickest, deepest)
    : nullptr;
}

/// The layers for the solver, the top one of 1 MPa, since c is dimensionless.
LayerStack solvedStack(const StrainBodies& bodies)
{
  LayerStack stack = bodies.stack;
  if (stack.layers.empty())
  {
    stack.layers = { StackLayer{ 1.0, 1.0, 0.0 } };
    stack.base = bodies.base;
  }
  const double unit = stack.layers.front().youngsModulus;
  const auto held = [unit](StackLayer& layer)
  {
    layer.youngsModulus /= unit;
    layer.poissonsRatio = std::min(layer.poissonsRatio, LargestRatio);
  };
  std::for_each(stack.layers.begin(), stack.layers.end(), held);
  held(stack.halfSpace);
  return stack;
}

/// Additional error of c for layers whose Poisson's ratio is not solved for.
double ratioError(const LayerStack& stack)
{
  const auto isBeyond = [](const StackLayer& layer) { return layer.poissonsRatio > LargestRatio; };
  return std::any_of(stack.layers.begin(), stack.layers.end(), isBeyond) ||
      (stack.hasHalfSpace && isBeyond(stack.halfSpace))
    ? BeyondLargestRatio
    : 0.0;
}

std::string checkBonds(const LayerStack& stack)
{
  for (std::size_t i = 1; i < stack.layers.size(); ++i)
  {
    if (stack.layers[i].slips)
    {
      return joined("Layer ", i,
        " slips below the one above it: StrainModel has a law for layers bonded to each other; use "
        "SmallStrain, whose ErrorTolerance says how far off that is");
    }
  }
  return stack.hasHalfSpace && stack.halfSpace.slips
    ? "The layers slip on their half-space: StrainModel has a law for bonded ones; use "
      "SmallStrain, "
      "whose ErrorTolerance says how far off that is"
    : "";
}

/// Additional error of c for a corner, which is solved for with a fillet.
double cornerError(const AxisymmetricTool& tool, double deepest)
{
  const double radius = tool.contactRadius(deepest);
  return solvedOutline(tool, radius, SolvedFillet * radius).fillets().empty() ? 0.0 : CornerError;
}

std::unique_ptr<StrainTable> solvedTable(const StrainProblem& problem,
  const StrainTable::Axes& axes, double error, const std::function<bool(double)>& goOn)
{
  std::vector<double> factors = solveStrain(problem, axes, goOn);
  return factors.empty() ? nullptr
                         : std::make_unique<StrainTable>(
                             axes, std::move(factors), problem.reach, false, SolvedError + error);
}
} // namespace

StrainCorrection::Course StrainCorrection::course(
  double poissonsRatio, double thickness, double second) const
{
  Course course;
  if (const StrainTable* table = thickness > 0.0 ? this->Layers.get() : this->HalfSpace.get())
  {
    course.Table = table->course(std::min(poissonsRatio, LargestRatio), thickness, second);
    course.HasTable = true;
    course.More = poissonsRatio > LargestRatio ? BeyondLargestRatio : 0.0;
  }
  return course;
}

StrainCorrection::Value StrainCorrection::Course::at(double depth) const
{
  if (!this->HasTable)
  {
    return {};
  }
  Value found = this->Table.at(depth);
  found.error += this->More;
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
  fault = fault.empty() ? checkBonds(bodies.stack) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  const bool hasLayers = bodies.thickest > 0.0;
  const bool isStack = !bodies.stack.layers.empty();
  auto correction = std::make_unique<StrainCorrection>();
  const auto half = [&](double from, double width)
  {
    return [&goOn, from, width](double fraction) { return !goOn || goOn(from + width * fraction); };
  };
  const double forHalfSpace = bodies.hasHalfSpace && hasLayers ? 0.5 : 1.0;
  const double forLayers = bodies.hasHalfSpace ? 0.5 : 1.0;
  if (bodies.hasHalfSpace)
  {
    std::unique_ptr<StrainTable> table =
      law.model == StrainModel::NeoHooke ? neoHookeOnHalfSpace(tool, deepest) : nullptr;
    if (!table)
    {
      table = solvedTable({ tool, law, {}, { deepest } }, { ratioNodes(bodies), {}, SolvedRoots },
        cornerError(tool, deepest), half(0.0, forHalfSpace));
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
      law.model == StrainModel::NeoHooke ? layersTable(tool, bodies, deepest) : nullptr;
    if (!table)
    {
      StrainTable::Axes axes{ isStack
          ? std::vector<double>{ std::min(bodies.leastRatio, LargestRatio) }
          : ratioNodes(bodies),
        thicknessNodes(bodies.thinnest, bodies.thickest), SolvedRoots };
      if (bodies.stack.layers.size() > 1)
      {
        axes.seconds = thicknessNodes(bodies.second.thinnest, bodies.second.thickest);
      }
      const double error = cornerError(tool, deepest) +
        (bodies.leastRatio > LargestRatio ? 0.0 : ratioError(bodies.stack));
      table = solvedTable({ tool, law, solvedStack(bodies), reachOf(deepest, bodies) }, axes, error,
        half(1.0 - forLayers, forLayers));
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

bool isStrainTabulated(const AxisymmetricTool& tool, const StrainBodies& bodies, double deepest)
{
  const bool hasLayers = bodies.thickest > 0.0;
  return (!bodies.hasHalfSpace || neoHookeOnHalfSpace(tool, deepest)) &&
    (!hasLayers || layersTable(tool, bodies, deepest));
}
} // namespace palpate
