// SPDX-License-Identifier: BSD-3-Clause
#include "RelaxationTruth.h"

#include "RelaxationMethods.h"
#include "RelaxationPaths.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace palpate::testing
{
namespace
{
/// Forces at all ticks of a path.
std::vector<double> forcesAlong(const RelaxationPath& path, ContactMethod& method)
{
  method.forget();
  method.force(relaxationTip(-0.1));
  std::vector<double> forces;
  for (const double depth : path.depths)
  {
    forces.push_back(method.force(relaxationTip(depth)).z());
  }
  return forces;
}

/// One entry per branch: "0.5:0.02 0.8:0.2".
std::string materialOf(const PronySeries& series)
{
  std::string text = textOf(series);
  std::replace(text.begin(), text.end(), ',', ' ');
  return text;
}

void writeErrors(std::ostream& stream, const RelaxationPath& path)
{
  for (const auto& method : relaxationMethods(path.exponent, path.series))
  {
    const std::vector<double> forces = forcesAlong(path, *method);
    double worst = 0.0;
    for (std::size_t i = 0; i < path.ticks.size(); ++i)
    {
      worst = std::max(worst, std::abs(forces[path.ticks[i]] - path.forces[i]));
    }
    stream << "force,\"" << path.name << "\",\"" << path.source << "\","
           << toolOfExponent(path.exponent) << ',' << materialOf(path.series) << ",\""
           << method->name() << "\",,,," << path.largest << ',' << worst / path.largest << ",,,\n";
  }
}

void writeCurves(std::ostream& stream, const RelaxationPath& path)
{
  for (const auto& method : relaxationMethods(path.exponent, path.series))
  {
    const std::vector<double> forces = forcesAlong(path, *method);
    for (std::size_t i = 0; i < path.ticks.size(); i += 2)
    {
      stream << "curve,\"" << path.name << "\",," << toolOfExponent(path.exponent) << ",,\""
             << method->name() << "\"," << static_cast<double>(path.ticks[i] + 1) * RelaxationPeriod
             << ',' << forces[path.ticks[i]] << ',' << path.forces[i] << ",,,,,\n";
    }
  }
}

void writeTimes(std::ostream& stream, const RelaxationPath& path, MethodTimer& timer)
{
  MethodList methods;
  for (auto& method : relaxationMethods(path.exponent, path.series))
  {
    methods.push_back({ std::move(method), 1, 0 });
  }
  StudyTips tips;
  for (const double depth : path.depths)
  {
    tips.path.push_back({ relaxationTip(depth), false });
  }
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i)
  {
    Vector3 tip = relaxationTip((random() % 950U + 50.5) / 1000.0);
    tip.head<2>() += Eigen::Vector2d(random() % 80U - 40.0, random() % 80U - 40.0) * 0.1;
    tips.sites.push_back({ tip, true });
  }
  const std::vector<MethodTimes> times = timer.run(methods, tips);
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    stream << "time,\"" << path.name << "\",," << toolOfExponent(path.exponent) << ','
           << materialOf(path.series) << ",\"" << methods[m].method->name() << "\",,,,,,"
           << times[m].hot << ',' << times[m].onset << ',' << times[m].cold << '\n';
  }
}
} // namespace

void studyRelaxation(std::ostream& stream, const std::string& folder, MethodTimer* timer)
{
  stream << "part,path,source,tool,material,method,time_s,force_N,true_force_N,largest_force_N,"
            "error,hot_ns,onset_ns,cold_ns\n";
  for (const RelaxationPath& path : relaxationPaths(folder))
  {
    writeErrors(stream, path);
    // A press that returns to a dent, on the material with the strongest memory.
    if (path.name == "two triangles" && path.exponent == 1.5 && path.series.total() == 4.0)
    {
      writeCurves(stream, path);
    }
  }
  if (timer != nullptr)
  {
    writeTimes(stream, stopAndGo(folder, 1.5), *timer);
  }
}
} // namespace palpate::testing
