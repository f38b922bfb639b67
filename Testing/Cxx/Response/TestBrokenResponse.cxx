// SPDX-License-Identifier: BSD-3-Clause
// Response arrays that violate the contract, as they may be in a file from another program. The
// probe reports an error that names the array, has an empty output, and works again with valid
// arrays.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkToolContactProbe.h"
#include "vtkUnsignedCharArray.h"
#include "Mechanics/Numerics/Constants.h"

#include <functional>

namespace
{
using namespace palpate::testing;
using palpate::NotANumber;

using Spoil = std::function<void(vtkPolyData*)>;

Body goodBody()
{
  const Body made = withResponse(planeBody(10.0, 2), "sphere:5");
  Body body = Body::New();
  body->DeepCopy(made);
  return body;
}

/// A body with one law and the coefficient 1 everywhere.
Body compactBody()
{
  Body body = goodBody();
  vtkPointData* points = body->GetPointData();
  vtkNew<vtkFloatArray> basis;
  basis->SetName("ResponseBasis");
  basis->SetNumberOfComponents(16);
  basis->SetNumberOfTuples(1);
  for (int k = 0; k < 8; ++k)
  {
    basis->SetComponent(0, k, points->GetArray("ResponseForce")->GetComponent(0, k));
    basis->SetComponent(0, 8 + k, points->GetArray("ResponseStiffness")->GetComponent(0, k));
  }
  body->GetFieldData()->AddArray(basis);
  pointArray<vtkFloatArray>(body, "ResponseCoefficient", [](vtkIdType) { return 1.0; });
  points->RemoveArray("ResponseForce");
  points->RemoveArray("ResponseStiffness");
  return body;
}

void expectError(const Body& good, const Spoil& spoil, std::initializer_list<const char*> words)
{
  vtkNew<vtkPolyData> tip;
  vtkNew<vtkPoints> position;
  position->InsertNextPoint(1.0, 2.0, -0.5);
  tip->SetPoints(position);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetTipData(tip);
  Messages messages(probe);
  Body bad = Body::New();
  bad->DeepCopy(good);
  spoil(bad);
  probe->SetInputData(bad);
  probe->Update();
  checkText(messages.takeErrors(), words, __FILE__, __LINE__);
  PALPATE_CHECK(probe->GetOutput()->GetNumberOfPoints() == 0);
  PALPATE_CHECK(probe->GetOutput()->GetPointData()->GetNumberOfArrays() == 0);
  probe->SetInputData(good);
  probe->Update();
  PALPATE_CHECK(messages.none() && probe->GetOutput()->GetNumberOfPoints() == 1);
  vtkDataArray* force = probe->GetOutput()->GetPointData()->GetArray("NormalForce");
  PALPATE_CHECK(force && force->GetTuple1(0) > 0.0);
}

/// Checks an array that is missing, has another type or shape, or is too short.
void checkPointArray(const Body& good, const std::string& name)
{
  const auto without = [name](vtkPolyData* body)
  { body->GetPointData()->RemoveArray(name.c_str()); };
  expectError(good, without, { ("'" + name + "' is missing").c_str() });
  const vtkDataArray* array = good->GetPointData()->GetArray(name.c_str());
  const int components = array->GetNumberOfComponents();
  const auto replace = [=](vtkDataArray* other, int width, vtkIdType tuples)
  {
    const vtkSmartPointer<vtkDataArray> kept = other;
    return [=](vtkPolyData* body)
    {
      kept->SetName(name.c_str());
      kept->SetNumberOfComponents(width);
      kept->SetNumberOfTuples(tuples);
      kept->Fill(0.0);
      body->GetPointData()->AddArray(kept);
    };
  };
  const std::string quoted = "'" + name + "'";
  expectError(
    good, replace(vtkNew<vtkDoubleArray>(), components, 9), { quoted.c_str(), "is double" });
  vtkSmartPointer<vtkDataArray> wide;
  wide.TakeReference(good->GetPointData()->GetArray(name.c_str())->NewInstance());
  expectError(good, replace(wide, components + 1, 9),
    { quoted.c_str(), (std::to_string(components + 1) + " components").c_str() });
  vtkSmartPointer<vtkDataArray> brief;
  brief.TakeReference(wide->NewInstance());
  expectError(good, replace(brief, components, 8), { quoted.c_str(), "8 tuples" });
}

Spoil setNumber(const char* name, double value)
{
  return [=](vtkPolyData* body) { body->GetFieldData()->GetArray(name)->SetTuple1(0, value); };
}

Spoil dropField(const char* name)
{
  return [=](vtkPolyData* body) { body->GetFieldData()->RemoveArray(name); };
}

void checkFieldArrays(const Body& good)
{
  expectError(good, dropField("ResponseExponent"), { "'ResponseExponent'", "missing" });
  expectError(good, dropField("ResponseSamples"), { "'ResponseSamples'", "missing" });
  for (const auto& [value, text] :
    { std::pair{ 0.0, "is 0" }, { 50.0, "50" }, { NotANumber, "nan" } })
  {
    expectError(good, setNumber("ResponseExponent", value), { "'ResponseExponent'", text });
  }
  for (const auto& [value, text] : { std::pair{ 1.0, "is 1" }, { 1e6, "1e+06" } })
  {
    expectError(good, setNumber("ResponseSamples", value), { "'ResponseSamples'", text });
  }
}

void checkCompact()
{
  const Body good = compactBody();
  checkFieldArrays(good);
  checkPointArray(good, "ResponseCoefficient");
  checkPointArray(good, "ResponseNormal");
  expectError(good, setNumber("ResponseSamples", 7), { "'ResponseBasis'", "14", "16" });
  // Without the basis the response counts as one curve per point, whose forces are missing.
  expectError(good, dropField("ResponseBasis"), { "'ResponseForce' is missing" });
  const auto resize = [](int components, vtkIdType tuples)
  {
    return [=](vtkPolyData* body)
    {
      auto* basis = vtkFloatArray::SafeDownCast(body->GetFieldData()->GetArray("ResponseBasis"));
      basis->SetNumberOfComponents(components);
      basis->SetNumberOfTuples(tuples);
    };
  };
  expectError(good, resize(16, 0), { "'ResponseBasis'", "no law" });
  expectError(good, resize(8, 2), { "'ResponseBasis'", "16 components", "8 components" });
  expectError(good, resize(16, 2), { "'ResponseCoefficient'", "2 components" });
}
} // namespace

int TestBrokenResponse(int, char*[])
{
  const Body good = goodBody();
  for (const char* suffix : { "Force", "Stiffness", "Normal", "Range", "Status" })
  {
    checkPointArray(good, std::string("Response") + suffix);
  }
  checkFieldArrays(good);
  expectError(good, setNumber("ResponseSamples", 7), { "'ResponseForce'", "7 components" });
  checkCompact();
  // A body without any response, and a body whose response has another name.
  expectError(good,
    [](vtkPolyData* body)
    {
      body->GetPointData()->Initialize();
      body->GetFieldData()->Initialize();
    },
    { "no response 'Response'" });
  expectError(good,
    [](vtkPolyData* body) {
      body->GetPolys()->InsertNextCell({ 0, 1, 4, 3 });
    },
    { "vtkTriangleFilter" });
  return palpate::testing::result();
}
