// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/StrainCorrection.h"

#include "Mechanics/Checked.h"
#include "Mechanics/FiniteStrain/NeoHookeTables.h"
#include "Mechanics/FiniteStrain/StrainModule.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/ThreadCount.h"

#include <algorithm>

namespace palpate
{
namespace
{
/// Returns the Neo-Hooke table for layers; null if the layers are outside its range.
std::unique_ptr<StrainTable> layersTable(
  const AxisymmetricTool& tool, const StrainBodies& bodies, double deepest)
{
  return bodies.base == LayerBase::Bonded && bodies.stack.layers.empty()
    ? neoHookeOnLayers(tool, bodies.thinnest, bodies.thickest, deepest)
    : nullptr;
}

std::string checkBonds(const LayerStack& stack)
{
  for (std::size_t i = 1; i < stack.layers.size(); ++i)
  {
    if (stack.layers[i].slips)
    {
      return joined("Layer ", i,
        " slips below the layer above it, but Strain Model has a law only for layers that are "
        "bonded to each other: use Small Strain, whose error is estimated with an Error Tolerance");
    }
  }
  return stack.hasHalfSpace && stack.halfSpace.slips
    ? "The layers slip on their half-space, but Strain Model has a law only for layers that are "
      "bonded to it: use Small Strain, whose error is estimated with an Error Tolerance"
    : "";
}

/// Computes a table with the solver. Returns a fault if the module of the solver is missing.
std::string solve(StrainModule::Solver StrainModule::*where, const SolvedStrain& asked,
  const std::function<bool(double)>& goOn, std::unique_ptr<StrainTable>& table)
{
  static const LoadedModule loaded = loadModule("palpateStrain");
  if (!loaded.table)
  {
    return joined("No stored table holds ", describe(asked.law), " of ", asked.tool.specification(),
      " on this body. The solution needs ", missingModule("Strain", loaded.fault));
  }
  table = (static_cast<const StrainModule*>(loaded.table)->*where)(asked, goOn);
  return {};
}
} // namespace

StrainCorrection::Course StrainCorrection::course(
  double poissonRatio, double thickness, double second) const
{
  Course course;
  if (const StrainTable* table = thickness > 0.0 ? this->Layers.get() : this->HalfSpace.get())
  {
    course.Table = table->course(std::min(poissonRatio, LargestSolvedRatio), thickness, second);
    course.HasTable = true;
    course.More = poissonRatio > LargestSolvedRatio ? BeyondSolvedRatio : 0.0;
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
  std::string fault = firstFault([&] { return checkStrainEnergy(law.model, law.parameter); },
    [&] { return checkBonds(bodies.stack); });
  if (!fault.empty())
  {
    return fault;
  }
  const bool hasLayers = bodies.thickest > 0.0;
  auto correction = std::make_unique<StrainCorrection>();
  const SolvedStrain asked{ tool, law, bodies, deepest, threadCount() };
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
      fault = solve(&StrainModule::onHalfSpace, asked, half(0.0, forHalfSpace), table);
    }
    if (!table)
    {
      return fault;
    }
    correction->setHalfSpace(std::move(table));
  }
  if (hasLayers)
  {
    std::unique_ptr<StrainTable> table =
      law.model == StrainModel::NeoHooke ? layersTable(tool, bodies, deepest) : nullptr;
    if (!table)
    {
      fault = solve(&StrainModule::onLayers, asked, half(1.0 - forLayers, forLayers), table);
    }
    if (!table)
    {
      return fault;
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
