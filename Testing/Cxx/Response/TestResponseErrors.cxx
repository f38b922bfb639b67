// SPDX-License-Identifier: BSD-3-Clause
// vtkToolContactResponse with invalid input: the message, the empty output, and a correct result of
// the same filter after the input is corrected.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkDataObject.h"
#include "vtkIdTypeArray.h"
#include "vtkStripper.h"
#include "Mechanics/Numerics/Constants.h"

#include <functional>

namespace
{
using namespace palpate::testing;
using palpate::Infinity;
using palpate::NotANumber;

using Filter = vtkSmartPointer<vtkToolContactResponse>;
using Words = std::initializer_list<const char*>;

Filter makeFilter(vtkPolyData* body)
{
  auto filter = Filter::New();
  filter->SetInputData(body);
  filter->SetTool(makeTool("sphere:5"));
  return filter;
}

/// Requires that the filter works, fails after `spoil` with these words, and works again after
/// `mend`.
void expectError(
  const std::function<void(Filter&)>& spoil, const std::function<void(Filter&)>& mend, Words words)
{
  Filter filter = makeFilter(planeBody(10.0, 2));
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none() && filter->GetOutput()->GetNumberOfPoints() == 9);
  spoil(filter);
  filter->Update();
  checkText(messages.takeErrors(), words, __FILE__, __LINE__);
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  PALPATE_CHECK(filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0);
  mend(filter);
  filter->Update();
  PALPATE_CHECK(messages.none() && filter->GetOutput()->GetNumberOfPoints() == 9);
  PALPATE_CHECK(filter->GetOutput()->GetPointData()->GetArray("ResponseForce") != nullptr);
}

void checkProperties()
{
  for (const auto& [value, text] : { std::pair{ 0.0, "0" }, { -2.5, "-2.5" }, { -1e-6, "-1e-06" },
         { NotANumber, "nan" }, { Infinity, "inf" } })
  {
    const double wrong = value;
    expectError([=](Filter& f) { f->SetYoungsModulus(wrong); },
      [](Filter& f) { f->SetYoungsModulus(0.1); }, { "Young's Modulus", text });
    expectError([=](Filter& f) { f->SetMaximumDeflection(wrong); },
      [](Filter& f) { f->SetMaximumDeflection(2.0); }, { "Maximum Deflection", text });
  }
  expectError([](Filter& f) { f->SetMaximumDeflection(1e-50); }, // too small for a float
    [](Filter& f) { f->SetMaximumDeflection(2.0); }, { "Maximum Deflection", "1e-50" });
  for (const auto& [value, text] : { std::pair{ 0.6, "0.6" }, { 0.501, "0.501" }, { -0.1, "-0.1" },
         { -1e-3, "-0.001" }, { NotANumber, "nan" } })
  {
    const double wrong = value;
    expectError([=](Filter& f) { f->SetPoissonRatio(wrong); },
      [](Filter& f) { f->SetPoissonRatio(0.5); }, { "Poisson's Ratio", text });
  }
  for (const int wrong : { 1, 10000 })
  {
    expectError([=](Filter& f) { f->SetNumberOfSamples(wrong); },
      [](Filter& f) { f->SetNumberOfSamples(2); },
      { "Number Of Samples", "256", std::to_string(wrong).c_str() });
  }
  expectError([](Filter& f) { f->SetResponseName(""); },
    [](Filter& f) { f->SetResponseName("Response"); }, { "Response Name" });
}

void checkTool()
{
  expectError([](Filter& f) { f->SetTool(nullptr); },
    [](Filter& f) { f->SetTool(makeTool("flat:1")); }, { "Tool", "SetTool" });
  const auto tool = makeTool("sphere:5");
  Messages fromTool(tool.Get());
  expectError(
    [&](Filter& f)
    {
      tool->SetRadius(-3.0);
      f->SetTool(tool);
    },
    [&](Filter&) { tool->SetRadius(3.0); }, { "Tool is invalid" });
  PALPATE_CHECK_TEXT(fromTool.errors(), "radius", "-3");
}

void checkArrays()
{
  const auto use = [](vtkAlgorithm* filter, int index) {
    filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Given");
  };
  const auto give = [](Filter& filter, double value, vtkIdType at, int components)
  {
    Body body = planeBody(10.0, 2);
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName("Given");
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(9);
    array->Fill(0.3);
    array->SetComponent(at, 0, value);
    body->GetPointData()->AddArray(array);
    filter->SetInputData(body);
  };
  const auto mend = [give](Filter& filter) { give(filter, 0.3, 0, 1); };
  for (const int index : { 0, 2, 3 })
  {
    const std::string number = std::to_string(index);
    expectError([=](Filter& f) { use(f, index); }, mend, { "'Given'", number.c_str(), "not on" });
    expectError(
      [=](Filter& f)
      {
        use(f, index);
        give(f, 0.3, 0, 3);
      },
      mend, { "'Given'", "1 component", "3" });
    for (const auto& [value, text] : { std::pair{ 0.0, "is 0" }, { -0.7, "-0.7" }, { 0.6, "0.6" },
           { NotANumber, "nan" }, { Infinity, "inf" } })
    {
      const bool positive = value > 0.0 && std::isfinite(value);
      const bool allowed = index == 0 ? positive
        : index == 2                  ? std::isfinite(value)
                                      : value >= 0.0 && value <= 0.5;
      if (!allowed)
      {
        const double wrong = value;
        expectError(
          [=](Filter& f)
          {
            use(f, index);
            give(f, wrong, 7, 1);
          },
          mend, { "'Given'", "point 7", text });
      }
    }
  }
}

void checkCells()
{
  const auto mend = [](Filter& filter) { filter->SetInputData(planeBody(10.0, 2)); };
  const auto spoil = [](const Body& body) { return [body](Filter& f) { f->SetInputData(body); }; };
  Body quads = planeBody(10.0, 2);
  quads->GetPolys()->InsertNextCell({ 0, 1, 4, 3 });
  expectError(spoil(quads), mend, { "triangles", "vtkTriangleFilter" });

  vtkNew<vtkStripper> strips;
  strips->SetInputData(planeBody(10.0, 4));
  strips->Update();
  PALPATE_CHECK(strips->GetOutput()->GetNumberOfStrips() > 0);
  expectError(spoil(strips->GetOutput()), mend, { "strips", "vtkTriangleFilter" });

  Body cloud = planeBody(10.0, 2);
  cloud->SetPolys(vtkNew<vtkCellArray>());
  expectError(spoil(cloud), mend, { "9 points", "no triangles" });

  for (const vtkIdType wrong : { -1, 9, 2000000000 })
  {
    Body lost = planeBody(10.0, 2);
    lost->GetPolys()->InsertNextCell({ 0, 1, wrong });
    expectError(spoil(lost), mend, { "triangle 8", std::to_string(wrong).c_str() });
  }

  // An input without points gives an empty output and no error.
  Filter filter = makeFilter(Body::New());
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none() && filter->GetOutput()->GetNumberOfPoints() == 0);
}

/// Points that cannot have a response get a status and are counted in one warning. The other points
/// get their response.
void checkBadPoints(bool givenNormals)
{
  Body body = planeBody(10.0, 3); // points 0 to 15
  vtkPoints* points = body->GetPoints();
  points->SetPoint(0, NotANumber, 0.0, 0.0);
  points->SetPoint(15, 0.0, Infinity, 0.0);
  const vtkIdType unused = points->InsertNextPoint(0.0, 0.0, 5.0);
  const vtkIdType sliver = points->InsertNextPoint(1.0, 0.0, 5.0);
  const vtkIdType other = points->InsertNextPoint(2.0, 0.0, 5.0);
  body->GetPolys()->InsertNextCell({ sliver, other, sliver });
  body->GetPolys()->InsertNextCell({ sliver, other, other });
  std::map<vtkIdType, int> expected = { { 0, 2 }, { 15, 2 }, { unused, 1 }, { sliver, 1 },
    { other, 1 } };
  if (givenNormals) // these normals differ from those of the triangles and have no effect
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      normals->InsertNextTuple3(0.0, 0.0, i == 6 ? 0.0 : i == 9 ? NotANumber : 1.0);
    }
    body->GetPointData()->SetNormals(normals);
  }
  Filter filter = makeFilter(body);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.errors().empty());
  const std::string summary = std::to_string(expected.size()) + " of 19 points";
  PALPATE_CHECK_TEXT(messages.warnings(), summary.c_str(), "ResponseStatus");
  PALPATE_CHECK(messages.warnings().find("points", messages.warnings().find("points") + 6) ==
    std::string::npos); // all points are combined in one warning
  vtkPointData* data = filter->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const auto bad = expected.find(i);
    PALPATE_CHECK(
      data->GetArray("ResponseStatus")->GetTuple1(i) == (bad == expected.end() ? 0 : bad->second));
    PALPATE_CHECK(
      (data->GetArray("ResponseForce")->GetComponent(i, 0) > 0.0) == (bad == expected.end()));
    PALPATE_CHECK(std::isfinite(data->GetArray("ResponseNormal")->GetComponent(i, 2)));
  }
}
} // namespace

int TestResponseErrors(int, char*[])
{
  checkProperties();
  checkTool();
  checkArrays();
  checkCells();
  checkBadPoints(false);
  checkBadPoints(true);
  return palpate::testing::result();
}
