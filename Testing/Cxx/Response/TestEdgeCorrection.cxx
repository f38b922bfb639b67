// SPDX-License-Identifier: BSD-3-Clause
// Sharp edges in a response: their arrays, their effect on a probe, on the error and on the chosen
// terms, and their treatment in files and other forms.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "Response/BodyConversion.h"
#include "Response/FlatBodyConversion.h"
#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkReducedContactResponse.h"
#include "vtkStringArray.h"
#include "vtkToolContactProbe.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;

using Filter = vtkSmartPointer<vtkToolContactResponse>;

constexpr double Reduced = 0.1 / (1.0 - 0.45 * 0.45);
constexpr double Half = 100.0; // half side of the block, mm: the other edges are out of reach

/// A path of a tip: pressed 1 mm into the upper face at 20 mm from its edge x = Half, then moved
/// along x over the edge.
vtkSmartPointer<vtkPolyData> over(double depth, double beyond, int steps)
{
  auto tips = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i <= 20; ++i)
  {
    points->InsertNextPoint(Half - 20.0, 0.3, Half + 0.1 - (depth + 0.1) * i / 20.0);
  }
  for (int i = 1; i <= steps; ++i)
  {
    points->InsertNextPoint(Half - 20.0 + (20.0 + beyond) * i / steps, 0.3, Half - depth);
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    lines->InsertCellPoint(i);
  }
  tips->SetPoints(points);
  tips->SetLines(lines);
  return tips;
}

vtkSmartPointer<vtkDataArray> forcesOver(vtkPolyData* body, vtkPolyData* tips)
{
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(body);
  probe->SetTipData(tips);
  probe->Update();
  return probe->GetOutput()->GetPointData()->GetArray("Force");
}

double largestJump(vtkDataArray* forces)
{
  double largest = 0.0;
  for (vtkIdType i = 21; i < forces->GetNumberOfTuples(); ++i)
  {
    double square = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double change = forces->GetComponent(i, k) - forces->GetComponent(i - 1, k);
      square += change * change;
    }
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

vtkDataArray* edgesOf(vtkPolyData* body)
{
  return body->GetFieldData()->GetArray("ResponseEdges");
}

Filter withEdges(vtkPolyData* body, const char* tool, double range)
{
  Filter filter = filterOf(body, tool, range);
  filter->SetCurvatureCorrection(false);
  filter->EdgeCorrectionOn();
  filter->Update();
  return filter;
}

void checkTerms(vtkPolyData* box)
{
  for (const SinkingTool& each : SinkingTools)
  {
    const Filter filter = withEdges(box, each.tool, 1.0);
    vtkDataArray* edges = edgesOf(filter->GetOutput());
    PALPATE_CHECK(edges != nullptr && edges->GetNumberOfComponents() == 5);
    PALPATE_CHECK_NEAR(edges->GetComponent(0, 0), each.exponent, 1e-9);
    PALPATE_CHECK_NEAR(edges->GetComponent(0, 1), each.radius, 1e-9);
    PALPATE_CHECK_NEAR(edges->GetComponent(0, 2), 0.45, 1e-12);
    PALPATE_CHECK(edges->GetComponent(0, 3) == 2.0 * Half && edges->GetComponent(0, 4) == 0.0);
  }
  const Filter layer = filterOf(box, "sphere:5", 1.0);
  layer->SetLayerThickness(6.0);
  layer->EdgeCorrectionOn();
  layer->Update();
  PALPATE_CHECK_NEAR(edgesOf(layer->GetOutput())->GetComponent(0, 3), 6.0, 1e-9);
}

/// The correction is off by default. It does not change the curves, and a sharp edge does not count
/// as curvature of the faces, which are flat on a box.
void checkOff(vtkPolyData* box)
{
  const Filter off = filterOf(box, "sphere:5", 1.0);
  off->SetCurvatureCorrection(false);
  off->Update();
  const Filter on = filterOf(box, "sphere:5", 1.0);
  on->EdgeCorrectionOn();
  on->Update();
  PALPATE_CHECK(edgesOf(off->GetOutput()) == nullptr);
  vtkDataArray* one = off->GetOutput()->GetPointData()->GetArray("ResponseForce");
  vtkDataArray* other = on->GetOutput()->GetPointData()->GetArray("ResponseForce");
  bool isSame = true;
  for (vtkIdType i = 0; i < one->GetNumberOfTuples(); ++i)
  {
    constexpr double rounding = 1e-6; // rounding of float32 normals
    isSame =
      isSame && std::abs(one->GetComponent(i, 7) / other->GetComponent(i, 7) - 1.0) < rounding;
  }
  PALPATE_CHECK(isSame);
}

void checkForce(vtkPolyData* box)
{
  const Filter filter = withEdges(box, "paraboloid:5", 1.0);
  const auto tips = over(1.0, 4.0, 24000); // 1 µm per step
  const auto forces = forcesOver(filter->GetOutput(), tips);
  const double far = 4.0 / 3.0 * Reduced * std::sqrt(5.0);
  const vtkIdType last = forces->GetNumberOfTuples() - 1;
  PALPATE_CHECK(largestJump(forces) < 1e-3 * far);
  PALPATE_CHECK(forces->GetComponent(last, 2) == 0.0);
  // Hetényi at ν = 0.45: Φ(0) = 0.3547, χ(0) = 0.1482 a₀/δ (Data/Reference/edges).
  const vtkIdType atEdge = 20 + 20000;
  PALPATE_CHECK_NEAR(tips->GetPoint(atEdge)[0], Half, 1e-6);
  PALPATE_CHECK_NEAR(forces->GetComponent(atEdge, 2) / far, 0.3547, 4e-3);
  PALPATE_CHECK_NEAR(forces->GetComponent(atEdge, 0) / far * std::sqrt(5.0), 0.1482, 4e-3);
}

void checkErrorAndChoice()
{
  const Body small = boxBody(10.0, 10.0, 10.0, 8);
  const auto errorBeside = [&](bool isOn)
  {
    const Filter filter = filterOf(small, "sphere:2", 0.5);
    filter->SetEdgeCorrection(isOn);
    filter->Update();
    double place[3] = { 7.5, 0.0, 10.0 };
    return filter->GetOutput()
      ->GetPointData()
      ->GetArray("ResponseError")
      ->GetComponent(small->FindPoint(place), 7);
  };
  const double without = errorBeside(false);
  const double with = errorBeside(true);
  PALPATE_CHECK(with < 0.5 * without);
  PALPATE_CHECK(with > 0.01); // a part of the error remains

  const auto reasonOn = [](vtkPolyData* body)
  {
    const Filter filter = filterOf(body, "sphere:2", 0.5);
    filter->EdgeCorrectionOn();
    filter->AutomaticTermsOn();
    filter->Update();
    PALPATE_CHECK((edgesOf(filter->GetOutput()) != nullptr) ==
      (filter->GetTermReason().find("sharp edges have an effect") != std::string::npos));
    return filter->GetTermReason();
  };
  PALPATE_CHECK_TEXT(reasonOn(small), "sharp edges have an effect");
  PALPATE_CHECK_TEXT(reasonOn(sphereBody(10.0, 3)), "no sharp edge");
}

/// The correction is kept in a file, in the compact form, and with a global compliance.
void checkKept(vtkPolyData* box, const std::string& folder)
{
  const Filter filter = withEdges(box, "cone:60", 1.0);
  vtkNew<vtkReducedContactResponse> reduced;
  reduced->SetInputData(filter->GetOutput());
  reduced->Update();
  PALPATE_CHECK(edgesOf(reduced->GetOutput()) != nullptr);

  const std::string path = folder + "/edges.palpate";
  PALPATE_CHECK(palpate::writeFlatBody(filter->GetOutput(), "Response", path).empty());
  std::string error;
  const auto read = palpate::readFlatBody(path, "Response", error);
  PALPATE_CHECK(read && error.empty());
  for (int k = 0; read && k < 5; ++k)
  {
    PALPATE_CHECK(
      edgesOf(read)->GetComponent(0, k) == edgesOf(filter->GetOutput())->GetComponent(0, k));
  }

  Body soft = Body::New();
  soft->ShallowCopy(box);
  vtkNew<vtkDoubleArray> compliance;
  compliance->SetName("GlobalCompliance");
  compliance->SetNumberOfTuples(soft->GetNumberOfPoints());
  compliance->Fill(0.2);
  soft->GetPointData()->AddArray(compliance);
  const Filter series = filterOf(soft, "sphere:5", 1.0);
  series->SetInputArrayToProcess(2, 0, 0, 0, "GlobalCompliance");
  series->EdgeCorrectionOn();
  series->Update();
  PALPATE_CHECK(edgesOf(series->GetOutput())->GetComponent(0, 4) == 1.0);
}

void checkFaults(vtkPolyData* box)
{
  const Filter filter = withEdges(box, "sphere:5", 1.0);
  const struct
  {
    int component;
    double value;
    const char* word;
  } faults[] = { { 0, -1.0, "exponent" }, { 1, 0.0, "contact radius" }, { 2, 0.7, "Poisson" },
    { 3, -1.0, "extent" }, { 0, std::nan(""), "exponent" } };
  for (const auto& each : faults)
  {
    Body broken = Body::New();
    broken->DeepCopy(filter->GetOutput());
    edgesOf(broken)->SetComponent(0, each.component, each.value);
    palpate::ResponseArrays arrays;
    std::string error;
    PALPATE_CHECK(!palpate::viewResponse(broken, "Response", arrays, error));
    PALPATE_CHECK_TEXT(error, "ResponseEdges", each.word);
  }
  Body brief = Body::New();
  brief->DeepCopy(filter->GetOutput());
  vtkNew<vtkDoubleArray> two;
  two->SetName("ResponseEdges");
  two->SetNumberOfComponents(2);
  two->InsertNextTuple2(1.0, 2.0);
  brief->GetFieldData()->AddArray(two);
  palpate::ResponseArrays arrays;
  std::string error;
  PALPATE_CHECK(!palpate::viewResponse(brief, "Response", arrays, error));
  PALPATE_CHECK_TEXT(error, "ResponseEdges", "5 components");
}
} // namespace

int TestEdgeCorrection(int argc, char* argv[])
{
  const Body box = boxBody(Half, Half, Half, 10);
  checkTerms(box);
  checkOff(box);
  checkForce(box);
  checkErrorAndChoice();
  checkKept(box, argc > 1 ? argv[1] : ".");
  checkFaults(box);
  return palpate::testing::result();
}
