// SPDX-License-Identifier: BSD-3-Clause
// The scene of Mahvash and Hayward 2002, section 5: a large triangulated cylinder under flat,
// sphere and cone. Its vertices have the analytical responses of a half-space. Its normals are
// radial.
#include "ViewerScene.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Radius = 50.0; // radius of the cylinder, mm
constexpr double CylinderLength = 160.0;
constexpr double VertexSpacing = 0.6; // distance between vertices, mm

/// Makes a tube along x whose ends are open.
vtkSmartPointer<vtkPolyData> makeTube()
{
  const int around = static_cast<int>(std::lround(2.0 * Pi * Radius / VertexSpacing));
  const int along = static_cast<int>(std::lround(CylinderLength / VertexSpacing));
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i <= along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * Pi * j / around;
      const double y = std::cos(angle);
      const double z = std::sin(angle);
      points->InsertNextPoint(
        CylinderLength * (static_cast<double>(i) / along - 0.5), Radius * y, Radius * z);
      normals->InsertNextTuple3(0.0, y, z);
    }
  }
  vtkNew<vtkCellArray> triangles;
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const vtkIdType a = static_cast<vtkIdType>(i) * around + j;
      const vtkIdType b = static_cast<vtkIdType>(i) * around + (j + 1) % around;
      const vtkIdType c = a + around;
      const vtkIdType d = b + around;
      for (const auto& corners : { std::array<vtkIdType, 3>{ a, b, d }, { a, d, c } })
      {
        triangles->InsertNextCell(3, corners.data());
      }
    }
  }
  auto tube = vtkSmartPointer<vtkPolyData>::New();
  tube->SetPoints(points);
  tube->SetPolys(triangles);
  tube->GetPointData()->SetNormals(normals);
  return tube;
}
} // namespace

std::string makeCylinderScene(const ViewerOptions&, ViewerScene& scene)
{
  scene.title = "Cylinder of radius 50 mm";
  scene.body = makeTube();
  scene.notes = { "The paper gives no dimensions: radius 50 mm and length 160 mm are assumed." };
  scene.poissonRatio = 0.5;
  scene.youngsModulus = 3.45 * (1.0 - 0.25);
  scene.materialSource =
    "rubber, E* = 3.45 MPa (Mahvash and Hayward 2002, section 4.2), incompressible";
  scene.modelReason = "the paper's own choice for a large cylinder; treating the cylinder as flat "
                      "makes a 6.35 mm sphere 3 % too stiff";
  scene.tools = { "flat:1.6", "sphere:6.35", "cone:60" };
  scene.depth = 1.0;
  scene.center = { 0.0, 0.0, 0.0 };
  scene.directions = { { -0.25, -0.3, 1.0 }, { 0.25, 0.3, 1.0 } };
  scene.viewFrom = { 0.35, -0.9, 0.75 };
  scene.sideBySide = true;
  return {};
}
} // namespace palpate
