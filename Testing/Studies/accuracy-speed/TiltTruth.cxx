// SPDX-License-Identifier: BSD-3-Clause
#include "TiltTruth.h"

#include "Mechanics/Files/CsvReader.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltedContact.h"
#include "TiltMethods.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace palpate::testing
{
namespace
{
constexpr double Degree = LargestTilt / 25.0;
constexpr double Deepest = 1.0;  // mm, equal to the size of each tool
constexpr double TimedTilt = 10; // degrees
constexpr double TimedDepth = 0.8;

/// A tool and its name in the table of the other code; "" if it is not in that table.
struct Leaning
{
  const char* tool;
  const char* name;
  std::vector<double> depths; ///< depths of the presses that are solved here, mm
};
/// A cone has no length scale, so one depth is enough. A tilt has no effect on a sphere.
std::vector<Leaning> leaningTools()
{
  const std::vector<double> all{ 0.05, 0.1, 0.2, 0.5, 1.0 };
  return { { "flat:1", "flat", all }, { "truncated:1,45", "trunc45", all },
    { "cone:60", "cone60", { 1.0 } }, { "sphere:1", "", { 0.2, 1.0 } } };
}

/// One press and its exact force.
struct TiltPress
{
  const char* source;
  double tilt;  // degrees
  double depth; // depth of the deepest point, mm
  double force; // force over E*, mm²
};

void addSolved(const StudyTool& tool, const std::vector<double>& depths, bool quick,
  std::vector<TiltPress>& presses)
{
  const std::vector<double> tilts = quick
    ? std::vector<double>{ 5.0, 20.0 }
    : std::vector<double>{ 2.5, 5.0, 7.5, 10.0, 15.0, 20.0, 25.0 };
  for (const double tilt : tilts)
  {
    for (const double depth : depths)
    {
      const double force =
        solveTilted(*tool.shape, tilt * Degree, depth, quick ? 64 : 128).perModulus;
      presses.push_back({ quick ? "64 pixels" : "128 pixels", tilt, depth, force });
    }
  }
}

void addTabled(const std::string& file, const std::string& name, std::vector<TiltPress>& presses)
{
  const std::size_t before = presses.size();
  for (CsvReader csv(file); csv.next();)
  {
    if (csv.text(0) != name)
    {
      continue;
    }
    const double tilt = std::stod(std::string(csv.text(1)));
    const double depth = std::stod(std::string(csv.text(2)));
    if (tilt > 0.0 && tilt <= 25.0 && depth >= 0.05 && depth <= Deepest)
    {
      presses.push_back({ "tilt_bem.csv", tilt, depth, std::stod(std::string(csv.text(3))) });
    }
  }
  if (presses.size() == before)
  {
    throw std::runtime_error("no forces of " + name + " in " + file);
  }
}

Vector3 tipAt(const StudyTool& tool, double tilt, double depth)
{
  return { 0.13, 0.21, deepestPoint(*tool.shape, tilt * Degree).drop - depth };
}

void writeErrors(std::ostream& stream, const StudyTool& tool, const std::vector<TiltPress>& presses)
{
  for (const auto& method : tiltMethods(tool))
  {
    for (const TiltPress& press : presses)
    {
      method->lean(press.tilt * Degree);
      const double force = method->force(tipAt(tool, press.tilt, press.depth)).z();
      stream << "force,\"" << tool.name << "\",\"" << method->name() << "\"," << press.source << ','
             << press.tilt << ',' << press.depth << ',' << press.force << ',' << force << ','
             << force / press.force - 1.0 << ",,,\n";
    }
  }
  stream.flush();
}

void writeTimes(std::ostream& stream, const StudyTool& tool, MethodTimer& timer)
{
  MethodList methods;
  const auto take = [&](TiltMethodList made, std::size_t from)
  {
    for (std::size_t i = from; i < made.size(); ++i)
    {
      made[i]->lean(TimedTilt * Degree);
      methods.push_back({ std::move(made[i]), 1, 0 });
    }
  };
  take(tiltTicks(tool), 0);
  take(tiltMethods(tool), 3); // skips the first three, which are ticks
  timer.coldCalls = std::min<std::size_t>(timer.coldCalls, 5); // each flushes 96 MiB
  const std::vector<MethodTimes> times = timer.run(methods, flatTips(4.0, TimedDepth, 500, 1000));
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    stream << "time,\"" << tool.name << "\",\"" << methods[m].method->name() << "\",," << TimedTilt
           << ",,,,," << times[m].hot << ',' << times[m].onset << ',' << times[m].cold << '\n';
  }
  stream.flush();
}
} // namespace

void studyTilt(std::ostream& stream, const std::string& folder, bool quick, MethodTimer* timer)
{
  stream << "part,tool,method,source,tilt_deg,depth_mm,true_force_mm2,force_mm2,error,hot_ns,"
            "onset_ns,cold_ns\n";
  for (const Leaning& each : leaningTools())
  {
    const StudyTool tool = studyTool(each.tool, Deepest);
    const std::string name = each.name;
    if (quick && name == "trunc45")
    {
      continue;
    }
    std::vector<TiltPress> presses;
    addSolved(tool, quick ? std::vector<double>{ 0.2, 1.0 } : each.depths, quick, presses);
    if (!name.empty())
    {
      addTabled(folder + "/Reference/tilt/tilt_bem.csv", name, presses);
    }
    writeErrors(stream, tool, presses);
  }
  if (timer != nullptr)
  {
    writeTimes(stream, studyTool("flat:1", Deepest), *timer);
  }
}
} // namespace palpate::testing
