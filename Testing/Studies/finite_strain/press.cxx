// SPDX-License-Identifier: BSD-3-Clause
/*
 * Prints one curve of the finite-strain solver as CSV, the reference for other laws. make_curves.py
 * runs the cases of the studies and writes their file.
 *
 *   palpatePress TOOL THICKNESS NU MODEL PARAMETER DEEPEST COUNT EDGE FILLET
 *
 * TOOL as "sphere:1.6"; THICKNESS (mm) of a layer bonded to a rigid base, 0: a half-space; MODEL
 * linear, neohooke, ogden or demiray; DEEPEST depth (mm); COUNT depths, evenly spaced in √δ from a
 * fifth of the largest root on; EDGE length of the elements, in contact radii; FILLET (mm) of
 * corners. E* = 1 MPa. Columns: depth (mm), F/E* (mm²), radius of the contact in the deformed body
 * (mm), least J, iterations of Newton's method. The curve ends at the depth without an equilibrium,
 * with a message on the standard error.
 */
#include "Strain/FiniteIndentation.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

using namespace palpate;

namespace
{
bool modelOf(const std::string& name, StrainModel& model)
{
  model = name == "linear" ? StrainModel::Linear
    : name == "neohooke"   ? StrainModel::NeoHooke
    : name == "ogden"      ? StrainModel::Ogden
                           : StrainModel::Demiray;
  return model != StrainModel::Demiray || name == "demiray";
}
} // namespace

int main(int count, char** arguments)
{
  ToolSpecification specification;
  std::string fault = "palpatePress TOOL THICKNESS NU MODEL PARAMETER DEEPEST COUNT EDGE FILLET";
  FiniteLayer layer;
  if (count != 10 || !parseTool(arguments[1], specification, fault) ||
    !modelOf(arguments[4], layer.model))
  {
    std::fprintf(stderr, "%s\n", fault.c_str());
    return 1;
  }
  const auto number = [&](int i) { return std::strtod(arguments[i], nullptr); };
  const auto tool = makeTool(specification);
  const double thickness = number(2);
  const double deepest = number(6);
  layer.poissonRatio = number(3);
  layer.youngsModulus = 1.0 - layer.poissonRatio * layer.poissonRatio;
  layer.parameter = number(5);
  FiniteProblem problem;
  problem.contactRadius = tool->contactRadius(deepest);
  if (thickness > 0.0)
  {
    layer.thickness = thickness;
    const LayerContact contact(
      *tool, std::make_shared<LayerKernel>(layer.poissonRatio, LayerBase::Bonded), thickness);
    problem.contactRadius = contact.contactRadius(deepest);
  }
  problem.layers = { layer };
  problem.edge = number(8);
  const int depths = std::atoi(arguments[7]);
  for (int i = 0; i < depths; ++i)
  {
    const double root = depths == 1 ? 1.0 : 0.2 + 0.8 * i / (depths - 1);
    problem.depths.push_back(deepest * root * root);
  }
  const double reach = 3.0 * problem.contactRadius;
  const FiniteCurve curve = pressTool(ToolOutline(*tool, reach, number(9)), problem);
  for (const FinitePoint& point : curve.points)
  {
    std::printf("%.8g,%.8g,%.6g,%.4f,%d\n", point.depth, point.force, point.contactRadius,
      point.leastVolume, point.iterations);
  }
  if (!curve.fault.empty())
  {
    std::fprintf(stderr, "%s\n", curve.fault.c_str());
  }
  return curve.points.empty() ? 1 : 0;
}
