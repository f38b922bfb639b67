// SPDX-License-Identifier: BSD-3-Clause
// Positions and times of the path: depth below the surface, times according to the speeds,
// direction of pressing, smoothing. The body is not modified.
#include "Response/FilterChecks.h"
#include "Response/TestBodies.h"

#include "vtkPressPath.h"

#include "vtkCellArray.h"
#include "vtkVersion.h"

namespace
{
using namespace palpate::testing;

constexpr double Radius = 40.0;
constexpr double Facets = 0.01; // mm and rad, for a sphere of 40 mm with facets of 0.8 mm
/// At its ends the path averages the normals over 4 mm on one side only. The mean place is 2 mm
/// away, which is 0.05 rad.
constexpr double OneSided = 0.05 * 0.05 / 2.0 + Facets * Facets;

struct Path
{
  Body data;
  vtkIdType size;

  explicit Path(vtkPressPath* press)
  {
    press->Update();
    this->data = press->GetOutput();
    this->size = this->data->GetNumberOfPoints();
  }
  double time(vtkIdType i) const
  {
    return this->data->GetPointData()->GetArray("Time")->GetTuple1(i);
  }
  std::array<double, 3> inward(vtkIdType i) const
  {
    std::array<double, 3> direction{};
    this->data->GetPointData()->GetArray("Inward")->GetTuple(i, direction.data());
    return direction;
  }
  std::array<double, 3> point(vtkIdType i) const
  {
    std::array<double, 3> p{};
    this->data->GetPoint(i, p.data());
    return p;
  }
  double height(vtkIdType i) const { return vtkMath::Norm(this->point(i).data()) - Radius; }
};

void checkLine(const Path& path)
{
  PALPATE_CHECK(path.data->GetNumberOfLines() == 1);
  PALPATE_CHECK(path.data->GetLines()->GetCellSize(0) == path.size);
  PALPATE_CHECK(path.data->GetPointData()->GetArray("Time")->GetDataType() == VTK_DOUBLE);
  PALPATE_CHECK(path.data->GetPointData()->GetArray("Inward")->GetDataType() == VTK_DOUBLE);
  for (vtkIdType i = 0; i < path.size; ++i)
  {
    PALPATE_CHECK(path.data->GetCell(0)->GetPointId(static_cast<int>(i)) == i);
    PALPATE_CHECK(i == 0 || path.time(i) >= path.time(i - 1));
    const auto inward = path.inward(i);
    auto outward = path.point(i);
    vtkMath::Normalize(outward.data());
    PALPATE_CHECK_NEAR(vtkMath::Norm(inward.data()), 1.0, 1e-12);
    PALPATE_CHECK_NEAR(vtkMath::Dot(inward.data(), outward.data()), -1.0, OneSided);
  }
}

/// Down, rest, up: from 5 mm above to 1 mm below at 5 mm/s, with two rests of a quarter second.
void checkPress(vtkPolyData* body)
{
  vtkNew<vtkPressPath> press;
  press->SetInputData(body);
  press->AddDirection(0.0, 3.0, 4.0); // of any length
  const Path path(press);
  PALPATE_CHECK(path.size == 5);
  const double heights[5] = { 5.0, -1.0, -1.0, -1.0, 5.0 };
  const double times[5] = { 0.0, 1.2, 1.45, 1.7, 2.9 };
  for (vtkIdType i = 0; i < std::min<vtkIdType>(path.size, 5); ++i)
  {
    PALPATE_CHECK_NEAR(path.height(i), heights[i], Facets);
    PALPATE_CHECK_NEAR(path.time(i), times[i], 1e-12);
    PALPATE_CHECK_NEAR(path.point(i)[0], 0.0, 2.0 * Facets * Radius);
  }
  checkLine(path);

  press->SetDepth(2.5);
  press->SetApproach(10.0);
  press->SetPressSpeed(25.0);
  const Path other(press);
  PALPATE_CHECK_NEAR(other.height(0), 10.0, Facets);
  PALPATE_CHECK_NEAR(other.height(1), -2.5, Facets);
  PALPATE_CHECK_NEAR(other.time(1), 0.5, 1e-12);
  PALPATE_CHECK_NEAR(other.time(4), 1.5, 1e-12);
}

/// A quarter of a great circle, then an eighth, at 20 mm/s.
void checkSlide(vtkPolyData* body)
{
  vtkNew<vtkPressPath> press;
  press->SetInputData(body);
  press->AddDirection(1.0, 0.0, 0.0);
  press->AddDirection(0.0, 1.0, 0.0);
  press->AddDirection(0.0, 1.0, 1.0);
  press->SetSlideSpeed(20.0);
  const Path path(press);
  checkLine(path);
  const vtkIdType steps = 360 + 180;                         // steps of a quarter of a degree
  PALPATE_CHECK(std::abs(path.size - (steps + 1 + 4)) <= 1); // one more if 90° is rounded up
  for (vtkIdType i = 1; i < path.size - 1; ++i)
  {
    PALPATE_CHECK_NEAR(path.height(i), -1.0, Facets);
  }
  const double length = 0.75 * vtkMath::Pi() * Radius;
  const double sliding = path.time(path.size - 3) - path.time(2);
  PALPATE_CHECK_NEAR(sliding, length / 20.0, 0.01);
  PALPATE_CHECK_NEAR(path.time(path.size - 1), 2.9 + sliding, 1e-12);
  // The path goes through directions between the given directions, in their plane, without a
  // detour.
  for (vtkIdType i = 2; i < 360; ++i)
  {
    PALPATE_CHECK_NEAR(path.point(i)[2], 0.0, 3.0 * Facets);
  }
  PALPATE_CHECK_NEAR(
    path.point(path.size - 1)[1], path.point(path.size - 1)[2], 2.0 * Facets * Radius);
}

/// Returns the largest turn of the direction of pressing between neighbouring points, rad.
double largestTurn(const Path& path)
{
  double largest = 0.0;
  for (vtkIdType i = 3; i < path.size - 2; ++i)
  {
    const auto before = path.inward(i - 1);
    const auto after = path.inward(i);
    largest = std::max(largest, vtkMath::AngleBetweenVectors(before.data(), after.data()));
  }
  return largest;
}

void checkSmoothing()
{
  const Body coarse = sphereBody(Radius, 2); // facets of 12 mm, 17° between their normals
  vtkNew<vtkPressPath> press;
  press->SetInputData(coarse);
  press->AddDirection(1.0, 0.1, 0.3);
  press->AddDirection(-0.2, 1.0, 0.3);
  press->SetSmoothingLength(0.0);
  PALPATE_CHECK(largestTurn(Path(press)) > 0.15);
  press->SetSmoothingLength(20.0);
  PALPATE_CHECK(largestTurn(Path(press)) < 0.03);
}
} // namespace

int TestPressPath(int, char*[])
{
  const Body body = sphereBody(Radius, 6);
  Body before = Body::New();
  before->DeepCopy(body);
  const vtkMTimeType time = body->GetMTime();
  checkPress(body);
  checkSlide(body);
  checkSmoothing();
  PALPATE_CHECK(body->GetMTime() == time);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  PALPATE_CHECK(body->GetLinks() == nullptr);
#endif
  PALPATE_CHECK(body->GetPointData()->GetNumberOfArrays() == 0);
  return palpate::testing::result();
}
