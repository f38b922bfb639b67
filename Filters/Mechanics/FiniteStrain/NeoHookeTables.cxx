// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/NeoHookeTables.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::size_t Ratios = 7;
constexpr std::size_t Roots = 8;
using HalfSpaceTable = double[Ratios][Roots];

// The tables are written by Testing/Studies/finite_strain/tables.cxx.
#include "Mechanics/FiniteStrain/NeoHookeTables.inc"

constexpr double SphereDeepest = 1.0; // largest depth, in sphere radii
constexpr double FlatDeepest = 1.3;   // largest depth, in radii of the flat end
constexpr double LayerDeepest = 0.5;  // largest depth, in layer thicknesses
// Largest depth relative to the thinnest layer. Beyond the end of the table c is extrapolated
// (StrainTable.h) and its error increases.
constexpr double LayerLimit = 0.7;
// A table is used up to this multiple of its largest depth, with an increasing error.
constexpr double HalfSpaceExtension = 1.8;
constexpr double LayerExtension = 2.25;
constexpr double TableError = 0.003; // error due to the mesh, the far field and the interpolation
// Error for a flat end with a sharp rim. The rim is rounded in the table.
constexpr double FlatError = 0.015;
// Difference from the result of another program, for a sharp rim on a layer.
constexpr double FlatLayerError = 0.022;
constexpr double ConeError = 0.005;

std::vector<double> ratios()
{
  return { std::begin(TableRatios), std::end(TableRatios) };
}

std::vector<double> roots()
{
  return { std::begin(TableRoots), std::end(TableRoots) };
}

std::vector<double> flattened(const HalfSpaceTable& table)
{
  std::vector<double> values;
  for (const auto& row : table)
  {
    values.insert(values.end(), std::begin(row), std::end(row));
  }
  return values;
}

/// Creates the table for layers with the thicknesses `heights`, in tool radii.
template <std::size_t Heights>
std::unique_ptr<StrainTable> layerTable(const double (&heights)[Heights],
  const HalfSpaceTable (&tables)[Heights], double radius, const StrainReach& reach, double error)
{
  std::vector<double> thicknesses;
  for (const double height : heights)
  {
    thicknesses.push_back(height * radius);
  }
  std::vector<double> factors;
  for (std::size_t i = 0; i < Ratios; ++i)
  {
    for (const HalfSpaceTable& table : tables)
    {
      factors.insert(factors.end(), std::begin(table[i]), std::end(table[i]));
    }
  }
  return std::make_unique<StrainTable>(
    StrainTable::Axes{ ratios(), thicknesses, roots() }, std::move(factors), reach, false, error);
}

bool isTool(const AxisymmetricTool& tool, ToolShape shape, ToolSpecification& found)
{
  std::string fault;
  return parseTool(tool.specification(), found, fault) && found.Shape == shape;
}

/// Interpolates linearly over cot α between the half angles α of the table, because the pressure is
/// proportional to cot α.
std::vector<double> coneFactors(double halfAngle)
{
  const auto slope = [](double degrees)
  { return 1.0 / std::tan(degrees * 3.14159265358979 / 180.0); };
  const std::array<double, 3> angles = { 75.0, 60.0, 45.0 };
  const std::array<const HalfSpaceTable*, 3> tables = { &Cone75, &Cone60, &Cone45 };
  std::size_t above = halfAngle >= angles[1] ? 1 : 2;
  const double from = slope(angles[above - 1]);
  const double fraction = (slope(halfAngle) - from) / (slope(angles[above]) - from);
  const auto last = [](const double(&row)[Roots])
  {
    std::size_t known = Roots;
    while (known > 1 && row[known - 1] == 0.0)
    {
      --known;
    }
    return row[known - 1];
  };
  std::vector<double> factors;
  for (std::size_t i = 0; i < Ratios; ++i)
  {
    const double one = last((*tables[above - 1])[i]);
    const double other = last((*tables[above])[i]);
    factors.insert(factors.end(), Roots, one + fraction * (other - one));
  }
  return factors;
}
} // namespace

std::unique_ptr<StrainTable> neoHookeOnHalfSpace(const AxisymmetricTool& tool, double deepest)
{
  ToolSpecification found;
  const StrainTable::Axes axes{ ratios(), {}, roots() };
  if (isTool(tool, ToolShape::Sphere, found) &&
    deepest <= HalfSpaceExtension * SphereDeepest * found.Radius)
  {
    return std::make_unique<StrainTable>(
      axes, flattened(Sphere), StrainReach{ SphereDeepest * found.Radius }, false, TableError);
  }
  if (isTool(tool, ToolShape::Flat, found) &&
    deepest <= HalfSpaceExtension * FlatDeepest * found.Radius)
  {
    return std::make_unique<StrainTable>(
      axes, flattened(Flat), StrainReach{ FlatDeepest * found.Radius }, false, FlatError);
  }
  if (isTool(tool, ToolShape::Cone, found) && found.HalfAngle >= 45.0)
  {
    if (found.HalfAngle > 75.0)
    {
      return nullptr;
    }
    return std::make_unique<StrainTable>(
      axes, coneFactors(found.HalfAngle), StrainReach{ deepest }, true, ConeError);
  }
  return nullptr;
}

StrainReach thickLayerReach(ToolShape shape, double radius)
{
  return { (shape == ToolShape::Flat ? 1.7 : 1.3) * radius, 0.75 };
}

std::unique_ptr<StrainTable> neoHookeOnLayers(
  const AxisymmetricTool& tool, double thinnest, double thickest, double deepest)
{
  ToolSpecification found;
  const bool isSphere = isTool(tool, ToolShape::Sphere, found);
  if (!isSphere && !isTool(tool, ToolShape::Flat, found))
  {
    return nullptr;
  }
  const double radius = found.Radius;
  if (isSphere && deepest <= LayerLimit * thinnest && thinnest >= TableLayers[0] * radius &&
    thickest <= *(std::end(TableLayers) - 1) * radius)
  {
    return layerTable(
      TableLayers, Layers, radius, StrainReach{ Infinity, LayerDeepest }, TableError);
  }
  const StrainReach reach = thickLayerReach(found.Shape, radius);
  if (thinnest < ThickLayers[0] * radius || deepest > LayerExtension * reach.at(thinnest, 0.0))
  {
    return nullptr;
  }
  return isSphere ? layerTable(ThickLayers, SphereLayers, radius, reach, TableError)
                  : layerTable(ThickLayers, FlatLayers, radius, reach, FlatLayerError);
}
} // namespace palpate
