// SPDX-License-Identifier: BSD-3-Clause
// Many tools on one body: 49 responses on 140,000 points, on a half-space (0) and on a layer (1).
// Counters: `first_s` is the time of the first response on a new body, s; `each_s` is the mean time
// of the 49 responses, s; `ratio` is the first divided by the mean. Each run uses a body of another
// size, so that no cache contains it.
#include "vtkContactTool.h"
#include "vtkToolContactResponse.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <vector>

namespace
{
constexpr int Rings = 375;      // 140,000 points
constexpr int Sizes = 16;       // number of sizes of each of three shapes; one more tool is added
constexpr double Least = 0.8;   // mm
constexpr double Step = 0.45;   // mm
constexpr double Depth = 1.0;   // mm
constexpr double Radius = 60.0; // mm

std::vector<std::string> manyTools()
{
  std::vector<std::string> tools{ "cone:70" };
  for (int i = 0; i < Sizes; ++i)
  {
    for (const char* shape : { "sphere:", "flat:", "paraboloid:" })
    {
      tools.push_back(shape + std::to_string(Least + Step * i));
    }
  }
  return tools;
}

double secondsNow()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void ManyTools(benchmark::State& state)
{
  static double radius = Radius;
  double first = 0.0;
  double sum = 0.0;
  const std::vector<std::string> tools = manyTools();
  for (auto _ : state)
  {
    radius += 1e-3;
    vtkNew<vtkSphereSource> source;
    source->SetRadius(radius);
    source->SetThetaResolution(Rings);
    source->SetPhiResolution(Rings);
    source->Update();
    const double begin = secondsNow();
    for (const std::string& specification : tools)
    {
      vtkNew<vtkContactTool> tool;
      vtkNew<vtkToolContactResponse> response;
      if (!tool->SetSpecification(specification))
      {
        state.SkipWithError("no tool");
        return;
      }
      response->SetInputData(source->GetOutput());
      response->SetTool(tool);
      response->SetMaximumDeflection(Depth);
      response->SetLayerThickness(state.range(0) == 1 ? 8.0 : 0.0);
      response->Update();
      first = &specification == &tools.front() ? secondsNow() - begin : first;
    }
    sum += secondsNow() - begin;
    state.SetIterationTime(secondsNow() - begin);
    state.counters["points"] = static_cast<double>(source->GetOutput()->GetNumberOfPoints());
  }
  const double each = sum / static_cast<double>(state.iterations()) / tools.size();
  state.counters["tools"] = static_cast<double>(tools.size());
  state.counters["first_s"] = first;
  state.counters["each_s"] = each;
  state.counters["ratio"] = first / each;
}
} // namespace

BENCHMARK(ManyTools)->Arg(0)->Arg(1)->UseManualTime()->Unit(benchmark::kSecond)->Iterations(1);
