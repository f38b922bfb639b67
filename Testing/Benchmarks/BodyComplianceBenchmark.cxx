// SPDX-License-Identifier: BSD-3-Clause
// The compliance of a whole body from its closed surface: a bumpy ball of 10⁵ triangles, and a
// bumpy ball of 4·10⁵. `ratio`: time relative to the response of the same surface on a half-space
// in the same run. `again_s`: time for another modulus, with the result read from the cache, s.
#include "vtkBodyCompliance.h"
#include "vtkContactTool.h"
#include "vtkToolContactResponse.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <benchmark/benchmark.h>

#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace
{
constexpr double Radius = 60.0; // mm

/// Makes a ball whose radius varies by a tenth, of `rings` × 2 `rings` × 2 triangles.
void makeBumpyBall(int rings, vtkPolyData* body)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(Radius);
  source->SetThetaResolution(2 * rings);
  source->SetPhiResolution(rings);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  body->DeepCopy(source->GetOutput());
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> place{};
    body->GetPoint(i, place.data());
    const double scale =
      1.0 + 0.1 * std::sin(0.1 * place[0]) * std::sin(0.13 * place[1] + 0.07 * place[2]);
    body->GetPoints()->SetPoint(i, scale * place[0], scale * place[1], scale * place[2]);
  }
}

double secondsOf(vtkAlgorithm* filter)
{
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void BodyCompliance(benchmark::State& state)
{
  const auto cache = std::filesystem::temp_directory_path() /
    ("palpate-benchmark-" + std::to_string(static_cast<long>(getpid())));
  setenv("PALPATE_CACHE", cache.c_str(), 1);
  vtkNew<vtkPolyData> body;
  makeBumpyBall(static_cast<int>(state.range(0)), body);
  for (auto _ : state)
  {
    std::filesystem::remove_all(cache);
    vtkNew<vtkContactTool> tool;
    tool->SetSpecification("sphere:6.35");
    vtkNew<vtkToolContactResponse> response;
    response->SetInputData(body);
    response->SetTool(tool);
    response->SetMaximumDeflection(1.0);
    const double local = secondsOf(response);
    vtkNew<vtkBodyCompliance> compliance;
    compliance->SetInputData(body);
    const double whole = secondsOf(compliance);
    if (!compliance->GetOutput()->GetPointData()->HasArray("GlobalCompliance"))
    {
      state.SkipWithError("no compliance");
      return;
    }
    compliance->SetYoungsModulus(0.2);
    state.SetIterationTime(whole);
    state.counters["again_s"] = secondsOf(compliance);
    state.counters["triangles"] = static_cast<double>(body->GetNumberOfCells());
    state.counters["ratio"] = whole / local;
  }
  std::filesystem::remove_all(cache);
}
} // namespace

BENCHMARK(BodyCompliance)
  ->Arg(160)
  ->Arg(320)
  ->UseManualTime()
  ->Unit(benchmark::kSecond)
  ->Iterations(1);
