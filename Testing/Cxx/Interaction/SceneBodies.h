// SPDX-License-Identifier: BSD-3-Clause
// Bodies with responses, and tips in contact with them, for the scenes of the image tests.
#ifndef palpate_testing_SceneBodies_h
#define palpate_testing_SceneBodies_h

#include "Response/TestBodies.h"

#include "vtkPressPath.h"
#include "vtkToolContactProbe.h"

#include <cmath>

namespace palpate::testing
{
/// A sphere of 40 mm with bumps of up to 1.2 mm, points about 0.8 mm apart.
inline Body bumpySphere()
{
  Body body = sphereBody(40.0, 6);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    vtkMath::MultiplyScalar(
      x, 1.0 + 0.03 * std::sin(0.11 * x[0] + 0.5) * std::cos(0.13 * x[1]) * std::sin(0.12 * x[2]));
    body->GetPoints()->SetPoint(i, x);
  }
  return body;
}

/// A tube along x with points about 1 mm apart and exact normals; radius and length in mm.
inline Body tubeBody(double radius, double length)
{
  const int around = static_cast<int>(std::lround(2.0 * vtkMath::Pi() * radius));
  const int along = static_cast<int>(std::lround(length));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> triangles;
  const auto id = [around](int i, int j)
  { return static_cast<vtkIdType>(i) * around + j % around; };
  for (int i = 0; i <= along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * vtkMath::Pi() * j / around;
      const double y = std::cos(angle);
      const double z = std::sin(angle);
      points->InsertNextPoint(
        length * (static_cast<double>(i) / along - 0.5), radius * y, radius * z);
      normals->InsertNextTuple3(0.0, y, z);
      if (i < along)
      {
        triangles->InsertNextCell({ id(i, j), id(i, j + 1), id(i + 1, j + 1) });
        triangles->InsertNextCell({ id(i, j), id(i + 1, j + 1), id(i + 1, j) });
      }
    }
  }
  auto body = Body::New();
  body->SetPoints(points);
  body->SetPolys(triangles);
  body->GetPointData()->SetNormals(normals);
  return body;
}

/// A path that presses at the surface in direction `from`, as seen from the origin, and slides to
/// direction `to`.
inline Body slidePath(
  vtkPolyData* body, const double (&from)[3], const double (&to)[3], double depth)
{
  vtkNew<vtkPressPath> press;
  press->SetInputData(body);
  press->AddDirection(from[0], from[1], from[2]);
  press->AddDirection(to[0], to[1], to[2]);
  press->SetDepth(depth);
  press->Update();
  return press->GetOutput();
}

/// The output of vtkToolContactProbe for the tips.
inline Body probed(vtkPolyData* body, vtkPolyData* tips, const std::string& response = "Response")
{
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(0, body);
  probe->SetTipData(tips);
  probe->SetResponseName(response);
  probe->Update();
  return probe->GetOutput();
}

/// Tip data of one tip.
inline Body singleTip(double x, double y, double z)
{
  vtkNew<vtkPoints> point;
  point->SetDataTypeToDouble();
  point->InsertNextPoint(x, y, z);
  auto tip = Body::New();
  tip->SetPoints(point);
  return tip;
}
} // namespace palpate::testing

#endif
