// SPDX-License-Identifier: BSD-3-Clause
// vtkLayerThickness on scans of known thickness: balls, slabs, plates; dark regions that are not a
// base; errors.
#include "FilterChecks.h"
#include "MadeScan.h"
#include "TestBodies.h"

#include "vtkAppendPolyData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLayerThickness.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace palpate::testing;

/// A tenth of a voxel of 1 mm. Trilinear interpolation rounds off the corners of a blurred edge, by
/// second differences of (Fat - Bone)/Blur per voxel: at most 1/8 of the step in grey per voxel.
constexpr double Tolerance = 0.1;

double length(const double x[3])
{
  return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

vtkSmartPointer<vtkLayerThickness> filterOf(
  vtkPolyData* body, vtkImageData* scan, double smoothing = 0.0)
{
  auto filter = vtkSmartPointer<vtkLayerThickness>::New();
  filter->SetInputData(0, body);
  filter->SetScanData(scan);
  filter->SetSmoothingRadius(smoothing);
  return filter;
}

vtkSmartPointer<vtkDataArray> thicknessOf(vtkLayerThickness* filter)
{
  filter->Update();
  return filter->GetOutput()->GetPointData()->GetArray("LayerThickness");
}

/// Largest difference of the thickness from the expected one.
double worst(vtkDataArray* thickness, double expected)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < thickness->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, std::abs(thickness->GetTuple1(i) - expected));
  }
  return largest;
}

constexpr double Radius = 24.3;

/// A ball of fat in air, with a core of bone.
Grey ballOver(double thickness)
{
  return [thickness](const double x[3])
  {
    const double depth = Radius - length(x);
    return depth < 0.5 * thickness ? edge(depth, Air, Fat) : edge(thickness - depth, Bone, Fat);
  };
}

Body ballBody()
{
  Body body = sphereBody(Radius, 4);
  addRadialNormals(body);
  return body;
}

void testBalls()
{
  const Body body = ballBody();
  for (const double thickness : { 4.0, 7.37, 12.5 })
  {
    const auto scan = scanOf(ballOver(thickness), 30.0);
    PALPATE_CHECK(worst(thicknessOf(filterOf(body, scan)), thickness) < Tolerance);
    PALPATE_CHECK(worst(thicknessOf(filterOf(body, scan, 3.0)), thickness) < Tolerance);
    // Finer voxels with the same blur round the corners of the edge less.
    const auto fine = scanOf(ballOver(thickness), 30.0, 0.5);
    PALPATE_CHECK(worst(thicknessOf(filterOf(body, fine)), thickness) < 0.5 * Tolerance);
  }
  // Without normals they are computed from the facets. Their angle to the normals of the ball is at
  // most half the angle between facets, so the ray is longer by less than 0.1 % of the radius.
  const Body bare = sphereBody(Radius, 4);
  const auto scan = scanOf(ballOver(7.37), 30.0);
  PALPATE_CHECK(worst(thicknessOf(filterOf(bare, scan)), 7.37) < Tolerance + 1e-3 * Radius);
  // All other arrays are passed on, and the input is not changed.
  auto filter = filterOf(body, scan);
  filter->Update();
  PALPATE_CHECK(filter->GetOutput()->GetPointData()->GetArray("Radial") ==
    body->GetPointData()->GetArray("Radial"));
  PALPATE_CHECK(body->GetPointData()->GetArray("LayerThickness") == nullptr);
}

/// Position and orientation of the scan have no effect.
void testPlacement()
{
  const auto scan = scanOf(ballOver(7.37), 30.0);
  vtkNew<vtkTransform> move;
  move->Translate(100.0, -7.0, 12.0);
  move->RotateWXYZ(35.0, 1.0, 2.0, -0.5);
  auto placed = vtkSmartPointer<vtkImageData>::New();
  placed->ShallowCopy(scan);
  double origin[3];
  scan->GetOrigin(origin);
  placed->SetOrigin(move->TransformDoublePoint(origin));
  vtkNew<vtkMatrix3x3> direction;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      direction->SetElement(i, j, move->GetMatrix()->GetElement(i, j));
    }
  }
  placed->SetDirectionMatrix(direction);
  vtkNew<vtkTransformPolyDataFilter> body;
  body->SetInputData(ballBody());
  body->SetTransform(move);
  body->Update();
  PALPATE_CHECK(worst(thicknessOf(filterOf(body->GetOutput(), placed)), 7.37) < Tolerance);

  // The extent of the image does not begin at 0.
  auto shifted = vtkSmartPointer<vtkImageData>::New();
  shifted->ShallowCopy(scan);
  int extent[6];
  scan->GetExtent(extent);
  shifted->SetExtent(
    extent[0] + 5, extent[1] + 5, extent[2] - 3, extent[3] - 3, extent[4], extent[5]);
  shifted->SetOrigin(origin[0] - 5.0, origin[1] + 3.0, origin[2]);
  PALPATE_CHECK(worst(thicknessOf(filterOf(ballBody(), shifted)), 7.37) < Tolerance);
}

/// A filter for the plane z = 0 over tissue; `grey` is a function of the depth.
vtkSmartPointer<vtkLayerThickness> slab(const std::function<double(double)>& grey)
{
  const auto scan =
    scanOf([&grey](const double x[3]) { return x[2] > 0.0 ? Air : grey(-x[2]); }, 30.0);
  return filterOf(planeBody(10.0, 10), scan);
}

void testSlabs()
{
  // Tissue without bone has no base.
  PALPATE_CHECK(worst(thicknessOf(slab([](double) { return Fat; })), 0.0) == 0.0);
  // Fat over muscle over bone: the base is the bone.
  const auto over = [](double bone)
  {
    return [bone](double depth)
    { return depth < 6.0 ? edge(3.0 - depth, Muscle, Fat) : edge(bone - depth, Bone, Muscle); };
  };
  PALPATE_CHECK(worst(thicknessOf(slab(over(9.2))), 9.2) < Tolerance);
  // Bone below the largest search depth has no effect; it is found with a larger search depth.
  auto deep = slab(over(22.0));
  PALPATE_CHECK(worst(thicknessOf(deep), 0.0) == 0.0);
  deep->SetMaximumDepth(24.0);
  PALPATE_CHECK(worst(thicknessOf(deep), 22.0) < Tolerance);
  // Dark regions are no base if they are not half as dark as the tissue above, or not below
  // BaseValue.
  const auto fluid = [](double grey, double tissue)
  { return [=](double depth) { return edge(8.0 - depth, grey, tissue); }; };
  PALPATE_CHECK(worst(thicknessOf(slab(fluid(32.0, Muscle))), 0.0) == 0.0);
  PALPATE_CHECK(worst(thicknessOf(slab(fluid(28.0, Muscle))), 8.0) < Tolerance);
  PALPATE_CHECK(worst(thicknessOf(slab(fluid(38.0, Fat))), 0.0) == 0.0);
  auto brighter = slab(fluid(38.0, Fat));
  brighter->SetBaseValue(50.0);
  PALPATE_CHECK(worst(thicknessOf(brighter), 8.0) < Tolerance);
  // Bone thinner than a voxel is not accepted: the grey value is below BaseValue over 0.8 mm only.
  const auto thin = [](double depth) { return std::min(Fat, 20.0 + 37.5 * std::abs(depth - 8.7)); };
  PALPATE_CHECK(worst(thicknessOf(slab(thin)), 0.0) == 0.0);
}

/// A plate of tissue in air: the dark region behind the plate is not bone.
void testOppositeWall()
{
  constexpr double thickness = 10.0;
  const auto scan = scanOf(
    [](const double x[3]) { return edge(0.5 * thickness - std::abs(x[2]), Air, Fat); }, 30.0);
  const Body front = planeBody(10.0, 10, 0.5 * thickness);
  // the body has only one wall
  PALPATE_CHECK(worst(thicknessOf(filterOf(front, scan)), thickness) < Tolerance);
  vtkNew<vtkTransform> turn;
  turn->RotateX(180.0);
  vtkNew<vtkTransformPolyDataFilter> back;
  back->SetInputData(front);
  back->SetTransform(turn);
  vtkNew<vtkAppendPolyData> plate;
  plate->AddInputData(front);
  plate->AddInputConnection(back->GetOutputPort());
  plate->Update();
  PALPATE_CHECK(worst(thicknessOf(filterOf(plate->GetOutput(), scan)), 0.0) == 0.0);
}

/// A hole in the tissue below a few points, and one in the bone: smoothing replaces their values by
/// those of the other points.
void testSmoothing()
{
  const auto scan = scanOf(
    [](const double x[3])
    {
      const bool hole = std::abs(x[0]) < 1.2 && std::abs(x[1]) < 1.2;
      const bool marrow = std::abs(x[0] - 6.0) < 1.2 && std::abs(x[1]) < 1.2;
      const double depth = -x[2];
      return hole && depth > 3.0 ? Bone : marrow ? Fat : edge(8.0 - depth, Bone, Fat);
    },
    30.0);
  const Body body = planeBody(10.0, 20);
  const auto rough = thicknessOf(filterOf(body, scan));
  double range[2];
  rough->GetRange(range);
  PALPATE_CHECK(range[0] == 0.0); // no base is found in the marrow
  PALPATE_CHECK(worst(rough, 8.0) > 4.0);
  auto smooth = filterOf(body, scan, 3.0);
  PALPATE_CHECK(worst(thicknessOf(smooth), 8.0) < Tolerance);
}

void testThreads()
{
  const auto scan = scanOf(ballOver(7.37), 30.0);
  const Body body = sphereBody(Radius, 5);
  const auto run = [&](int threads)
  {
    auto filter = filterOf(body, scan, 3.0);
    withThreads(threads, [&] { filter->Update(); });
    return filter;
  };
  const auto one = run(1);
  for (const int threads : { 2, 5 })
  {
    const auto many = run(threads);
    const auto a = thicknessOf(one);
    const auto b = thicknessOf(many);
    bool same = true;
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
    {
      same = same && a->GetTuple1(i) == b->GetTuple1(i);
    }
    PALPATE_CHECK(same);
  }
}

/// The error of a filter after a change. There must be no output.
template <class Change>
std::string errorAfter(vtkPolyData* body, vtkImageData* scan, const Change& change)
{
  auto filter = filterOf(body, scan, 3.0);
  change(filter.Get());
  Messages messages(filter);
  filter->Update();
  PALPATE_CHECK(!filter->GetOutput()->GetPointData()->GetArray("LayerThickness"));
  return messages.errors();
}

void testErrors()
{
  const auto scan = scanOf(ballOver(7.37), 30.0, 2.0);
  const Body body = ballBody();
  const auto nothing = [](vtkLayerThickness*) {};
  const double nan = std::numeric_limits<double>::quiet_NaN();

  vtkNew<vtkImageData> bare;
  bare->CopyStructure(scan);
  PALPATE_CHECK_TEXT(errorAfter(body, bare, nothing), "no point scalars");
  PALPATE_CHECK_TEXT(errorAfter(body, scan,
                       [](vtkLayerThickness* filter) {
                         filter->SetInputArrayToProcess(
                           0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nowhere");
                       }),
    "no point scalars");
  vtkNew<vtkImageData> colour;
  colour->SetDimensions(4, 4, 4);
  colour->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  PALPATE_CHECK_TEXT(errorAfter(body, colour, nothing), "3 components");
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(4, 4, 1);
  flat->AllocateScalars(VTK_SHORT, 1);
  PALPATE_CHECK_TEXT(errorAfter(body, flat, nothing), "three dimensions", "4 x 4 x 1");

  const auto with = [&](void (vtkLayerThickness::*set)(double), double value)
  { return errorAfter(body, scan, [=](vtkLayerThickness* filter) { (filter->*set)(value); }); };
  for (const double wrong : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    PALPATE_CHECK_TEXT(with(&vtkLayerThickness::SetMaximumDepth, wrong), "Maximum Depth");
    PALPATE_CHECK_TEXT(with(&vtkLayerThickness::SetEdgeWidth, wrong), "Edge Width");
  }
  PALPATE_CHECK_TEXT(with(&vtkLayerThickness::SetMaximumDepth, 1e9), "Maximum Depth", "too deep");
  PALPATE_CHECK_TEXT(with(&vtkLayerThickness::SetSmoothingRadius, -1.0), "Smoothing Radius", "-1");
  PALPATE_CHECK_TEXT(with(&vtkLayerThickness::SetBaseValue, nan), "BaseValue");

  PALPATE_CHECK_TEXT(
    errorAfter(planeBody(1.0, 2, 500.0), scan, nothing), "outside the scan", "500");
  const Body broken = ballBody();
  broken->GetPoints()->SetPoint(17, 0.0, nan, 0.0);
  broken->GetPoints()->Modified();
  PALPATE_CHECK_TEXT(errorAfter(broken, scan, nothing), "point 17", "not finite");
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(body->GetPoints());
  PALPATE_CHECK_TEXT(errorAfter(cloud, scan, nothing), "triangles");

  vtkNew<vtkPolyData> empty;
  auto filter = filterOf(empty, scan);
  const Messages messages(filter);
  filter->Update();
  PALPATE_CHECK(messages.none() && filter->GetOutput()->GetNumberOfPoints() == 0);
}

/// A ray ends at the border of the scan or at a value that is not finite. In this case no base is
/// found, without an error.
void testEnds()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto scan = scanOf([](const double x[3]) { return edge(x[2] + 8.0, Bone, Fat); }, 30.0);
  PALPATE_CHECK(worst(thicknessOf(filterOf(planeBody(10.0, 4), scan)), 8.0) < Tolerance);
  // The last layer of voxels, at z = -29.7, is dark but too thin to be accepted.
  const auto cut = scanOf([](const double x[3]) { return x[2] < -29.0 ? Bone : Fat; }, 30.0);
  PALPATE_CHECK(worst(thicknessOf(filterOf(planeBody(10.0, 4, -20.0), cut)), 0.0) == 0.0);
  vtkNew<vtkImageData> holed;
  holed->CopyStructure(scan);
  vtkNew<vtkFloatArray> values;
  values->DeepCopy(scan->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < holed->GetNumberOfPoints(); ++i)
  {
    double x[3];
    holed->GetPoint(i, x);
    if (std::abs(x[2] + 4.0) < 0.6)
    {
      values->SetValue(i, static_cast<float>(nan));
    }
  }
  holed->GetPointData()->SetScalars(values);
  PALPATE_CHECK(worst(thicknessOf(filterOf(planeBody(10.0, 4), holed)), 0.0) == 0.0);
}
} // namespace

int TestLayerThickness(int, char*[])
{
  testBalls();
  testPlacement();
  testSlabs();
  testOppositeWall();
  testSmoothing();
  testThreads();
  testErrors();
  testEnds();
  return result();
}
