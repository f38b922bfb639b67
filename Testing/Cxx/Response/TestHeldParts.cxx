// SPDX-License-Identifier: BSD-3-Clause
// Bodies held to a given depth: vtkGradedBody cuts them exactly at this depth, and a body pressed
// on a separate surface keeps its held parts.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkAppendPolyData.h"
#include "vtkCleanPolyData.h"
#include "vtkElasticContactResponse.h"
#include "vtkGradedBody.h"
#include "vtkLinearExtrusionFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTetra.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using namespace palpate::testing;
using Place = std::array<double, 3>;

constexpr double Rounding = 1e-9; // mm: tolerance for nodes on a plane

vtkSmartPointer<vtkGradedBody> fill(vtkPolyData* body, double spacing, const char* held)
{
  auto filter = vtkSmartPointer<vtkGradedBody>::New();
  filter->SetInputData(body);
  filter->SetSurfaceSpacing(spacing);
  filter->SetFixedFaces(held);
  return filter;
}

Place placeOf(vtkDataSet* data, vtkIdType i)
{
  Place at{};
  data->GetPoint(i, at.data());
  return at;
}

bool isHeld(vtkUnstructuredGrid* grid, vtkIdType i)
{
  return grid->GetPointData()->GetArray("Fixed")->GetTuple1(i) == 7.0;
}

/// Volume of the tetrahedra, taken with straight edges.
double volumeOf(vtkUnstructuredGrid* grid)
{
  double volume = 0.0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    grid->GetCellPoints(c, ids);
    std::array<Place, 4> at{};
    for (int k = 0; k < 4; ++k)
    {
      at[static_cast<std::size_t>(k)] = placeOf(grid, ids->GetId(k));
    }
    volume += vtkTetra::ComputeVolume(at[0].data(), at[1].data(), at[2].data(), at[3].data());
  }
  return volume;
}

Body moved(vtkPolyData* body, double x, double y, double z)
{
  vtkNew<vtkTransform> way;
  way->Translate(x, y, z);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(way);
  filter->SetInputData(body);
  filter->Update();
  return filter->GetOutput();
}

/// A block held at two sides. The free part is exactly the rest of the block, and exactly the
/// points on its cut sides are held.
void checkBlock()
{
  const auto filter = fill(boxBody(6.0, 4.0, 3.0, 2), 2.0, "z-:1,x+:2");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  vtkUnstructuredGrid* grid = filter->GetOutput();
  PALPATE_CHECK_NEAR(volumeOf(grid), 10.0 * 8.0 * 5.0, 1e-6);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Place at = placeOf(grid, i);
    PALPATE_CHECK(at[2] > -2.0 - Rounding && at[0] < 4.0 + Rounding);
    const bool isOnCut = at[2] < -2.0 + Rounding || at[0] > 4.0 - Rounding;
    PALPATE_CHECK(isHeld(grid, i) == isOnCut);
  }
}

/// A body with this profile in x and z, 8 mm long in y.
Body extruded(const std::vector<std::array<double, 2>>& profile)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> outline;
  outline->InsertNextCell(static_cast<int>(profile.size()));
  for (const auto& [x, z] : profile)
  {
    outline->InsertCellPoint(points->InsertNextPoint(x, 0.0, z));
  }
  vtkNew<vtkPolyData> flat;
  flat->SetPoints(points);
  flat->SetPolys(outline);
  vtkNew<vtkTriangleFilter> inTriangles;
  inTriangles->SetInputData(flat);
  vtkNew<vtkLinearExtrusionFilter> along;
  along->SetInputConnection(inTriangles->GetOutputPort());
  along->SetExtrusionTypeToVectorExtrusion();
  along->SetVector(0.0, 8.0, 0.0);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(along->GetOutputPort());
  vtkNew<vtkCleanPolyData> joined;
  joined->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkPolyDataNormals> outward;
  outward->SetInputConnection(joined->GetOutputPort());
  outward->AutoOrientNormalsOn();
  outward->SplittingOff();
  outward->Update();
  return outward->GetOutput();
}

/// A step at the cut, a step half a cell above the cut, and a table whose legs are cut in their
/// middle and directly below its top.
void checkSteps()
{
  const Body step = extruded(
    { { 0.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 1.0 }, { 5.0, 1.0 }, { 5.0, 6.0 }, { 0.0, 6.0 } });
  const Body table = extruded({ { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 3.0 }, { 8.0, 3.0 },
    { 8.0, 0.0 }, { 10.0, 0.0 }, { 10.0, 6.0 }, { 0.0, 6.0 } });
  const auto volumeLeft = [](vtkPolyData* body, const char* held)
  {
    const auto filter = fill(body, 1.0, held);
    Messages messages(filter.Get());
    filter->Update();
    PALPATE_CHECK(messages.none());
    return volumeOf(filter->GetOutput());
  };
  PALPATE_CHECK_NEAR(volumeLeft(step, "z-:1"), 8.0 * 5.0 * 5.0, 1e-6);
  PALPATE_CHECK_NEAR(volumeLeft(step, "z-:0.5"), 8.0 * (5.0 * 5.5 + 5.0 * 0.5), 1e-6);
  PALPATE_CHECK_NEAR(volumeLeft(table, "z-:1"), 8.0 * (10.0 * 3.0 + 2.0 * 2.0 * 2.0), 1e-6);
  PALPATE_CHECK_NEAR(volumeLeft(table, "z-:3"), 8.0 * 10.0 * 3.0, 1e-6);
}

/// A ball: the rim is the circle in which the plane of the cut meets the facets, for any cell size.
void checkBall(double spacing)
{
  constexpr double Radius = 10.0;
  constexpr double Depth = 3.0;
  const auto filter = fill(sphereBody(Radius, 4), spacing, "z-:3");
  filter->Update();
  vtkUnstructuredGrid* grid = filter->GetOutput();
  const double rim = std::sqrt(Depth * (2.0 * Radius - Depth));
  const double facet = 0.02; // mm: distance of the ball's facets, 3.4 degrees wide, from the ball
  double widest = 0.0;
  int onRim = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const Place at = placeOf(grid, i);
    PALPATE_CHECK(at[2] > Depth - Radius - Rounding);
    const bool isOnCut = at[2] < Depth - Radius + Rounding;
    PALPATE_CHECK(isHeld(grid, i) == isOnCut);
    const double away = std::hypot(at[0], at[1]);
    widest = isOnCut ? std::max(widest, away) : widest;
    onRim += isOnCut && away > rim - 2.0 * facet ? 1 : 0;
  }
  PALPATE_CHECK_NEAR(widest, rim, 2.0 * facet);
  // Edges of the cells and their middle nodes are on the rim.
  PALPATE_CHECK(onRim * 0.5 * spacing > 0.8 * 2.0 * vtkMath::Pi() * rim);
  const double whole = 4.0 / 3.0 * vtkMath::Pi() * std::pow(Radius, 3);
  const double cap = vtkMath::Pi() * Depth * Depth * (3.0 * Radius - Depth) / 3.0;
  // Facets of side a remove a²/8R on average. The circle around a facet is at most 0.72 spacings
  // wide.
  const double side = 0.72 * std::sqrt(3.0) * spacing;
  PALPATE_CHECK_NEAR(
    volumeOf(grid) / (whole - cap), 1.0, 3.0 * side * side / (8.0 * Radius * Radius));
}

/// Two balls whose rims are at a distance of a fortieth of a cell.
void checkRimsThatNearlyTouch()
{
  const Body ball = sphereBody(10.0, 4);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(ball);
  both->AddInputData(moved(ball, 20.05, 0.0, 0.0));
  both->Update();
  const auto filter = fill(both->GetOutput(), 2.0, "z-:10");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.errors().empty());
  // the cells are not made smaller
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfCells() < filter->GetCellEstimate());
  // volume of two halves of a ball
  const double exact = 4.0 / 3.0 * vtkMath::Pi() * 1000.0;
  PALPATE_CHECK_NEAR(volumeOf(filter->GetOutput()) / exact, 1.0, 0.03); // error of straight edges
}

/// If no part of the body would be free, the whole body is held, with a warning.
void checkHeldAsAWhole()
{
  const auto filter = fill(boxBody(6.0, 4.0, 3.0, 2), 2.0, "z-:100");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK_TEXT(messages.warnings(), "whole cells", "nothing of the body would be left");
  vtkUnstructuredGrid* grid = filter->GetOutput();
  PALPATE_CHECK(grid->GetNumberOfCells() > 0);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    PALPATE_CHECK(isHeld(grid, i));
  }
}

/// A bonded layer, the part of a block above a cut, against the exact integral equation.
void checkLayer()
{
  constexpr double Height = 4.0;
  const auto filter = fill(boxBody(12.0, 12.0, 3.0, 2), 1.33, "z-:2");
  vtkNew<vtkElasticContactResponse> pressed;
  pressed->SetInputConnection(filter->GetOutputPort());
  pressed->SetYoungsModulus(1.0);
  pressed->SetPoissonRatio(0.45);
  pressed->SetMaximumDeflection(0.6);
  pressed->SetNumberOfSamples(2);
  pressed->SetTool(makeTool("sphere:1.6"));
  Messages messages(pressed.Get()); // captures the warning that the sides have no response
  pressed->Update();
  const auto exact = filterOf(planeBody(30.0, 8), "sphere:1.6", 0.6);
  exact->SetYoungsModulus(1.0);
  exact->SetLayerThickness(Height);
  exact->SetNumberOfSamples(2);
  exact->Update();
  const auto forceAt = [](vtkAlgorithm* from, vtkIdType i)
  {
    return vtkPolyData::SafeDownCast(from->GetOutputDataObject(0))
      ->GetPointData()
      ->GetArray("ResponseForce")
      ->GetComponent(i, 1);
  };
  const double force = forceAt(pressed, pressed->GetOutput()->vtkDataSet::FindPoint(0.0, 0.0, 3.0));
  // error of three cells through the layer
  PALPATE_CHECK_NEAR(force / forceAt(exact, 40), 1.0, 0.01);

  // On the surface of the whole block exactly the points of the part that was cut off are held.
  const Body surface = boxBody(12.0, 12.0, 3.0, 24);
  pressed->SetSurfaceData(surface);
  pressed->Update();
  vtkPointData* felt = pressed->GetOutput()->GetPointData();
  // Contact radius on a half-space: √(1.6 mm · 0.6 mm). On a thin layer it is √2 times as large.
  constexpr double Contact = 0.98;
  int free = 0;
  int ended = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const Place at = placeOf(surface, i);
    const bool isInside = std::abs(at[0]) < 11.5 && std::abs(at[1]) < 11.5 && at[2] > 2.9;
    const bool isOnWall = std::abs(at[1]) < 10.0 && at[0] > 11.9 && at[2] < 1.5;
    const double status = felt->GetArray("ResponseStatus")->GetTuple1(i);
    PALPATE_CHECK((status == 4.0) == (at[2] < -1.0 + Rounding));
    if (isOnWall && at[2] > -1.0 + 1.42 * Contact)
    {
      PALPATE_CHECK_NEAR(felt->GetArray("ResponseRange")->GetTuple1(i), 0.6, 1e-5);
      ++free;
    }
    else if (isOnWall && at[2] > -1.0 + Rounding && at[2] < -1.0 + 0.8 * Contact)
    {
      PALPATE_CHECK(felt->GetArray("ResponseRange")->GetTuple1(i) < 0.6);
      ++ended;
    }
    free += isInside && status == 0.0 ? 1 : 0;
  }
  PALPATE_CHECK(free > 100 && ended > 10);
}
} // namespace

int TestHeldParts(int, char*[])
{
  if (!vtkGradedBody::IsAvailable())
  {
    return palpate::testing::result(); // TestGradedBody reports that the filter is not available
  }
  checkBlock();
  checkSteps();
  checkBall(2.0);
  checkBall(3.5);
  checkRimsThatNearlyTouch();
  checkHeldAsAWhole();
  checkLayer();
  return palpate::testing::result();
}
