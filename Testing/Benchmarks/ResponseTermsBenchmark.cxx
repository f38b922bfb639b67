// SPDX-License-Identifier: BSD-3-Clause
// The cost of a response with its error, the body's curvature and finite strain, compared with the
// plain response in the same run. A ball of 498,002 points; a sphere of 6.35 mm radius, 1 mm deep.
#include "vtkContactTool.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkToolContactResponse.h"

#include <benchmark/benchmark.h>

namespace
{
/// A sphere of 80 mm radius with its own normals. Built once.
vtkPolyData* ball()
{
  static const vtkNew<vtkSphereSource> source;
  source->SetRadius(80.0);
  source->SetThetaResolution(1000);
  source->SetPhiResolution(500);
  source->Update();
  return source->GetOutput();
}

struct Terms
{
  double tolerance = 0.0;
  bool curvature = false;
  bool neoHooke = false;
};

void response(benchmark::State& state, const Terms& terms)
{
  vtkPolyData* body = ball();
  vtkNew<vtkContactTool> tool;
  tool->SetSpecification("sphere:6.35");
  for (auto _ : state)
  {
    vtkNew<vtkToolContactResponse> filter;
    filter->SetInputData(body);
    filter->SetTool(tool);
    filter->SetMaximumDeflection(1.0);
    filter->SetErrorTolerance(terms.tolerance);
    filter->SetCurvatureCorrection(terms.curvature);
    filter->SetStrainModel(
      terms.neoHooke ? vtkToolContactResponse::NeoHooke : vtkToolContactResponse::SmallStrain);
    filter->Update();
    if (!filter->GetOutput()->GetPointData()->HasArray("ResponseForce"))
    {
      state.SkipWithError("no response");
    }
  }
  state.counters["points"] = static_cast<double>(body->GetNumberOfPoints());
}

void TermsNone(benchmark::State& state)
{
  response(state, {});
}
void TermsError(benchmark::State& state)
{
  response(state, { 0.05 });
}
void TermsCurvature(benchmark::State& state)
{
  response(state, { 0.0, true });
}
/// The default terms of the filter.
void TermsErrorCurvature(benchmark::State& state)
{
  response(state, { 0.05, true });
}
void TermsErrorCurvatureStrain(benchmark::State& state)
{
  response(state, { 0.05, true, true });
}
} // namespace

#define PALPATE_TERMS_BENCHMARK(name)                                                              \
  BENCHMARK(name)->UseRealTime()->Unit(benchmark::kMillisecond)->MinTime(1.0)
PALPATE_TERMS_BENCHMARK(TermsNone);
PALPATE_TERMS_BENCHMARK(TermsError);
PALPATE_TERMS_BENCHMARK(TermsCurvature);
PALPATE_TERMS_BENCHMARK(TermsErrorCurvature);
PALPATE_TERMS_BENCHMARK(TermsErrorCurvatureStrain);
