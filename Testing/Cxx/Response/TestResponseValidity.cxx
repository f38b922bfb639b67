// SPDX-License-Identifier: BSD-3-Clause
// Validity and Limit of a response without an ErrorTolerance.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkDataObject.h"

namespace
{
using namespace palpate::testing;

enum LimitCode
{
  None = 0,
  Strain = 1,
  Curvature = 2
};

/// Rounding of depths to floats. The curvature of a sphere is computed from float normals over
/// edges of about R/5: an error of 2 · 6e-8 · 5.
constexpr double DepthRounding = 1e-6;

void expect(vtkPolyData* body, const char* tool, double range, double depth, LimitCode limit)
{
  const Body output = withResponse(body, tool, range);
  vtkDataArray* depths = output->GetPointData()->GetArray("ResponseValidity");
  vtkDataArray* limits = output->GetPointData()->GetArray("ResponseLimit");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    PALPATE_CHECK_NEAR(depths->GetTuple1(i), depth, DepthRounding * depth);
    PALPATE_CHECK(limits->GetTuple1(i) == limit);
  }
}

/// Depth of an exact sphere of radius R with contact radius a (Sneddon 1965).
double sphereDepth(double a, double radius)
{
  return 0.5 * a * std::log((radius + a) / (radius - a));
}

void checkStrain()
{
  Body flat = planeBody(10.0, 3);
  expect(flat, "sphere:5", 2.0, sphereDepth(2.0, 5.0), Strain);
  expect(flat, "sphere:5", 0.5, 0.5, None);
  expect(flat, "paraboloid:5", 2.0, 0.16 * 5.0, Strain); // the contact radius is a² = Rδ
  expect(flat, "flat:1.6", 2.0, 0.4 * 1.6, Strain);      // the strain is δ/a
  expect(flat, "flat:6", 2.0, 2.0, None);
  expect(flat, "cone:60", 2.0, 0.0, Strain); // δ/a = (π/2) cot 60° = 0.9 at any depth
  expect(flat, "cone:80", 2.0, 2.0, None);   // δ/a = 0.28
}

/// On a sphere every edge gives exactly the curvature 1/R: |n_j - n_i| = |x_j - x_i|/R.
void checkCurvature()
{
  for (const double radius : { 3.0, 10.0, 50.0 })
  {
    Body body = sphereBody(radius, 2);
    addRadialNormals(body);
    const double a = 0.2 * radius;
    // The smallest depth counts: contact radius `a` by curvature, the strain limit (0.4 R of the
    // tool), or the range.
    expect(body, "paraboloid:30", 2.0, std::min(2.0, a * a / 30.0),
      a * a / 30.0 < 2.0 ? Curvature : None);
    const double strain = sphereDepth(0.4 * 6.0, 6.0);
    const double curved = a < 6.0 ? sphereDepth(a, 6.0) : 1e9;
    expect(body, "sphere:6", 2.0, std::min(strain, curved), curved < strain ? Curvature : Strain);
    const double slope = 0.5 * vtkMath::Pi() / std::tan(vtkMath::RadiansFromDegrees(80.0));
    expect(body, "cone:80", 2.0, std::min(2.0, slope * a), slope * a < 2.0 ? Curvature : None);
    expect(body, "flat:1", 2.0, a > 1.0 ? 0.4 : 0.0, a > 1.0 ? Strain : Curvature);
  }
}

/// Each point has the largest curvature of its edges. For a cone of 80° the depth is proportional
/// to the radius. Two cylinders of 2 and 1 mm meet in a line with the same normal.
void checkLargestEdge()
{
  constexpr int Lines = 5;
  Body body = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < Lines; ++i)
  {
    const double angle = 0.2 * (i - Lines / 2);
    const double radius = angle < 0.0 ? 2.0 : 1.0;
    for (const double y : { 0.0, 1.0 })
    {
      points->InsertNextPoint(radius * std::sin(angle), y, radius * (std::cos(angle) - 1.0));
      normals->InsertNextTuple3(std::sin(angle), 0.0, std::cos(angle));
    }
    if (i > 0)
    {
      const vtkIdType at = 2 * static_cast<vtkIdType>(i);
      triangles->InsertNextCell({ at - 2, at, at + 1 });
      triangles->InsertNextCell({ at - 2, at + 1, at - 1 });
    }
  }
  body->SetPoints(points);
  body->SetPolys(triangles);
  body->GetPointData()->SetNormals(normals);
  const Body output = withResponse(body, "cone:80", 2.0);
  const double slope = 0.5 * vtkMath::Pi() / std::tan(vtkMath::RadiansFromDegrees(80.0));
  for (vtkIdType i = 0; i < 2 * Lines; ++i)
  {
    // at the common line the larger curvature counts
    const double curvature = i < Lines - 1 ? 0.5 : 1.0;
    const double depth = slope * 0.2 / curvature;
    vtkDataArray* depths = output->GetPointData()->GetArray("ResponseValidity");
    PALPATE_CHECK_NEAR(
      depths->GetTuple1(i), depth, 2.0 * DepthRounding * depth); // rounding of depth and normals
  }
}

/// A hollow limits the depth as a bump does: half of the same sphere, pressed from inside.
void checkHollow()
{
  Body hollow = hollowBody(10.0, 2);
  addRadialNormals(hollow, -1.0);
  expect(hollow, "sphere:6", 2.0, sphereDepth(2.0, 6.0), Curvature);
}

/// Validity is stated as whole deflection, local plus global.
void checkSeries()
{
  Body body = planeBody(10.0, 2);
  pointArray(body, "C", [](vtkIdType i) { return 0.01 * static_cast<double>(i); });
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool("paraboloid:5"));
  filter->SetYoungsModulus(3.45);
  filter->SetPoissonRatio(0.0);
  filter->SetMaximumDeflection(1.0);
  makePlain(filter);
  filter->SetInputArrayToProcess(2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "C");
  filter->Update();
  const double local = 0.8;
  const double force = 4.0 / 3.0 * 3.45 * std::sqrt(5.0) * std::pow(local, 1.5);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double depth = local + 0.01 * static_cast<double>(i) * force;
    vtkPointData* data = filter->GetOutput()->GetPointData();
    PALPATE_CHECK_NEAR(
      data->GetArray("ResponseValidity")->GetTuple1(i), std::min(1.0, depth), DepthRounding);
    PALPATE_CHECK(data->GetArray("ResponseLimit")->GetTuple1(i) == (depth < 1.0 ? Strain : None));
  }
}
} // namespace

int TestResponseValidity(int, char*[])
{
  checkStrain();
  checkCurvature();
  checkLargestEdge();
  checkHollow();
  checkSeries();
  return palpate::testing::result();
}
