// SPDX-License-Identifier: BSD-3-Clause
// The displacement field under one tip: the closed form of the tool on planes and spheres.
#include "FilterChecks.h"
#include "ProbedTips.h"

#include "vtkAppendPolyData.h"
#include "vtkToolContactProbe.h"

namespace
{
using namespace palpate::testing;

/// On a plane the distance from the contact is straight. The contact is from the probe.
void checkPlane(const char* specification)
{
  constexpr double Depth = 0.8;
  const double contact[2] = { 0.13, -0.21 };
  const Body body = withResponse(planeBody(8.0, 64), specification);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(body);
  Body tip = Body::New();
  tip->SetPoints(vtkNew<vtkPoints>());
  tip->GetPoints()->SetDataTypeToDouble();
  tip->GetPoints()->InsertNextPoint(contact[0], contact[1], -Depth);
  probe->SetTipData(tip);
  const auto tool = makeTool(specification);
  auto filter = makeFilter(body, nullptr, nullptr); // the tool of the response is used
  filter->SetTipConnection(probe->GetOutputPort());
  filter->Update();
  int inside = 0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double x = body->GetPoint(i)[0] - contact[0];
    const double y = body->GetPoint(i)[1] - contact[1];
    const double r = std::hypot(x, y);
    double u[2];
    tool->GetSurfaceDisplacement(r, Depth, Poisson, u);
    inside += r < tool->GetContactRadius(Depth);
    const auto found = displacement(filter, i);
    // Stored as floats: 6e-8 of the largest displacement.
    PALPATE_CHECK_NEAR(found[0], u[0] * x / r, 6e-8 * Depth);
    PALPATE_CHECK_NEAR(found[1], u[0] * y / r, 6e-8 * Depth);
    PALPATE_CHECK_NEAR(found[2], -u[1], 6e-8 * Depth);
  }
  PALPATE_CHECK(inside > 4);
}

/// On a sphere the distance from the contact is the arc Rθ. The field ends at 60°.
void checkSphere()
{
  constexpr double Radius = 20.0;
  constexpr double Depth = 0.6;
  const Body body = sphereBody(Radius, 4);
  const auto tool = makeTool("sphere:5");
  double pole[3];
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(0, corners);
  body->GetPoint(corners->GetId(0), pole);
  const double n[3] = { pole[0] / Radius, pole[1] / Radius, pole[2] / Radius };
  auto filter = makeFilter(
    body, makeTips({ { 0, Depth, { pole[0], pole[1], pole[2] }, { n[0], n[1], n[2] } } }), tool);
  filter->Update();
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double* x = body->GetPoint(i);
    const double angle = std::acos(std::min(1.0, vtkMath::Dot(x, n) / Radius));
    const double degrees = vtkMath::DegreesFromRadians(angle);
    const auto found = displacement(filter, i);
    if (degrees > 61.0)
    {
      PALPATE_CHECK(isZero(found));
    }
    if (degrees > 59.0)
    {
      continue; // near 60° the field depends on the normals of the mesh
    }
    double u[2];
    tool->GetSurfaceDisplacement(Radius * angle, Depth, Poisson, u);
    // u_z is along the contact normal, u_r along the tangent of the sphere away from the contact.
    double away[3];
    for (int c = 0; c < 3; ++c)
    {
      away[c] = angle > 0.0 ? (x[c] / Radius * std::cos(angle) - n[c]) / std::sin(angle) : 0.0;
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      // Angle-weighted normals of this mesh (h = 1.4 mm) have an error of at most h²/R² /10 = 5e-4
      // rad, which rotates the arc and the tangent by the same angle.
      PALPATE_CHECK_NEAR(found[c], u[0] * away[c] - u[1] * n[c], 5e-4 * Depth);
    }
  }
}

/// Points near the contact do not move if they are on another component of the surface.
void checkComponents()
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(planeBody(8.0, 16));
  both->AddInputData(planeBody(8.0, 16, -0.01));
  both->Update();
  auto filter = makeFilter(both->GetOutput(),
    makeTips({ { 0, 0.5, { -8.0, -8.0, 0.0 }, { 0.0, 0.0, 1.0 } } }), makeTool("sphere:5"));
  filter->Update();
  const vtkIdType half = both->GetOutput()->GetNumberOfPoints() / 2;
  for (vtkIdType i = 0; i < 2 * half; ++i)
  {
    PALPATE_CHECK(isZero(displacement(filter, i)) == (i >= half));
  }
}

} // namespace

int TestContactDeflection(int, char*[])
{
  for (const char* tool : { "flat:1.5", "paraboloid:5", "sphere:5", "cone:60" })
  {
    checkPlane(tool);
  }
  checkSphere();
  checkComponents();
  return palpate::testing::result();
}
