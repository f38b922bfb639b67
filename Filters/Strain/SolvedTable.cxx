// SPDX-License-Identifier: BSD-3-Clause
#include "Strain/SolvedTable.h"

#include "Mechanics/Numerics/Constants.h"
#include "Strain/FiniteOverSmall.h"
#include "Strain/StrainSolution.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
// c is linear in √δ near 0. Smaller roots are omitted, because the mesh cannot resolve contacts
// that are only a few elements wide.
const std::vector<double> SolvedRoots = { 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0 };
constexpr int RatioNodes = 4;         // number of Poisson's ratios; one if there is a single value
constexpr double ThicknessStep = 2.0; // largest ratio of neighbouring thicknesses
// Largest depth as a fraction of the thickness of the layers on a rigid base.
constexpr double DeepestFraction = 0.7;
// Error of c due to the mesh, the far field and the interpolation.
constexpr double SolvedError = 0.003;
// Error of c due to the fillet: the difference from the result with a fillet of half the size.
constexpr double CornerError = 0.01;

std::vector<double> ratioNodes(const StrainBodies& bodies)
{
  const double first = std::min(bodies.leastRatio, LargestSolvedRatio);
  const double last = std::min(bodies.mostRatio, LargestSolvedRatio);
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

/// Returns the largest depth as a function of the thickness. It is `deepest` for the thickest
/// layers, and at most a fraction of the total thickness.
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

/// Returns the layers for the solver. The modulus of the top layer is 1 MPa, because c is
/// dimensionless.
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
    layer.poissonRatio = std::min(layer.poissonRatio, LargestSolvedRatio);
  };
  std::for_each(stack.layers.begin(), stack.layers.end(), held);
  held(stack.halfSpace);
  return stack;
}

/// Returns the additional error of c for layers whose Poisson's ratio is above the largest solved
/// ratio.
double ratioError(const LayerStack& stack)
{
  const auto isBeyond = [](const StackLayer& layer)
  { return layer.poissonRatio > LargestSolvedRatio; };
  return std::any_of(stack.layers.begin(), stack.layers.end(), isBeyond) ||
      (stack.hasHalfSpace && isBeyond(stack.halfSpace))
    ? BeyondSolvedRatio
    : 0.0;
}

/// Returns the additional error of c for a tool with a corner, which is solved with a fillet.
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

std::unique_ptr<StrainTable> solveOnHalfSpace(
  const SolvedStrain& asked, const std::function<bool(double)>& goOn)
{
  return solvedTable({ asked.tool, asked.law, {}, { asked.deepest }, asked.threads },
    { ratioNodes(asked.bodies), {}, SolvedRoots }, cornerError(asked.tool, asked.deepest), goOn);
}

std::unique_ptr<StrainTable> solveOnLayers(
  const SolvedStrain& asked, const std::function<bool(double)>& goOn)
{
  const StrainBodies& bodies = asked.bodies;
  StrainTable::Axes axes{ bodies.stack.layers.empty()
      ? ratioNodes(bodies)
      : std::vector<double>{ std::min(bodies.leastRatio, LargestSolvedRatio) },
    thicknessNodes(bodies.thinnest, bodies.thickest), SolvedRoots };
  if (bodies.stack.layers.size() > 1)
  {
    axes.seconds = thicknessNodes(bodies.second.thinnest, bodies.second.thickest);
  }
  const double error = cornerError(asked.tool, asked.deepest) +
    (bodies.leastRatio > LargestSolvedRatio ? 0.0 : ratioError(bodies.stack));
  return solvedTable(
    { asked.tool, asked.law, solvedStack(bodies), reachOf(asked.deepest, bodies), asked.threads },
    axes, error, goOn);
}
} // namespace palpate
