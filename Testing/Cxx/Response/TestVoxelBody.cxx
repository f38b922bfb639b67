// SPDX-License-Identifier: BSD-3-Clause
// vtkVoxelBody: volume, conformity, held points, errors. Also the compliance of a body from its
// output.
#include "BoxOnGround.h"
#include "FilterChecks.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkElasticCompliance.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVoxelBody.h"

#include <array>
#include <cmath>

namespace
{
using namespace palpate::testing;

vtkSmartPointer<vtkPolyData> ball(double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(80);
  source->SetPhiResolution(60);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkVoxelBody> makeFilter(vtkPolyData* body, double spacing)
{
  auto filter = vtkSmartPointer<vtkVoxelBody>::New();
  filter->SetInputData(body);
  filter->SetSpacing(spacing);
  return filter;
}

/// Volume inside the grid's outer surface, and the distance of its points from a ball of this
/// radius.
struct Shape
{
  double volume = 0.0;
  double meanDistance = 0.0;
  double edgeShare = 0.0;
};

Shape shapeOf(vtkVoxelBody* voxels, double radius)
{
  vtkNew<vtkElasticCompliance> compliance;
  compliance->SetInputConnection(voxels->GetOutputPort());
  compliance->Update();
  vtkPolyData* surface = compliance->GetOutput();
  Shape shape;
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    std::array<std::array<double, 3>, 3> x{};
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(surface->GetCell(c)->GetPointId(i), x[static_cast<std::size_t>(i)].data());
    }
    shape.volume += (x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) -
                      x[0][1] * (x[1][0] * x[2][2] - x[1][2] * x[2][0]) +
                      x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0])) /
      6.0;
  }
  const auto count = static_cast<double>(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x{};
    surface->GetPoint(i, x.data());
    shape.meanDistance += std::abs(std::hypot(x[0], x[1], x[2]) - radius) / count;
    shape.edgeShare +=
      surface->GetPointData()->GetArray("ComplianceStatus")->GetTuple1(i) == 5 ? 1.0 / count : 0.0;
  }
  return shape;
}

void checkBall()
{
  const double radius = 20.0;
  const double exact = 4.0 / 3.0 * 3.14159265358979 * radius * radius * radius;
  const auto filter = makeFilter(ball(radius), 2.0);
  Messages messages(filter.Get());
  const Shape conforming = shapeOf(filter, radius);
  PALPATE_CHECK(messages.none());
  filter->ConformOff();
  const Shape stairs = shapeOf(filter, radius);
  std::cout << "ball: volume " << conforming.volume / exact << " (stairs " << stairs.volume / exact
            << "), distance " << conforming.meanDistance << " (" << stairs.meanDistance
            << ") mm, edges " << conforming.edgeShare << " (" << stairs.edgeShare << ")"
            << std::endl;
  // the surface is faceted, and the motion of some corners is limited
  PALPATE_CHECK_NEAR(conforming.volume / exact, 1.0, 0.02);
  // only whole voxels, without moved corners
  PALPATE_CHECK(stairs.volume < 0.95 * exact);
  // facets of the 80 × 60 ball are up to 0.03 mm inside it
  PALPATE_CHECK(conforming.meanDistance < 0.02);
  PALPATE_CHECK(conforming.edgeShare < 0.1 && stairs.edgeShare > 0.5);
}

void checkHeld()
{
  const auto filter = makeFilter(boxOnGround(12.0, 8.0, 6.0), 2.0);
  const auto held = [&](const char* faces)
  {
    filter->SetFixedFaces(faces);
    filter->Update();
    vtkUnstructuredGrid* grid = filter->GetOutput();
    int count = 0;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      count += grid->GetPointData()->GetArray("Fixed")->GetTuple1(i) == 7 ? 1 : 0;
    }
    return count;
  };
  // A core of 4 × 2 × 1 voxels and the layer of voxels around it, whose corners are those of the
  // body.
  PALPATE_CHECK(held("z-") == 5 * 3);
  PALPATE_CHECK(held("x+") == 3 * 2);
  PALPATE_CHECK(held("z-, z+") == 2 * 5 * 3);
  PALPATE_CHECK(held("x- y-") == 3 * 2 + 5 * 2 - 2);
  PALPATE_CHECK(held("") == 0);
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfCells() == 8 + 2 * (8 + 4 + 2));
  PALPATE_CHECK(filter->GetOutput()->GetCellType(0) == VTK_HEXAHEDRON);
  for (const double corner : { -6.0, 6.0 })
  {
    const double place[3] = { corner, 4.0, 6.0 };
    const vtkIdType nearest = filter->GetOutput()->vtkDataSet::FindPoint(corner, 4.0, 6.0);
    PALPATE_CHECK(
      vtkMath::Distance2BetweenPoints(filter->GetOutput()->GetPoint(nearest), place) < 1e-18);
  }
}

void checkErrors()
{
  const auto fails = [](vtkPolyData* body, auto&& change, std::initializer_list<const char*> words)
  {
    const auto filter = makeFilter(body, 2.0);
    Messages messages(filter.Get());
    change(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  };
  const auto nothing = [](vtkVoxelBody*) {};
  const auto solid = boxOnGround(12.0, 8.0, 6.0);
  fails(solid, [](auto* f) { f->SetSpacing(-1.0); }, { "Spacing", "-1" });
  fails(solid, [](auto* f) { f->SetFixedFaces("z-,w+"); }, { "Fixed Faces", "w+" });
  vtkNew<vtkSphereSource> open;
  open->SetEndTheta(200.0);
  open->Update();
  fails(open->GetOutput(), nothing, { "not closed" });
}
} // namespace

int TestVoxelBody(int, char*[])
{
  checkBall();
  checkHeld();
  checkErrors();
  return palpate::testing::result();
}
