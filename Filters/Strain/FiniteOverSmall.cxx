// SPDX-License-Identifier: BSD-3-Clause
#include "Strain/FiniteOverSmall.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace palpate
{
namespace
{
// Fraction of the computing time for the solution at small strain.
constexpr double SmallStrainTime = 0.3;
constexpr double OutlineReach = 3.0; // radius up to which the outline is exact, in contact radii
/// A step of the continuation with a rounder rim: the factor on the fillet radius, and the factor
/// on the length of the elements.
struct Round
{
  double fillet;
  double edge;
};
constexpr Round Rounds[] = { { 1.0, 1.0 }, { 1.5, 1.0 }, { 2.0, 2.0 }, { 3.0, 2.0 }, { 3.0, 4.0 } };
/// Largest depth, in fillet radii, at which the result with a fillet is used. At larger depths the
/// surface creases next to the rim, and c is up to 1.5 % too low.
constexpr double TrustedDepth = 6.5;
// Fraction of the remaining computing time that is reserved for rounder rims.
constexpr double ReservedTime = 0.3;

/// Returns c for one fillet, up to the largest depth with an equilibrium.
std::vector<double> factorsWith(
  const ToolOutline& outline, FiniteProblem problem, const std::function<bool(double)>& goOn)
{
  const auto forces = [&](double from, double width)
  {
    return pressTool(
      outline, problem, [&](double fraction) { return goOn(from + width * fraction); });
  };
  const FiniteCurve finite = forces(SmallStrainTime, 1.0 - SmallStrainTime);
  problem.depths.resize(finite.points.size());
  for (FiniteLayer& layer : problem.layers)
  {
    layer.model = StrainModel::Linear;
  }
  const FiniteCurve small = forces(0.0, SmallStrainTime);
  std::vector<double> factors;
  for (std::size_t k = 0; k < small.points.size(); ++k)
  {
    // The fillet of an apex is not in contact at small depths.
    const double force = small.points[k].force;
    factors.push_back(force > 0.0 ? finite.points[k].force / force : 0.0);
  }
  return factors;
}
} // namespace

ToolOutline solvedOutline(const AxisymmetricTool& tool, double contactRadius, double fillet)
{
  return { tool, OutlineReach * contactRadius, fillet };
}

std::vector<double> finiteOverSmall(const AxisymmetricTool& tool, const FiniteProblem& problem,
  double fillet, const std::function<bool(double)>& goOn)
{
  std::vector<double> factors;
  double from = 0.0;
  bool isEnded = false;
  const bool hasRim = tool.smallestContactRadius() > 0.0;
  for (const Round& round : Rounds)
  {
    const double roundness = round.fillet * fillet;
    const ToolOutline outline = solvedOutline(tool, problem.contactRadius, roundness);
    // The last known depth is solved again, to compare the results of the sharper and the rounder
    // rim. The first depth is solved before it, because this was also done with the sharper rim.
    const std::size_t again = std::min<std::size_t>(factors.size(), 2);
    FiniteProblem rest = problem;
    rest.edge = std::min(round.edge * problem.edge, FiniteProblem::LongestEdge);
    rest.depths.erase(rest.depths.begin(),
      rest.depths.begin() + static_cast<std::ptrdiff_t>(factors.size() - again));
    if (again > 1)
    {
      rest.depths.front() = problem.depths.front();
    }
    if (hasRim && &round != std::end(Rounds) - 1)
    {
      rest.depths.erase(
        std::upper_bound(rest.depths.begin(), rest.depths.end(), TrustedDepth * roundness),
        rest.depths.end());
    }
    if (rest.depths.size() <= again)
    {
      continue;
    }
    const double width = (1.0 - from) * (1.0 - ReservedTime);
    const std::vector<double> found = factorsWith(outline, rest,
      [&](double fraction)
      {
        isEnded = isEnded || (goOn && !goOn(from + width * fraction));
        return !isEnded;
      });
    from += width;
    const bool isCompared = again > 0 && found.size() >= again && found[again - 1] > 0.0;
    const double ratio = isCompared ? factors.back() / found[again - 1] : 1.0;
    for (std::size_t k = again; k < found.size(); ++k)
    {
      factors.push_back(ratio * found[k]);
    }
    if (isEnded || factors.size() == problem.depths.size() || outline.fillets().empty())
    {
      break;
    }
  }
  factors.resize(problem.depths.size(), 0.0);
  return factors;
}
} // namespace palpate
