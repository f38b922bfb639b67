// SPDX-License-Identifier: BSD-3-Clause
// A response for chosen points: the bits are those of a response for all points. The other points
// have no curve and give no force, and an invalid array is an error.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkToolContactProbe.h"

#include <cmath>
#include <cstring>

namespace
{
using namespace palpate::testing;

constexpr double OutOfReach = 4.0;

bool isChosen(vtkIdType point)
{
  return point % 7 == 3;
}

vtkSmartPointer<vtkToolContactResponse> layeredFilter(vtkPolyData* body)
{
  auto filter = filterOf(body, "sphere:6.35", 1.5);
  filter->SetStrainModelToNeoHooke();
  filter->AutomaticTermsOn();
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Thickness");
  return filter;
}

void choose(vtkToolContactResponse* filter)
{
  filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Pressed");
}

Body layeredBody()
{
  Body body = sphereBody(30.0, 3);
  // Some points are on a half-space. For a thickness of 0.01 mm the law has no result.
  pointArray(
    body, "Thickness", [](vtkIdType i) { return i % 5 == 0 ? 0.0
                                           : i % 11 == 0   ? 0.01
                                                           : 6.0; });
  pointArray<vtkUnsignedCharArray>(
    body, "Pressed", [](vtkIdType i) { return isChosen(i) ? 1 : 0; });
  return body;
}

bool haveSameBits(vtkDataArray* one, vtkDataArray* other, vtkIdType tuple)
{
  const int components = one->GetNumberOfComponents();
  for (int k = 0; k < components; ++k)
  {
    const double a = one->GetComponent(tuple, k);
    const double b = other->GetComponent(tuple, k);
    if (std::memcmp(&a, &b, sizeof a) != 0)
    {
      return false;
    }
  }
  return true;
}

void checkBits()
{
  Body body = layeredBody();
  auto all = layeredFilter(body);
  const Messages ofAll(all.Get());
  all->Update();
  auto some = layeredFilter(body);
  choose(some);
  Messages messages(some.Get());
  some->Update();
  PALPATE_CHECK_TEXT(messages.warnings(), "6 of 642 points have no response");

  vtkPointData* whole = all->GetOutput()->GetPointData();
  vtkPointData* part = some->GetOutput()->GetPointData();
  PALPATE_CHECK(whole->GetNumberOfArrays() == part->GetNumberOfArrays());
  for (int a = 0; a < whole->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* expected = whole->GetArray(a);
    vtkDataArray* found = part->GetArray(expected->GetName());
    for (vtkIdType i = 0; found && i < expected->GetNumberOfTuples(); ++i)
    {
      PALPATE_CHECK(!isChosen(i) || haveSameBits(expected, found, i));
    }
    PALPATE_CHECK(found != nullptr);
  }
  int without = 0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double status = part->GetArray("ResponseStatus")->GetTuple1(i);
    without += isChosen(i) && status != 0.0 ? 1 : 0;
    PALPATE_CHECK(isChosen(i) || status == OutOfReach);
    PALPATE_CHECK(isChosen(i) || part->GetArray("ResponseForce")->GetComponent(i, 7) == 0.0);
    PALPATE_CHECK(isChosen(i) || part->GetArray("ResponseValidity")->GetTuple1(i) == 0.0);
  }
  PALPATE_CHECK(without == 6);
  const auto fieldOf = [](vtkToolContactResponse* filter)
  { return filter->GetOutput()->GetFieldData()->GetArray("ResponseExponent")->GetTuple1(0); };
  PALPATE_CHECK(fieldOf(all) == fieldOf(some));
  PALPATE_CHECK(all->GetTermReason() == some->GetTermReason());
}

/// The probe finds a force on a triangle whose three corners are chosen, and no force if one corner
/// is not chosen.
void checkProbe()
{
  Body plane = planeBody(10.0, 2);
  pointArray<vtkUnsignedCharArray>(
    plane, "Pressed", [&](vtkIdType i) { return plane->GetPoint(i)[0] < 1.0 ? 1 : 0; });
  auto filter = filterOf(plane, "sphere:6.35", 1.0);
  choose(filter);
  Body tips = Body::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-4.0, 1.0, -0.5);
  points->InsertNextPoint(4.0, 1.0, -0.5);
  tips->SetPoints(points);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputConnection(filter->GetOutputPort());
  probe->SetTipData(tips);
  probe->Update();
  vtkDataArray* force = probe->GetOutput()->GetPointData()->GetArray("NormalForce");
  PALPATE_CHECK(force->GetTuple1(0) > 0.01);
  PALPATE_CHECK(force->GetTuple1(1) == 0.0);
}

/// If points have the same position, choosing one of them chooses all.
void checkSplitPoints()
{
  Body sphere = sphereBody(30.0, 2);
  Body split = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType t = 0; t < sphere->GetNumberOfCells(); ++t)
  {
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = points->InsertNextPoint(sphere->GetPoint(sphere->GetCell(t)->GetPointId(k)));
    }
    triangles->InsertNextCell(3, corners);
  }
  split->SetPoints(points);
  split->SetPolys(triangles);
  const vtkIdType last = points->GetNumberOfPoints() - 1;
  double place[3];
  split->GetPoint(last, place);
  pointArray(split, "Pressed", [last](vtkIdType i) { return i == last ? 0.5 : 0.0; });
  auto filter = filterOf(split, "sphere:6.35", 1.0);
  choose(filter);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  vtkPointData* made = filter->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i <= last; ++i)
  {
    const bool isThere = vtkMath::Distance2BetweenPoints(split->GetPoint(i), place) == 0.0;
    PALPATE_CHECK((made->GetArray("ResponseStatus")->GetTuple1(i) == 0.0) == isThere);
    PALPATE_CHECK((made->GetArray("ResponseForce")->GetComponent(i, 7) > 0.0) == isThere);
  }
}

void checkErrors()
{
  Body body = layeredBody();
  auto filter = layeredFilter(body);
  Messages messages(filter.Get());
  filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Chosen");
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(),
    "Pressed Points Array 'Chosen' (array to process 6) is not on the input's points");
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);

  vtkNew<vtkFloatArray> wide;
  wide->SetName("Chosen");
  wide->SetNumberOfComponents(2);
  wide->SetNumberOfTuples(body->GetNumberOfPoints());
  wide->FillValue(1.0F);
  body->GetPointData()->AddArray(wide);
  filter->Modified();
  filter->Update();
  PALPATE_CHECK_TEXT(
    messages.takeErrors(), "Array 'Chosen' must have 1 component and 642 tuples, but has 2");

  // An empty name removes the choice.
  filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "");
  filter->Update();
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK(
    filter->GetOutput()->GetPointData()->GetArray("ResponseStatus")->GetTuple1(1) == 0.0);
}
} // namespace

int TestPressedPoints(int, char*[])
{
  checkBits();
  checkProbe();
  checkSplitPoints();
  checkErrors();
  return result();
}
