// SPDX-License-Identifier: BSD-3-Clause
// Faults in the relaxation arrays of a response, or in the relaxation settings of a filter, are
// reported with the array and the number.
#include "FilterChecks.h"
#include "RelaxingPlane.h"

#include "Response/BodyConversion.h"

#include <cmath>
#include <limits>
#include <string>

namespace
{
using namespace palpate::testing;

void checkWrongArrays(vtkPolyData* body)
{
  const Filter all = everything(body);
  all->Update();
  const auto faultWith = [&all](const auto& spoil)
  {
    Body broken = Body::New();
    broken->DeepCopy(all->GetOutput());
    spoil(broken.Get());
    palpate::ResponseArrays arrays;
    std::string error;
    PALPATE_CHECK(!palpate::viewResponse(broken, "Response", arrays, error));
    return error;
  };
  const double nan = std::nan("");
  const auto set = [&](const char* name, vtkIdType tuple, double value)
  {
    return faultWith(
      [&](vtkPolyData* broken)
      {
        vtkDataArray* array = fieldOf(broken, name);
        array = array ? array : broken->GetPointData()->GetArray(name);
        array->SetComponent(tuple, array->GetNumberOfComponents() - 1, value);
      });
  };
  PALPATE_CHECK_TEXT(
    set("ResponseRelaxationStrength", 1, -0.5), "ResponseRelaxationStrength", "value 1", "-0.5");
  PALPATE_CHECK_TEXT(
    set("ResponseRelaxationStrength", 0, nan), "ResponseRelaxationStrength", "nan");
  PALPATE_CHECK_TEXT(set("ResponseRelaxationTime", 1, 0.0), "ResponseRelaxationTime", "value 1",
    "above 0 s", "is 0");
  PALPATE_CHECK_TEXT(set("ResponseRelaxationTime", 0, std::numeric_limits<double>::infinity()),
    "ResponseRelaxationTime", "inf");
  PALPATE_CHECK_TEXT(set("ResponseLocalRelaxation", 3, -0.125), "ResponseLocalRelaxation",
    "relaxation 2 of point 3", "-0.125");
  PALPATE_CHECK_TEXT(
    set("ResponseLocalRelaxation", 5, nan), "ResponseLocalRelaxation", "point 5", "nan");
  PALPATE_CHECK_TEXT(set("ResponseElasticCompliance", 4, -2.0), "ResponseElasticCompliance",
    "point 4", "mm/N", "-2");

  const auto replace = [&](const char* name, int components, vtkIdType tuples)
  {
    return faultWith(
      [&](vtkPolyData* broken)
      {
        vtkNew<vtkDoubleArray> array;
        array->SetName(name);
        array->SetNumberOfComponents(components);
        array->SetNumberOfTuples(tuples);
        array->Fill(1.0);
        vtkFieldData* place = broken->GetPointData()->HasArray(name)
          ? static_cast<vtkFieldData*>(broken->GetPointData())
          : broken->GetFieldData();
        place->AddArray(array);
      });
  };
  PALPATE_CHECK_TEXT(replace("ResponseRelaxationStrength", 1, 5), "ResponseRelaxationStrength",
    "1 to 4 values", "5 tuples");
  PALPATE_CHECK_TEXT(replace("ResponseRelaxationStrength", 1, 0), "ResponseRelaxationStrength",
    "1 to 4 values", "0 tuples");
  PALPATE_CHECK_TEXT(replace("ResponseRelaxationTime", 2, 2), "ResponseRelaxationTime",
    "1 to 4 values", "2 components and 2 tuples");
  PALPATE_CHECK_TEXT(replace("ResponseRelaxationTime", 1, 3), "ResponseRelaxationStrength' has 2",
    "ResponseRelaxationTime' has 3");
  const vtkIdType points = body->GetNumberOfPoints();
  PALPATE_CHECK_TEXT(replace("ResponseLocalRelaxation", 2, points), "ResponseLocalRelaxation",
    "must be float", "double");
  PALPATE_CHECK_TEXT(replace("ResponseElasticCompliance", 1, points), "ResponseElasticCompliance",
    "must be float", "double");
  PALPATE_CHECK_TEXT(faultWith([](vtkPolyData* broken)
                       { broken->GetFieldData()->RemoveArray("ResponseRelaxationTime"); }),
    "ResponseRelaxationTime' of numbers is missing", "ResponseRelaxationStrength' is there");
  PALPATE_CHECK_TEXT(faultWith(
                       [](vtkPolyData* broken)
                       {
                         broken->GetFieldData()->RemoveArray("ResponseRelaxationTime");
                         broken->GetFieldData()->RemoveArray("ResponseRelaxationStrength");
                       }),
    "ResponseRelaxationStrength' of numbers is missing", "ResponseLocalRelaxation' is there");
}

void checkWrongSettings(vtkPolyData* body)
{
  const auto reasonOf = [](vtkToolContactResponse* filter)
  {
    Messages messages(filter);
    filter->Update();
    return messages.errors();
  };
  const Filter negative = filterOf(body, "sphere:5", 1.0);
  negative->AddRelaxation(0.5, 0.1);
  negative->AddRelaxation(-0.5, 0.1);
  PALPATE_CHECK_TEXT(reasonOf(negative), "strength of relaxation 2", "-0.5");
  const Filter timeless = filterOf(body, "sphere:5", 1.0);
  timeless->AddRelaxation(0.5, 0.0);
  PALPATE_CHECK_TEXT(reasonOf(timeless), "time of relaxation 1", "is 0");
  const Filter many = filterOf(body, "sphere:5", 1.0);
  for (int i = 0; i < 5; ++i)
  {
    many->AddRelaxation(0.1, 0.1);
  }
  PALPATE_CHECK_TEXT(reasonOf(many), "at most 4", "5");
  const Filter lonely = filterOf(body, "sphere:5", 1.0);
  lonely->SetInputArrayToProcess(Strengths, 0, 0, 0, "Strengths");
  PALPATE_CHECK_TEXT(reasonOf(lonely), "'Strengths'", "AddRelaxation");
  const Filter narrow = everything(body);
  narrow->SetInputArrayToProcess(Strengths, 0, 0, 0, "GlobalCompliance");
  PALPATE_CHECK_TEXT(
    reasonOf(narrow), "'GlobalCompliance'", "each of the 2 relaxations", "but has 1");
  const Filter missing = everything(body);
  missing->SetInputArrayToProcess(Strengths, 0, 0, 0, "Nowhere");
  PALPATE_CHECK_TEXT(reasonOf(missing), "Relaxation Array 'Nowhere' (array to process 5)");

  Body wrong = Body::New();
  wrong->DeepCopy(body);
  wrong->GetPointData()->GetArray("Strengths")->SetComponent(9, 1, -1.0);
  PALPATE_CHECK_TEXT(reasonOf(everything(wrong)), "'Strengths'", "relaxation 2 of point 9", "-1");
  Body swelling = Body::New();
  swelling->DeepCopy(body);
  swelling->GetPointData()->GetArray("GlobalCompliance")->SetTuple1(6, -0.001);
  PALPATE_CHECK_TEXT(
    reasonOf(everything(swelling)), "'GlobalCompliance'", "point 6", "-0.001", "mm/N");
  const Filter allowed = everything(swelling);
  allowed->ComplianceRelaxesOn();
  PALPATE_CHECK(reasonOf(allowed).empty());
}
} // namespace

int TestRelaxationFaults(int, char*[])
{
  const Body body = bodyWithArrays();
  checkWrongArrays(body);
  checkWrongSettings(body);
  return palpate::testing::result();
}
