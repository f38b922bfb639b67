// SPDX-License-Identifier: BSD-3-Clause
// The responses of three tools on a body's true shape: a block of 31 × 31 × 31 hexahedra of 1 mm on
// a fixed base, 95 thousand unknowns and 5768 points, each of which is a source. `first_s` includes
// factor and solutions; `next_s` is the time of each further tool. The memory is given both as
// forecast and as measured. To be compared with ElasticComplianceOfAllPoints, which has the same
// body and factor, but one number per point.
#include "ProcessMemory.h"
#include "Response/VolumeBlock.h"

#include "vtkContactTool.h"
#include "vtkElasticContactResponse.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <benchmark/benchmark.h>

#include <chrono>

namespace
{
constexpr int CellsPerSide = 31;

double secondsOf(vtkAlgorithm* filter)
{
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void ElasticContactResponseOfThreeTools(benchmark::State& state)
{
  const auto grid = palpate::testing::block(CellsPerSide, CellsPerSide, VTK_HEXAHEDRON);
  for (auto _ : state)
  {
    palpate::testing::resetPeakMemory();
    const double before = palpate::testing::residentMemory();
    vtkNew<vtkElasticContactResponse> filter;
    filter->SetInputData(grid);
    filter->SetMaximumDeflection(1.0);
    vtkNew<vtkContactTool> tool;
    filter->SetTool(tool);
    double first = 0.0;
    double next = 0.0;
    for (const char* name :
      { "sphere:6.35", "sphere:1.6", "flat:1.6" }) // the tool with the widest contact is first
    {
      tool->SetSpecification(name);
      const double seconds = secondsOf(filter);
      (first > 0.0 ? next : first) += seconds;
      if (filter->GetNumberOfSolutions() > 0)
      {
        state.counters["MiB told"] = filter->GetMemoryEstimate();
        state.counters["sources"] = static_cast<double>(filter->GetNumberOfSolutions());
      }
    }
    if (filter->GetOutput()->GetNumberOfPoints() == 0)
    {
      state.SkipWithError("no response");
      return;
    }
    state.SetIterationTime(first + next);
    state.counters["MiB taken"] = (palpate::testing::peakMemory() - before) / 1048576.0;
    state.counters["first_s"] = first;
    state.counters["next_s"] = 0.5 * next;
    state.counters["points"] = static_cast<double>(filter->GetOutput()->GetNumberOfPoints());
  }
}
} // namespace

BENCHMARK(ElasticContactResponseOfThreeTools)
  ->UseManualTime()
  ->Unit(benchmark::kSecond)
  ->Iterations(1);
