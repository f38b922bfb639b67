// SPDX-License-Identifier: BSD-3-Clause
// The error of a curve that is stored in 8 samples. The curve passes through the filter's arrays
// and the evaluation of the servo tick, and is compared with the law itself (E* = 3.45 MPa, range 2
// mm). The time is the time of one evaluation.
#include "Response/BodyConversion.h"
#include "Mechanics/SeriesCompliance.h"
#include "Mechanics/Tools/ToolSpecification.h"
#include "vtkCellArray.h"
#include "vtkContactTool.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkToolContactResponse.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

namespace
{
constexpr double Modulus = 3.45;
constexpr double Range = 2.0;
constexpr int Probes = 10000;

/// Returns the stored response of one tool with one global compliance (mm/N), in the form that the
/// tick uses.
std::unique_ptr<palpate::ResponseField> store(const std::string& tool, double compliance)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkDoubleArray> compliances;
  compliances->SetName("C");
  compliances->SetNumberOfTuples(3);
  compliances->Fill(compliance);
  vtkNew<vtkPolyData> body;
  body->SetPoints(points);
  body->SetPolys(triangle);
  body->GetPointData()->AddArray(compliances);

  vtkNew<vtkContactTool> shape;
  shape->SetSpecification(tool);
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(shape);
  filter->CurvatureCorrectionOff();
  filter->SetErrorTolerance(0.0);
  filter->SetYoungsModulus(Modulus);
  filter->SetPoissonRatio(0.0);
  filter->SetMaximumDeflection(Range);
  filter->SetInputArrayToProcess(2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "C");
  filter->Update();
  std::string error;
  return palpate::makeResponseField(filter->GetOutput(), "Response", error);
}

/// Largest relative error of the force between two depths, given as fractions of the range.
double largestError(const palpate::ResponseField& field, const palpate::AxisymmetricTool& law,
  double compliance, double from, double to)
{
  double largest = 0.0;
  for (int i = 1; i <= Probes; ++i)
  {
    const double depth = Range * i / Probes;
    if (depth >= from * Range && depth <= to * Range)
    {
      const double exact = palpate::seriesResponse(law, Modulus, compliance, depth).force;
      largest = std::max(largest, std::abs(field.evaluate(0, depth).force / exact - 1.0));
    }
  }
  return largest;
}

void storageError(benchmark::State& state, const std::string& tool, double compliance)
{
  const auto field = store(tool, compliance);
  palpate::ToolSpecification specification;
  std::string error;
  palpate::parseTool(tool, specification, error);
  const auto law = palpate::makeTool(specification);
  if (!field || !law)
  {
    state.SkipWithError("no response");
    return;
  }
  int i = 0;
  for (auto _ : state)
  {
    i = i % Probes + 1;
    benchmark::DoNotOptimize(field->evaluate(0, Range * i / Probes));
  }
  state.counters["error_1_100"] = largestError(*field, *law, compliance, 0.01, 1.0);
  state.counters["error_first_percent"] = largestError(*field, *law, compliance, 0.0, 0.01);
  state.counters["exponent"] = field->sampling().exponent();
}

const bool registered = []
{
  for (const char* tool : { "flat:1.6", "paraboloid:6.35", "sphere:6.35", "sphere:1.6", "cone:60" })
  {
    for (const double compliance : { 0.0, 1.0, 10.0 })
    {
      const std::string name =
        std::string("StorageError/") + tool + "/C=" + std::to_string(static_cast<int>(compliance));
      benchmark::RegisterBenchmark(name.c_str(), storageError, std::string(tool), compliance)
        ->MinTime(0.05);
    }
  }
  return true;
}();
} // namespace
