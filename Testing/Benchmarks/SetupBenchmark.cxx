// SPDX-License-Identifier: BSD-3-Clause
// The times for which a user of the live window waits: three tools on a layer of 150,000 points.
// Computed: computation of the first responses. ModulusChange: from the change of Young's modulus
// to the kernels for the session; `ratio` is relative to Computed in the same run.
#include "vtkContactSetup.h"
#include "vtkContactTool.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <thread>

namespace
{
constexpr int Rings = 388; // 150,000 points

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void ModulusChange(benchmark::State& state)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(100.0);
  source->SetThetaResolution(Rings);
  source->SetPhiResolution(Rings);
  source->Update();
  vtkPolyData* body = source->GetOutput();
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName("LayerThickness");
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    thickness->InsertNextValue(8.0 + 0.02 * body->GetPoint(i)[2]);
  }
  body->GetPointData()->AddArray(thickness);
  vtkNew<vtkContactSetup> setup;
  setup->SetBody(body);
  setup->SetModel(vtkContactSetup::Layer);
  setup->SetTolerance(0.01);
  for (const char* tool : { "sphere:6.35", "flat:1.6", "sphere:1.6" })
  {
    vtkNew<vtkContactTool> made;
    made->SetSpecification(tool);
    setup->AddTool(made);
  }
  const double start = now();
  if (!setup->Update())
  {
    state.SkipWithError("no responses");
    return;
  }
  const double computed = now() - start;
  double modulus = 0.05;
  double sum = 0.0;
  for (auto _ : state)
  {
    modulus *= 1.1;
    const double begin = now();
    setup->SetYoungsModulus(modulus);
    setup->Request();
    while (!setup->Collect())
    {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    const double taken = now() - begin;
    state.SetIterationTime(taken);
    sum += taken;
  }
  state.counters["computed_s"] = computed;
  state.counters["ratio"] = computed * static_cast<double>(state.iterations()) / sum;
  state.counters["points"] = static_cast<double>(body->GetNumberOfPoints());
}
} // namespace

BENCHMARK(ModulusChange)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(20);
