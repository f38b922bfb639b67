// SPDX-License-Identifier: BSD-3-Clause
#include "Strain/StrainSolution.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/Files/SolutionCache.h"
#include "Strain/FiniteIndentation.h"
#include "Strain/FiniteOverSmall.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace palpate
{
namespace
{
constexpr auto CallInterval = std::chrono::milliseconds(100); // interval between calls of goOn

/// The body that belongs to one row of a table.
struct StrainRow
{
  LayerStack stack; ///< it has no layers for a half-space
  double ratio;     ///< Poisson's ratio of the half-space or of a single layer
  double deepest;   ///< mm
};

StrainRow rowOf(const StrainProblem& problem, const StrainTable::Axes& axes, std::size_t index)
{
  const std::size_t lowers = std::max<std::size_t>(1, axes.seconds.size());
  const std::size_t heights = std::max<std::size_t>(1, axes.thicknesses.size());
  const double thickness =
    axes.thicknesses.empty() ? 0.0 : axes.thicknesses[index / lowers % heights];
  const double second = axes.seconds.empty() ? 0.0 : axes.seconds[index % lowers];
  StrainRow row{ problem.stack, axes.ratios[index / (lowers * heights)],
    problem.reach.at(thickness, second) };
  std::vector<StackLayer>& layers = row.stack.layers;
  if (!layers.empty())
  {
    layers[0].thickness = thickness;
    layers[0].poissonRatio = row.ratio;
  }
  if (layers.size() > 1)
  {
    layers[1].thickness = second;
  }
  return row;
}

/// Returns the largest contact radius at small strain, mm.
double contactRadiusOf(const AxisymmetricTool& tool, const StrainRow& row)
{
  const double flat = tool.contactRadius(row.deepest);
  if (row.stack.layers.empty())
  {
    return flat;
  }
  const LayerContact contact(
    tool, std::make_shared<const LayerKernel>(row.stack), row.stack.layers.front().thickness);
  const double found = contact.contactRadius(row.deepest);
  return found > 0.0 && std::isfinite(found) ? found : flat; // the layer may be too thin for a law
}

std::vector<FiniteLayer> finiteLayers(const StrainRow& row, const StrainLaw& law)
{
  std::vector<FiniteLayer> layers;
  const auto add = [&](const StackLayer& from, bool isEndless)
  {
    FiniteLayer layer;
    layer.thickness = isEndless ? layer.thickness : from.thickness;
    layer.youngsModulus = from.youngsModulus;
    layer.poissonRatio = from.poissonRatio;
    layer.model = law.model;
    layer.parameter = law.parameter;
    layers.push_back(layer);
  };
  for (const StackLayer& layer : row.stack.layers)
  {
    add(layer, false);
  }
  if (row.stack.layers.empty())
  {
    add({ 0.0, 1.0, row.ratio }, true);
  }
  else if (row.stack.hasHalfSpace)
  {
    add(row.stack.halfSpace, true);
  }
  return layers;
}

/// Returns c at the roots up to the last equilibrium, and 0 at the other roots.
std::vector<double> factorsOf(const StrainProblem& problem, const StrainRow& row,
  const std::vector<double>& roots, const std::function<bool(double)>& goOn)
{
  FiniteProblem finite;
  finite.slipBase = !row.stack.layers.empty() && row.stack.base == LayerBase::Slip;
  finite.contactRadius = contactRadiusOf(problem.tool, row);
  for (const double root : roots)
  {
    finite.depths.push_back(row.deepest * root * root);
  }
  finite.layers = finiteLayers(row, problem.law);
  return finiteOverSmall(problem.tool, finite, SolvedFillet * finite.contactRadius, goOn);
}

std::string keyOf(const StrainProblem& problem, const StrainTable::Axes& axes)
{
  std::string key = joined("finite strain 4|", problem.tool.specification(), "|",
    describe(problem.law), "|", static_cast<int>(problem.stack.base));
  const auto add = [&key](std::initializer_list<double> values)
  {
    for (const double value : values)
    {
      key += "," + shortestDecimals(value);
    }
  };
  add({ problem.reach.endless, problem.reach.fraction, problem.reach.below });
  for (const StackLayer& layer : problem.stack.layers)
  {
    key += "|";
    add({ layer.thickness, layer.youngsModulus, layer.poissonRatio });
  }
  if (problem.stack.hasHalfSpace)
  {
    key += "|on";
    add({ problem.stack.halfSpace.youngsModulus, problem.stack.halfSpace.poissonRatio });
  }
  for (const std::vector<double>* axis :
    { &axes.ratios, &axes.thicknesses, &axes.seconds, &axes.roots })
  {
    key += "|";
    for (const double value : *axis)
    {
      add({ value });
    }
  }
  return key;
}

/// Solves all rows. Returns false if `goOn` has stopped the solution.
bool solveRows(std::size_t rows,
  const std::function<void(std::size_t, const std::function<bool(double)>&)>& solve,
  std::size_t threadsAtMost, const std::function<bool(double)>& goOn)
{
  std::vector<std::atomic<double>> done(rows);
  std::atomic<std::size_t> next{ 0 };
  std::atomic<bool> ended{ false };
  std::mutex mutex;
  std::condition_variable left;
  const std::size_t count = std::min(threadsAtMost, rows);
  std::size_t working = count;
  const auto work = [&]
  {
    for (std::size_t i = next++; i < rows && !ended; i = next++)
    {
      solve(i,
        [&done, &ended, i](double fraction)
        {
          done[i] = fraction;
          return !ended;
        });
      done[i] = 1.0;
    }
    const std::lock_guard<std::mutex> lock(mutex);
    --working;
    left.notify_one();
  };
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < count; ++k)
  {
    threads.emplace_back(work);
  }
  std::unique_lock<std::mutex> lock(mutex);
  while (working > 0)
  {
    left.wait_for(lock, CallInterval);
    double sum = 0.0;
    for (const std::atomic<double>& each : done)
    {
      sum += each;
    }
    lock.unlock();
    ended = ended || (goOn && !goOn(sum / static_cast<double>(rows)));
    lock.lock();
  }
  lock.unlock();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  return !ended;
}
} // namespace

std::vector<double> solveStrain(const StrainProblem& problem, const StrainTable::Axes& axes,
  const std::function<bool(double)>& goOn)
{
  const std::string key = keyOf(problem, axes);
  const std::size_t columns = axes.roots.size();
  const std::size_t rows = axes.ratios.size() * std::max<std::size_t>(1, axes.thicknesses.size()) *
    std::max<std::size_t>(1, axes.seconds.size());
  std::vector<double> factors = readSolution("strain", key, rows * columns);
  const bool isPositive =
    std::all_of(factors.begin(), factors.end(), [](double c) { return c >= 0.0; });
  if (!factors.empty() && isPositive)
  {
    return factors;
  }
  factors.resize(rows * columns);
  const bool complete = solveRows(
    rows,
    [&](std::size_t i, const std::function<bool(double)>& tell)
    {
      const std::vector<double> own = factorsOf(problem, rowOf(problem, axes, i), axes.roots, tell);
      std::copy(own.begin(), own.end(), factors.begin() + static_cast<std::ptrdiff_t>(i * columns));
    },
    problem.threads, goOn);
  if (!complete)
  {
    return {};
  }
  writeSolution("strain", key, factors);
  return factors;
}
} // namespace palpate
