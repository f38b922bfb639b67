// SPDX-License-Identifier: BSD-3-Clause
// The start position of a touch: on bodies with known flat parts, and its visibility.
#include "FilterChecks.h"
#include "TestBodies.h"
#include "Response/Touch/TouchStart.h"
#include "vtkToolTouch.h"

#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <functional>
#include <limits>

namespace
{
using namespace palpate::testing;
using palpate::Sight;
using palpate::Vector3;

constexpr double Range = 2.0;
const char* const Tool = "sphere:5";
// contact radius of the sphere of 5 mm at half of the range, about sqrt(R d), mm
constexpr double Contact = 2.3;

Vector3 startOf(vtkPolyData* body, const Vector3& towards = Vector3::UnitZ(),
  const Vector3& up = Vector3::UnitY())
{
  Vector3 start(HUGE_VAL, HUGE_VAL, HUGE_VAL);
  PALPATE_CHECK(vtkToolTouch::FindStart(body, "Response", towards.data(), up.data(), start.data()));
  return start;
}

void movePoints(vtkPolyData* body, const std::function<Vector3(const Vector3&)>& to)
{
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    Vector3 x;
    body->GetPoint(i, x.data());
    body->GetPoints()->SetPoint(i, to(x).data());
  }
  body->GetPoints()->Modified();
}

/// A ball of 30 mm with a tail of 60 mm in the direction `tail`, the corner of its bounding box.
Body ballWithTail(const Vector3& tail)
{
  const Body body = sphereBody(30.0, 5);
  movePoints(body,
    [&](const Vector3& x)
    {
      const double along = x.dot(tail.normalized()) / x.norm();
      return Vector3(x * (1.0 + 2.0 * std::exp((along - 1.0) / 0.01)));
    });
  return withResponse(body, Tool, Range);
}

/// The start is on the ball, not on the tail or its root. It is visible and has a normal towards
/// the viewer.
void checkTail()
{
  const Vector3 tail(1.0, 1.0, 1.0);
  const Body body = ballWithTail(tail);
  double bounds[6];
  body->GetBounds(bounds);
  PALPATE_CHECK(bounds[1] > 50.0 && bounds[3] > 50.0 && bounds[5] > 50.0);
  for (const Vector3& towards : { Vector3(0, 0, 1), Vector3(1, 0, 0), Vector3(0, 1, 0),
         Vector3(0, 0, -1), Vector3(1, 1, 1), Vector3(-1, 0.4, 0.3) })
  {
    const Vector3 start = startOf(body, towards, Vector3(0.1, 0.2, 1.0));
    PALPATE_CHECK_NEAR(
      // the facets are up to 0.02 mm inside the ball; the root of the tail is lower there
      start.norm(), 30.0, 0.1);
    const double off = std::acos(start.normalized().dot(tail.normalized()));
    PALPATE_CHECK(off > 0.4); // beyond this angle the tail is lower than 0.1 mm, exp(-8)
    PALPATE_CHECK(start.normalized().dot(towards.normalized()) > 0.5);
    // not at the point nearest to the viewer
    PALPATE_CHECK(start.normalized().dot(towards.normalized()) < 0.99);
  }
}

/// If all places are equivalent, the start is in the middle.
void checkPlane()
{
  const Body plane = planeBody(20.0, 40, 5.0);
  movePoints(plane, [](const Vector3& x) { return Vector3(x + Vector3(70.0, -11.0, 0.0)); });
  const Vector3 start = startOf(withResponse(plane, Tool, Range));
  PALPATE_CHECK_NEAR((start - Vector3(70.0, -11.0, 5.0)).norm(), 0.0, 1e-9);
  // Seen from behind or along the plane nothing is visible. The start is then that of the next
  // direction from which the plane is visible.
  const Body body = withResponse(plane, Tool, Range);
  PALPATE_CHECK_NEAR((startOf(body, { 0, 0, -1 }) - start).norm(), 0.0, 1e-9);
  PALPATE_CHECK_NEAR((startOf(body, { 1, 0, 0 }, { 0, 0, 1 }) - start).norm(), 0.0, 1e-9);
  PALPATE_CHECK_NEAR((startOf(body, { 0, 0, 1 }, { 0, 0, 1 }) - start).norm(), 0.0, 1e-9);
}

/// The start is away from the edges of a box, for any number of triangles.
void checkBox()
{
  for (const int cells : { 1, 16 })
  {
    const Body box = withResponse(boxBody(30.0, 20.0, 10.0, cells), Tool, Range);
    const Vector3 start = startOf(box, { 0.2, -0.3, 1.0 });
    PALPATE_CHECK_NEAR(start.z(), 10.0, 1e-9);
    PALPATE_CHECK(std::abs(start.x()) < 30.0 - 2.0 * Contact);
    PALPATE_CHECK(std::abs(start.y()) < 20.0 - 2.0 * Contact);
  }
}

/// A plane that is rough in the middle: the start is outside the rough part. Only the shape has an
/// effect, because the response states no validity.
void checkRough()
{
  const Body plane = planeBody(30.0, 60);
  movePoints(plane,
    [](const Vector3& x)
    {
      const double bump = std::sin(1.9 * x.x()) * std::sin(1.7 * x.y());
      return x.head<2>().norm() < 12.0 ? Vector3(x + Vector3(0, 0, bump)) : x;
    });
  const Body body = withResponse(plane, Tool, Range);
  body->GetPointData()->RemoveArray("ResponseValidity");
  const Vector3 start = startOf(body);
  PALPATE_CHECK(start.head<2>().norm() > 12.0 + Contact && start.head<2>().norm() < 25.0);
}

/// The start is on the part in front, not on the hidden part.
void checkHidden()
{
  const Body far = planeBody(30.0, 30, 0.0);
  const Body near = planeBody(12.0, 12, 15.0);
  auto both = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (vtkPolyData* part : { far.Get(), near.Get() })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(part->GetPoint(i));
    }
    triangles->Append(part->GetPolys(), first);
  }
  both->SetPoints(points);
  both->SetPolys(triangles);
  const Vector3 start = startOf(withResponse(both, Tool, Range));
  PALPATE_CHECK_NEAR((start - Vector3(0, 0, 15)).norm(), 0.0, 1e-9);
}

/// The start is where the law is valid, and only at points with a response.
void checkResponse()
{
  const Body plane = planeBody(20.0, 40);
  const Body body = withResponse(plane, Tool, Range);
  auto* validity = vtkFloatArray::SafeDownCast(body->GetPointData()->GetArray("ResponseValidity"));
  auto* status =
    vtkUnsignedCharArray::SafeDownCast(body->GetPointData()->GetArray("ResponseStatus"));
  const auto isLeft = [&](vtkIdType i) { return body->GetPoint(i)[0] < 4.0; };
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    validity->SetValue(i, isLeft(i) ? 0.1F : 1.0F);
  }
  const Vector3 valid = startOf(body);
  PALPATE_CHECK(valid.x() >= 4.0 && valid.x() < 8.0);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    validity->SetValue(i, 0.0F); // the same everywhere, so the start is in the middle
  }
  PALPATE_CHECK_NEAR(startOf(body).norm(), 0.0, 1e-9);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    status->SetValue(i, isLeft(i) ? 4 : 0); // 4: out of reach
  }
  PALPATE_CHECK(startOf(body).x() >= 4.0 && startOf(body).x() < 8.0);
  status->FillValue(4);
  double start[3] = { 7.0, 8.0, 9.0 };
  const double towards[3] = { 0.0, 0.0, 1.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  PALPATE_CHECK(!vtkToolTouch::FindStart(body, "Response", towards, up, start));
  PALPATE_CHECK(!vtkToolTouch::FindStart(plane, "Response", towards, up, start));
  PALPATE_CHECK(!vtkToolTouch::FindStart(nullptr, "Response", towards, up, start));
  PALPATE_CHECK(start[0] == 7.0 && start[1] == 8.0 && start[2] == 9.0);
}

/// If a view shows only a part of the body, the start is in the middle of this part, also in
/// perspective. If a view shows nothing, the start is that for the whole body.
void checkSight()
{
  const Body body = withResponse(planeBody(40.0, 80), Tool, Range);
  const auto middleOf = [&](const Sight& sight)
  { return palpate::findTouchStart(body, "Response", sight).point; };
  Sight far;
  far.eye = { 15.0, -8.0, 300.0 };
  far.halfWidth = far.halfHeight = 6.0;
  PALPATE_CHECK_NEAR((middleOf(far) - Vector3(15, -8, 0)).norm(), 0.0, 1e-9);
  Sight near = far;
  near.isNear = true;
  near.halfWidth = near.halfHeight = 0.02;
  PALPATE_CHECK_NEAR((middleOf(near) - Vector3(15, -8, 0)).norm(), 0.0, 1e-9);
  near.halfWidth = near.halfHeight =
    // the whole body is visible; lines of sight differ in perspective, so some places have a better
    // angle
    1.0;
  PALPATE_CHECK_NEAR(middleOf(near).norm(), 0.0, 8.0);
  near.halfWidth = near.halfHeight = 0.02;
  near.towards = Vector3(1.0, 0.0, 0.2).normalized(); // the view direction does not meet the body
  PALPATE_CHECK_NEAR(middleOf(near).norm(), 0.0, 1e-9);
  near.towards = Vector3::UnitZ();
  near.eye.z() = -20.0; // the body is behind the viewer
  PALPATE_CHECK_NEAR(middleOf(near).norm(), 0.0, 1e-9);
}

/// A touch without a position begins at the start position. A position that was set is kept, even
/// 0, 0, 0.
void checkTouch()
{
  const Body body = ballWithTail({ 1.0, 1.0, 1.0 });
  const Vector3 start = startOf(body);
  vtkNew<vtkToolTouch> touch;
  touch->SetInputData(body);
  const auto tip = [&]
  {
    touch->Update();
    double place[3];
    touch->GetOutput(vtkToolTouch::ArrowPort)
      ->GetFieldData()
      ->GetArray("ContactPoint")
      ->GetTuple(0, place);
    return Vector3(place);
  };
  // The tip was pressed along the blended normal, so its projection is slightly shifted on facets.
  PALPATE_CHECK_NEAR((tip() - start).norm(), 0.0, 0.02);
  const Body shifted = ballWithTail({ 1.0, 1.0, 1.0 });
  movePoints(shifted, [](const Vector3& x) { return Vector3(x + Vector3(500, 0, 0)); });
  touch->SetInputData(withResponse(shifted, Tool, Range));
  // the new body has a new start
  PALPATE_CHECK_NEAR((tip() - Vector3(500, 0, 0) - start).norm(), 0.0, 0.02);
  touch->SetInputData(body);
  touch->SetTipPosition(1.0, 2.0, -50.0);
  PALPATE_CHECK(tip().z() < -29.0);
  vtkNew<vtkToolTouch> other;
  other->SetInputData(withResponse(planeBody(20.0, 40, 5.0), Tool, Range));
  other->SetTipPosition(0.0, 0.0, 0.0);
  const vtkMTimeType time = other->GetMTime();
  other->SetTipPosition(0.0, 0.0, 0.0);
  PALPATE_CHECK(other->GetMTime() == time);
}
} // namespace

int TestTouchStart(int, char*[])
{
  checkTail();
  checkPlane();
  checkBox();
  checkRough();
  checkHidden();
  checkResponse();
  checkSight();
  checkTouch();
  return result();
}
