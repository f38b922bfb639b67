// SPDX-License-Identifier: BSD-3-Clause
// The arrays of the data contract: names, types, shapes and values. Also normals, and arrays that
// are passed on.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double BodyRadius = 40.0;
constexpr int Samples = 12;
constexpr double Range = 1.7;
constexpr double Young = 0.3;
constexpr double Poisson = 0.4;

Body decoratedBody()
{
  Body body = sphereBody(BodyRadius, 2);
  pointArray<vtkIntArray>(body, "Label", [](vtkIdType i) { return 3.0 * static_cast<double>(i); });
  vtkNew<vtkIntArray> cells;
  cells->SetName("Organ");
  cells->SetNumberOfTuples(body->GetNumberOfCells());
  cells->Fill(7);
  body->GetCellData()->AddArray(cells);
  vtkNew<vtkStringArray> origin;
  origin->SetName("Origin");
  origin->InsertNextValue("made in a test");
  body->GetFieldData()->AddArray(origin);
  return body;
}

vtkSmartPointer<vtkToolContactResponse> makeFilter(vtkPolyData* body, vtkContactTool* tool)
{
  auto filter = vtkSmartPointer<vtkToolContactResponse>::New();
  filter->SetInputData(body);
  filter->SetTool(tool);
  filter->SetYoungsModulus(Young);
  filter->SetPoissonRatio(Poisson);
  filter->SetMaximumDeflection(Range);
  filter->SetNumberOfSamples(Samples);
  makePlain(filter);
  return filter;
}

void checkContract(vtkPolyData* output, const std::string& name, vtkContactTool* tool)
{
  vtkPointData* data = output->GetPointData();
  const auto array = [&](const char* suffix, int type, int components)
  {
    vtkDataArray* found = data->GetArray((name + suffix).c_str());
    PALPATE_CHECK(found && found->GetDataType() == type &&
      found->GetNumberOfComponents() == components &&
      found->GetNumberOfTuples() == output->GetNumberOfPoints());
    return found;
  };
  vtkDataArray* force = array("Force", VTK_FLOAT, Samples);
  vtkDataArray* stiffness = array("Stiffness", VTK_FLOAT, Samples);
  array("Normal", VTK_FLOAT, 3);
  vtkDataArray* range = array("Range", VTK_FLOAT, 1);
  vtkDataArray* status = array("Status", VTK_UNSIGNED_CHAR, 1);
  array("Validity", VTK_FLOAT, 1);
  array("Limit", VTK_UNSIGNED_CHAR, 1);
  if (failures() > 0)
  {
    return;
  }

  vtkFieldData* field = output->GetFieldData();
  const auto text = [&](const char* suffix)
  {
    auto* found = vtkStringArray::SafeDownCast(field->GetAbstractArray((name + suffix).c_str()));
    return found && found->GetNumberOfValues() == 1 ? found->GetValue(0) : std::string();
  };
  vtkDataArray* exponent = field->GetArray((name + "Exponent").c_str());
  PALPATE_CHECK(exponent && exponent->GetDataType() == VTK_DOUBLE && exponent->GetTuple1(0) == 1.5);
  vtkDataArray* samples = field->GetArray((name + "Samples").c_str());
  PALPATE_CHECK(samples && samples->GetDataType() == VTK_INT && samples->GetTuple1(0) == Samples);
  PALPATE_CHECK(text("Tool") == "sphere:3.2");
  PALPATE_CHECK(text("Model") == "half-space");
  PALPATE_CHECK(text("Units") == "mm,N,MPa");

  const double modulus = Young / (1.0 - Poisson * Poisson);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    PALPATE_CHECK(range->GetTuple1(i) == static_cast<double>(static_cast<float>(Range)));
    PALPATE_CHECK(status->GetTuple1(i) == 0.0);
    for (int k = 0; k < Samples; ++k)
    {
      const double s = (k + 1.0) / Samples;
      const double f = tool->GetForce(Range * s * s, modulus);
      const double slope = tool->GetStiffness(Range * s * s, modulus);
      // Half a unit in the last place of a float is 6e-8.
      PALPATE_CHECK_NEAR(force->GetComponent(i, k), f, 6.1e-8 * f);
      PALPATE_CHECK_NEAR(stiffness->GetComponent(i, k), slope, 6.1e-8 * slope);
    }
  }
}

void checkPassThrough(vtkPolyData* input, vtkPolyData* output)
{
  PALPATE_CHECK(output->GetPoints() == input->GetPoints());
  PALPATE_CHECK(output->GetPolys() == input->GetPolys());
  PALPATE_CHECK(
    output->GetPointData()->GetArray("Label") == input->GetPointData()->GetArray("Label"));
  PALPATE_CHECK(
    output->GetCellData()->GetArray("Organ") == input->GetCellData()->GetArray("Organ"));
  PALPATE_CHECK(output->GetFieldData()->GetAbstractArray("Origin") ==
    input->GetFieldData()->GetAbstractArray("Origin"));
}

/// The properties of an input that must not change: modification times and values.
struct Snapshot
{
  explicit Snapshot(vtkPolyData* body)
  {
    this->Copy->DeepCopy(body);
    this->Times = { body->GetMTime(), body->GetPoints()->GetMTime(), body->GetPolys()->GetMTime(),
      body->GetPointData()->GetMTime(), body->GetPointData()->GetArray("Label")->GetMTime(),
      body->GetCellData()->GetMTime(), body->GetFieldData()->GetMTime() };
  }
  bool operator==(const Snapshot& other) const
  {
    vtkPolyData* a = this->Copy;
    vtkPolyData* b = other.Copy;
    bool same = this->Times == other.Times && a->GetNumberOfPoints() == b->GetNumberOfPoints() &&
      a->GetNumberOfCells() == b->GetNumberOfCells() &&
      a->GetPointData()->GetNumberOfArrays() == b->GetPointData()->GetNumberOfArrays() &&
      a->GetFieldData()->GetNumberOfArrays() == b->GetFieldData()->GetNumberOfArrays();
    for (vtkIdType i = 0; same && i < a->GetNumberOfPoints(); ++i)
    {
      double p[3];
      double q[3];
      a->GetPoint(i, p);
      b->GetPoint(i, q);
      same = p[0] == q[0] && p[1] == q[1] && p[2] == q[2] &&
        a->GetPointData()->GetArray("Label")->GetTuple1(i) ==
          b->GetPointData()->GetArray("Label")->GetTuple1(i);
    }
    return same;
  }

  vtkNew<vtkPolyData> Copy;
  std::vector<vtkMTimeType> Times;
};

/// Angle-weighted normals (Thürmer and Wüthrich 1998), computed with VTK's vector functions.
std::vector<std::array<double, 3>> angleWeighted(vtkPolyData* body)
{
  std::vector<std::array<double, 3>> sum(static_cast<std::size_t>(body->GetNumberOfPoints()));
  for (vtkIdType cell = 0; cell < body->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    body->GetCellPoints(cell, ids);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      body->GetPoint(ids->GetId(k), p[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      double u[3];
      double v[3];
      double n[3];
      vtkMath::Subtract(p[(k + 1) % 3], p[k], u);
      vtkMath::Subtract(p[(k + 2) % 3], p[k], v);
      vtkMath::Cross(u, v, n);
      vtkMath::Normalize(n);
      const double angle = vtkMath::AngleBetweenVectors(u, v);
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum[static_cast<std::size_t>(ids->GetId(k))][c] += angle * n[c];
      }
    }
  }
  return sum;
}

void checkNormals(vtkContactTool* tool)
{
  // Unit vectors as floats: components have an error of up to 6e-8, lengths of 1e-7.
  constexpr double FloatUnit = 1.3e-7;
  Body body = decoratedBody();
  auto filter = makeFilter(body, tool);
  filter->Update();
  vtkDataArray* computed = filter->GetOutput()->GetPointData()->GetArray("ResponseNormal");
  auto expected = angleWeighted(body);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    vtkMath::Normalize(expected[static_cast<std::size_t>(i)].data());
    for (int c = 0; c < 3; ++c)
    {
      PALPATE_CHECK_NEAR(computed->GetComponent(i, c),
        expected[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)], FloatUnit);
    }
  }
  addRadialNormals(body, 3.0); // given normals need not have unit length
  filter->Update();
  vtkDataArray* given = filter->GetOutput()->GetPointData()->GetArray("ResponseNormal");
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      PALPATE_CHECK_NEAR(given->GetComponent(i, c), body->GetPoint(i)[c] / BodyRadius, FloatUnit);
    }
  }
}
} // namespace

int TestToolContactResponse(int, char*[])
{
  const auto tool = makeTool("sphere:3.2");
  Body body = decoratedBody();
  auto filter = makeFilter(body, tool);
  Messages messages(filter.Get());
  body->BuildCells(); // otherwise the copy in Snapshot would build the cells
  const Snapshot before(body);
  filter->Update();
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK(before == Snapshot(body));
  checkContract(filter->GetOutput(), "Response", tool);
  checkPassThrough(body, filter->GetOutput());

  // A second tool with another response name, on the output of the first filter.
  auto second = makeFilter(nullptr, tool);
  second->SetInputConnection(filter->GetOutputPort());
  second->SetResponseName("Other");
  second->Update();
  checkContract(second->GetOutput(), "Response", tool);
  checkContract(second->GetOutput(), "Other", tool);
  checkNormals(tool);
  return palpate::testing::result();
}
