// SPDX-License-Identifier: BSD-3-Clause
// Responses in fewer numbers: how few suffice for bodies of known structure, and equal forces on
// tips.
#include "ContractOracle.h"
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkDataObject.h"
#include "vtkReducedContactResponse.h"
#include "vtkStringArray.h"
#include "vtkToolContactProbe.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>

namespace
{
using namespace palpate::testing;

constexpr int YoungIndex = 0;
constexpr int ThicknessIndex = 1;
constexpr int ComplianceIndex = 2;
constexpr double Radius = 50.0;
// Error of storing floats a second time: 6e-8, up to ten times as large between samples.
constexpr double Storage = 1e-6;

Body ball()
{
  Body body = sphereBody(Radius, 4);
  addRadialNormals(body);
  return body;
}

Body respond(vtkPolyData* body, const std::string& tool, int index = -1, const char* array = "")
{
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool(tool));
  makePlain(filter);
  if (index >= 0)
  {
    filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
  }
  filter->Update();
  auto copy = Body::New();
  copy->ShallowCopy(filter->GetOutput());
  return copy;
}

vtkSmartPointer<vtkReducedContactResponse> reduce(vtkPolyData* body, double tolerance)
{
  auto filter = vtkSmartPointer<vtkReducedContactResponse>::New();
  filter->SetInputData(body);
  filter->SetTolerance(tolerance);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  return filter;
}

/// Tips on the reduced body have the same forces as on the full body.
void checkFelt(vtkPolyData* body, vtkPolyData* reduced, double tolerance)
{
  const Body tips = tipsInCube(4000, Radius / std::sqrt(3.0), 4);
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i) // tips at depths of up to 2.1 mm
  {
    double x[3];
    tips->GetPoint(i, x);
    vtkMath::Normalize(x);
    vtkMath::MultiplyScalar(x, Radius - 2.1 * static_cast<double>(i + 1) / 4000.0);
    tips->GetPoints()->SetPoint(i, x);
  }
  vtkSmartPointer<vtkDataArray> forces[2];
  vtkPolyData* const bodies[] = { body, reduced };
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkToolContactProbe> probe;
    probe->SetInputData(0, bodies[k]);
    probe->SetTipData(tips);
    probe->Update();
    forces[k] = probe->GetOutput()->GetPointData()->GetArray("NormalForce");
  }
  for (vtkIdType i = 0; i < 4000; ++i)
  {
    const double force = forces[0]->GetTuple1(i);
    // Below the first sample, at 1/32 mm, the error is relative to the force at the first sample.
    PALPATE_CHECK_NEAR(forces[1]->GetTuple1(i), force, 1.1 * tolerance * std::max(force, 2e-3));
  }
}

void checkOneLaw()
{
  const Body body = respond(ball(), "sphere:6.35");
  const auto filter = reduce(body, 1e-4);
  vtkPolyData* output = filter->GetOutput();
  PALPATE_CHECK(filter->GetForm() == vtkReducedContactResponse::OneLaw);
  PALPATE_CHECK(filter->GetNumbersPerPoint() == 0 && filter->GetNumbersPerPointBefore() == 16);
  PALPATE_CHECK(filter->GetLargestError() < Storage);
  PALPATE_CHECK(!output->GetPointData()->HasArray("ResponseForce"));
  PALPATE_CHECK(!output->GetPointData()->HasArray("ResponseStiffness"));
  PALPATE_CHECK(output->GetFieldData()->GetArray("ResponseBasis")->GetNumberOfTuples() == 1);
  PALPATE_CHECK(output->GetPointData()->GetArray("ResponseCoefficient")->GetRange()[1] == 1.0);
  // The input keeps its arrays, including the field arrays.
  PALPATE_CHECK(body->GetPointData()->HasArray("ResponseForce"));
  PALPATE_CHECK(!body->GetFieldData()->HasArray("ResponseBasis"));
  auto* report =
    vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("ResponseReduction"));
  PALPATE_CHECK_TEXT(report->GetValue(0), "one law", "0 instead of 16");
  PALPATE_CHECK(output->GetFieldData()->GetArray("ResponseReductionError")->GetTuple1(0) ==
    filter->GetLargestError());
  checkFelt(body, output, Storage);
}

void checkScale()
{
  Body bare = ball();
  pointArray(bare, "E", [](vtkIdType i) { return 0.02 + 1e-4 * static_cast<double>(i); });
  const Body body = respond(bare, "cone:60", YoungIndex, "E");
  const auto filter = reduce(body, 1e-4);
  PALPATE_CHECK(filter->GetForm() == vtkReducedContactResponse::Scale);
  PALPATE_CHECK(filter->GetNumbersPerPoint() == 1);
  checkFelt(body, filter->GetOutput(), Storage);
}

/// Soft tissue of 6 to 20 mm over bone. 16 % of the points have no bone below them, as on a head.
void checkLayers()
{
  Body bare = ball();
  pointArray(bare, "Scalp",
    [](vtkIdType i)
    { return i % 25 < 4 ? 0.0 : 6.0 + 14.0 * static_cast<double>((37 * i) % 1000) / 999.0; });
  for (const char* tool : { "sphere:6.35", "flat:1.6", "cone:60" })
  {
    const Body body = respond(bare, tool, ThicknessIndex, "Scalp");
    const auto filter = reduce(body, 0.01);
    PALPATE_CHECK(filter->GetNumbersPerPoint() <= 4);
    PALPATE_CHECK(filter->GetLargestError() <= 0.01);
    checkFelt(body, filter->GetOutput(), 0.01);
    // The reported error is the error at the reported point.
    const ContractOracle whole(body);
    const vtkIdType worst = filter->GetWorstPoint();
    vtkDataArray* basis = filter->GetOutput()->GetFieldData()->GetArray("ResponseBasis");
    vtkDataArray* share = filter->GetOutput()->GetPointData()->GetArray("ResponseCoefficient");
    double largest = 0.0;
    for (int k = 0; k < 8; ++k) // errors are evaluated at the samples only
    {
      double force = 0.0;
      for (int law = 0; law < filter->GetNumbersPerPoint(); ++law)
      {
        force += share->GetComponent(worst, law) * basis->GetComponent(law, k);
      }
      const double right = whole.force(worst, 2.0 * (k + 1) * (k + 1) / 64.0);
      largest = std::max(largest, std::abs(force - right) / right);
    }
    PALPATE_CHECK(largest <= filter->GetLargestError() + 1e-9);
    PALPATE_CHECK(largest >= 0.5 * filter->GetLargestError());
  }
}

void checkSeries()
{
  Body bare = ball();
  pointArray(bare, "C", [](vtkIdType i) { return 0.5 * static_cast<double>(i % 101); });
  const Body body = respond(bare, "sphere:6.35", ComplianceIndex, "C");
  for (const double tolerance : { 1e-3, 1e-2, 0.1 })
  {
    const auto filter = reduce(body, tolerance);
    PALPATE_CHECK(filter->GetForm() == vtkReducedContactResponse::Basis);
    PALPATE_CHECK(filter->GetLargestError() <= tolerance);
    checkFelt(body, filter->GetOutput(), tolerance);
  }
}

void checkFile(const std::string& folder)
{
  Body bare = ball();
  pointArray(bare, "C", [](vtkIdType i) { return 0.5 * static_cast<double>(i % 101); });
  const Body body = respond(bare, "sphere:6.35", ComplianceIndex, "C");
  const auto filter = reduce(body, 0.01);
  const std::string path = folder + "/palpate_reduced.vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(filter->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->SetDataModeToBinary();
  PALPATE_CHECK(writer->Write() == 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  checkFelt(body, reader->GetOutput(), 0.01);
}

void checkErrors()
{
  const Body body = respond(ball(), "sphere:6.35");
  vtkNew<vtkReducedContactResponse> filter;
  Messages messages(filter.Get());
  const auto expect = [&](const char* word, const char* number)
  {
    filter->Update();
    PALPATE_CHECK_TEXT(messages.errors(), word, number);
    messages.clear();
  };
  filter->SetInputData(body);
  for (const double wrong : { 0.0, -1.0, std::nan("") })
  {
    filter->SetTolerance(wrong);
    expect("Tolerance", "above 0");
  }
  filter->SetTolerance(0.01);
  filter->SetMaximumNumberOfLaws(17);
  expect("Maximum Number Of Laws", "17");
  filter->SetMaximumNumberOfLaws(8);
  filter->SetResponseName("Finger");
  expect("Finger", "No response");
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  PALPATE_CHECK(messages.errors().empty() && filter->GetOutput()->GetNumberOfPoints() == 0);
}
} // namespace

int TestReducedContactResponse(int argc, char* argv[])
{
  checkOneLaw();
  checkScale();
  checkLayers();
  checkSeries();
  checkFile(argv[argc - 1]);
  checkErrors();
  return result();
}
