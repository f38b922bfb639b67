// SPDX-License-Identifier: BSD-3-Clause
/*
 * Computes the tables of Mechanics/FiniteStrain/NeoHookeTables.inc with the finite-strain solver:
 * the ratio of the force at finite strain (Neo-Hooke) to that at small strain, on one mesh, at the
 * same depth.
 *
 *   finite_strain_tables sphere|flat|cone45|cone60|cone75|layer0.5|…|spherelayer2|…|flatlayer2|…
 *
 * prints one table: the tool on a half-space; a sphere on a layer of that thickness, to half of it;
 * a sphere and a flat on a layer to the depth of thickLayerReach.
 *
 * Lengths in radii (cone: in depths, which have no effect). A row is a Poisson's ratio; a column is
 * the square root of the depth over the deepest, 0.3 to 1. 0 if the solver did not converge to that
 * depth. Cost: about 15 minutes for a table on a half-space, one minute for a layer.
 */
#include "Strain/FiniteOverSmall.h"
#include "Mechanics/FiniteStrain/NeoHookeTables.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

using namespace palpate;

namespace
{
constexpr double Roots[] = { 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0 };
constexpr std::size_t Columns = std::size(Roots);
constexpr double LargestBend = 0.025; // largest second difference of c between columns
constexpr double Ratios[] = { 0.0, 0.15, 0.3, 0.4, 0.45, 0.48, 0.495 };

struct Case
{
  std::string tool;
  double deepest;
  double fillet;    ///< mm
  double thickness; ///< mm; 0: a half-space
};

Case caseOf(const std::string& name)
{
  if (name == "flat")
  {
    return { "flat:1", 1.3, 0.1, 0.0 };
  }
  if (name.rfind("cone", 0) == 0)
  {
    return { "cone:" + name.substr(4), 0.15, 0.05, 0.0 };
  }
  const auto at = name.find("layer");
  const double thickness =
    at == std::string::npos ? 0.0 : std::strtod(name.c_str() + at + 5, nullptr);
  if (at != std::string::npos && at > 0) // spherelayer…, flatlayer…
  {
    const ToolShape shape = name[0] == 'f' ? ToolShape::Flat : ToolShape::Sphere;
    return { name.substr(0, at) + ":1", thickLayerReach(shape, 1.0).at(thickness, 0.0), 0.1,
      thickness };
  }
  return { "sphere:1", thickness > 0.0 ? 0.5 * thickness : 1.0, 0.1, thickness };
}

std::vector<double> factorsOf(const Case& given, const AxisymmetricTool& tool, double ratio)
{
  FiniteProblem problem;
  FiniteLayer layer;
  layer.poissonRatio = ratio;
  layer.youngsModulus = 1.0 - ratio * ratio;
  if (given.thickness > 0.0)
  {
    layer.thickness = given.thickness;
  }
  problem.layers = { layer };
  problem.contactRadius = tool.contactRadius(given.deepest);
  // Solves twice as many depths as are printed, so that the rims at a corner are joined near their
  // ends.
  const auto depthOf = [&](double root) { return given.deepest * root * root; };
  for (std::size_t k = 0; k < Columns; ++k)
  {
    if (k > 0)
    {
      problem.depths.push_back(depthOf(0.5 * (Roots[k - 1] + Roots[k])));
    }
    problem.depths.push_back(depthOf(Roots[k]));
  }
  const auto columnsWith = [&](double fillet)
  {
    const std::vector<double> all = finiteOverSmall(tool, problem, fillet, {});
    std::vector<double> factors;
    bool isKnown = true;
    for (std::size_t k = 0; k < Columns; ++k)
    {
      const double c = all[2 * k];
      // A jump of c means an equilibrium on another branch than that of the row. This occurs for a
      // deep flat on a thin layer.
      isKnown = isKnown && c > 0.0 &&
        (k < 2 || std::abs(c - 2.0 * factors[k - 1] + factors[k - 2]) < LargestBend);
      factors.push_back(isKnown ? c : 0.0);
    }
    return factors;
  };
  std::vector<double> factors = columnsWith(given.fillet);
  const auto end = std::find(factors.begin(), factors.end(), 0.0);
  if (end != factors.begin() && end != factors.end())
  {
    // Beyond the last solved column: values of a rounder rim, scaled to match at that column.
    const std::vector<double> rounder = columnsWith(2.0 * given.fillet);
    const auto last = static_cast<std::size_t>(end - factors.begin()) - 1;
    const double ratio = rounder[last] > 0.0 ? factors[last] / rounder[last] : 0.0;
    std::transform(rounder.begin() + static_cast<std::ptrdiff_t>(last) + 1, rounder.end(), end,
      [ratio](double c) { return ratio * c; });
  }
  return factors;
}
} // namespace

int main(int count, char** arguments)
{
  const Case given = caseOf(count > 1 ? arguments[1] : "sphere");
  ToolSpecification specification;
  std::string fault;
  if (!parseTool(given.tool, specification, fault))
  {
    std::fprintf(stderr, "%s\n", fault.c_str());
    return 1;
  }
  const auto tool = makeTool(specification);
  for (const double ratio : Ratios)
  {
    const std::vector<double> factors = factorsOf(given, *tool, ratio);
    std::printf("  {");
    for (std::size_t i = 0; i < factors.size(); ++i)
    {
      std::printf(" %.5f%s", factors[i], i + 1 < factors.size() ? "," : " ");
    }
    std::printf("}, // %g\n", ratio);
    std::fflush(stdout);
  }
  return 0;
}
