// SPDX-License-Identifier: BSD-3-Clause
// Extreme bodies in the filters: one triangle, a tool larger than the body, a body of many pieces,
// a position a kilometre from the origin, solids that do not fit in memory.
#include "Mechanics/Numerics/AvailableMemory.h"
#include "FilterChecks.h"
#include "Response/FlatBodyConversion.h"
#include "TestBodies.h"

#include "vtkContactDeflection.h"
#include "vtkContactHistory.h"
#include "vtkContactRegime.h"
#include "vtkDataObject.h"
#include "vtkElasticCompliance.h"
#include "vtkReducedContactResponse.h"
#include "vtkResponseChoice.h"
#include "vtkToolContactProbe.h"
#include "vtkToolTouch.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVoxelBody.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace
{
using namespace palpate::testing;

Body oneTriangle()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(20.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 20.0, 0.0);
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({ 0, 1, 2 });
  auto body = Body::New();
  body->SetPoints(points);
  body->SetPolys(triangle);
  return body;
}

Body tipsAt(std::initializer_list<std::array<double, 3>> places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  auto tips = Body::New();
  tips->SetPoints(points);
  return tips;
}

Body probed(vtkPolyData* body, vtkPolyData* tips)
{
  vtkNew<vtkToolContactProbe> probe;
  Messages messages(probe.Get());
  probe->SetInputData(body);
  probe->SetTipData(tips);
  probe->Update();
  PALPATE_CHECK(messages.none());
  auto copy = Body::New();
  copy->DeepCopy(probe->GetOutput());
  return copy;
}

double valueOf(vtkPolyData* data, const char* name, vtkIdType i, int component = 0)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array ? array->GetComponent(i, component) : std::nan("");
}

/// Runs a filter that must report nothing. Returns true if its output has points or rows.
template <class Filter>
bool runs(Filter* filter)
{
  Messages messages(filter);
  filter->Update();
  PALPATE_CHECK(messages.none());
  vtkDataObject* output = filter->GetOutputDataObject(0);
  return output->GetNumberOfElements(vtkDataObject::POINT) > 0 ||
    output->GetNumberOfElements(vtkDataObject::ROW) > 0;
}

void checkOneTriangle(const std::string& folder)
{
  const Body body = withResponse(oneTriangle(), "paraboloid:5");
  // F = 4/3 E* √R δ^1.5; E* = 3.45 MPa.
  const double force = 4.0 / 3.0 * 3.45 * std::sqrt(5.0) * std::pow(0.5, 1.5);
  const Body tips = probed(body, tipsAt({ { 4.0, 4.0, -0.5 }, { 4.0, 4.0, 0.5 } }));
  PALPATE_CHECK_NEAR(valueOf(tips, "Force", 0, 2), force, 2e-7 * force);
  PALPATE_CHECK(valueOf(tips, "Force", 1, 2) == 0.0);

  vtkNew<vtkContactDeflection> deflection;
  deflection->SetInputData(body);
  deflection->SetTipData(tips);
  deflection->SetTipIndex(0);
  deflection->SetTool(makeTool("paraboloid:5"));
  PALPATE_CHECK(runs(deflection.Get()));
  // At the corners, far outside the contact, u_z is that of a point force, (1-ν²)F/(πEr), to a²/r².
  const double r = std::hypot(4.0, 4.0);
  const double sunk = force / (vtkMath::Pi() * 3.45 * r);
  PALPATE_CHECK_NEAR(
    valueOf(deflection->GetOutput(), "ContactDisplacement", 0, 2), -sunk, 0.05 * sunk);

  vtkNew<vtkContactRegime> regime;
  regime->SetInputData(body);
  regime->SetTool(makeTool("paraboloid:5"));
  regime->SetYoungsModulus(3.45);
  regime->SetPoissonRatio(0.0);
  PALPATE_CHECK(runs(regime.Get()));
  // the index of a half-space is 0
  PALPATE_CHECK_NEAR(valueOf(regime->GetOutput(), "RegimeIndex", 0), 0.0, 1e-5);
  vtkNew<vtkReducedContactResponse> reduced;
  reduced->SetInputData(body);
  PALPATE_CHECK(runs(reduced.Get()));
  const Body again = probed(reduced->GetOutput(), tipsAt({ { 4.0, 4.0, -0.5 } }));
  PALPATE_CHECK_NEAR(
    valueOf(again, "Force", 0, 2), force, 0.01 * force); // tolerance of the reduction
  vtkNew<vtkResponseChoice> choice;
  choice->SetInputData(body);
  PALPATE_CHECK(runs(choice.Get()));
  vtkNew<vtkToolTouch> touch;
  touch->SetInputData(body);
  PALPATE_CHECK(runs(touch.Get()));
  vtkNew<vtkContactHistory> history;
  history->SetInputData(tips);
  PALPATE_CHECK(runs(history.Get()));

  const std::string file = folder + "/one triangle.palpate";
  PALPATE_CHECK(palpate::writeFlatBody(body, "Response", file).empty());
  std::string error;
  const Body read = palpate::readFlatBody(file, "Response", error);
  std::remove(file.c_str());
  PALPATE_CHECK(error.empty() && read && read->GetNumberOfPoints() == 3);

  vtkNew<vtkVoxelBody> voxels; // a triangle encloses no volume
  Messages messages(voxels.Get());
  voxels->SetInputData(oneTriangle());
  voxels->Update();
  PALPATE_CHECK_TEXT(messages.errors(), "not closed");
}

/// Depth of an exact sphere of radius R with contact radius a (Sneddon 1965).
double sphereDepth(double a, double radius)
{
  return 0.5 * a * std::log((radius + a) / (radius - a));
}

/// The force is that of the law of a half-space. Validity ends where the contact circle is as wide
/// as the body.
void checkToolLargerThanBody()
{
  const auto check = [](vtkPolyData* shape, const char* tool, double depth, int limit)
  {
    const Body body = withResponse(shape, tool);
    const vtkIdType top = body->vtkDataSet::FindPoint(0.0, 0.0, 5.0);
    PALPATE_CHECK_NEAR(
      valueOf(body, "ResponseValidity", top), depth, 1e-6 * depth); // stored as float
    PALPATE_CHECK(static_cast<int>(valueOf(body, "ResponseLimit", top)) == limit);
    const Body tips =
      probed(body, tipsAt({ { 0.0, 0.0, 3.5 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, -4.9 } }));
    const double force = makeTool(tool)->GetForce(1.5, 3.45);
    // error of a curve with eight samples
    PALPATE_CHECK_NEAR(valueOf(tips, "NormalForce", 0), force, 5e-4 * force);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      PALPATE_CHECK(std::isfinite(valueOf(tips, "NormalForce", i)));
    }
  };
  enum LimitCode
  {
    None = 0,
    Strain = 1,
    Edge = 5
  };
  const Body cube = boxBody(5.0, 5.0, 5.0, 8);
  check(cube, "sphere:1000", sphereDepth(5.0, 1000.0), Edge);
  check(cube, "paraboloid:1000", 0.025, Edge); // a² = Rδ
  check(cube, "flat:6", 0.0, Edge);
  check(cube, "flat:4", 0.4 * 4.0, Strain);
  check(cube, "paraboloid:5", 0.8, Strain);
  check(
    cube, "cone:89", 5.0 * 0.5 * vtkMath::Pi() * std::tan(vtkMath::RadiansFromDegrees(1.0)), Edge);
  // For a beam the width counts, not the length.
  check(boxBody(50.0, 5.0, 5.0, 8), "paraboloid:1000", 0.025, Edge);
  check(boxBody(50.0, 50.0, 5.0, 8), "paraboloid:1000", 2.0, None); // a = 45 mm
  // A flat tool on a layer has its whole radius at any depth.
  vtkNew<vtkToolContactResponse> layer;
  layer->SetInputData(cube);
  layer->SetTool(makeTool("flat:6"));
  layer->SetLayerThickness(20.0);
  makePlain(layer);
  layer->Update();
  const vtkIdType top = cube->vtkDataSet::FindPoint(0.0, 0.0, 5.0);
  PALPATE_CHECK(valueOf(layer->GetOutput(), "ResponseLimit", top) == Edge);
  PALPATE_CHECK(valueOf(layer->GetOutput(), "ResponseValidity", top) == 0.0);
}

/// 10⁵ triangles without common points: each is a separate body.
void checkManyPieces()
{
  constexpr int Side = 317;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i < Side * Side; ++i)
  {
    const double x = 20.0 * static_cast<double>(i % Side);
    const double y = 20.0 * static_cast<double>(i / Side);
    const double z = 0.01 * static_cast<double>(i % 101);
    points->InsertNextPoint(x, y, z);
    points->InsertNextPoint(x + 9.0, y, z);
    points->InsertNextPoint(x, y + 9.0, z);
    triangles->InsertNextCell({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  vtkNew<vtkPolyData> pieces;
  pieces->SetPoints(points);
  pieces->SetPolys(triangles);
  const Body body = withResponse(pieces, "paraboloid:2");
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < Side * Side; i += 97)
  {
    std::array<double, 3> x{};
    points->GetPoint(3 * i, x.data());
    places->InsertNextPoint(x[0] + 3.0, x[1] + 3.0, x[2] - 0.3);
  }
  vtkNew<vtkPolyData> tips;
  tips->SetPoints(places);
  const Body felt = probed(body, tips);
  const double force = 4.0 / 3.0 * 3.45 * std::sqrt(2.0) * std::pow(0.3, 1.5);
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    PALPATE_CHECK(valueOf(felt, "ContactCell", i) == static_cast<double>(97 * i));
    // Coordinates are floats relative to a centre 3 km away: half a unit in the last place of 2048
    // to 4096 mm is 1.2e-4 mm.
    PALPATE_CHECK_NEAR(valueOf(felt, "Force", i, 2), force, 1.5 * 1.3e-4 / 0.3 * force);
  }
  vtkNew<vtkReducedContactResponse> reduced;
  reduced->SetInputData(body);
  PALPATE_CHECK(runs(reduced.Get()));
  vtkNew<vtkResponseChoice> choice;
  choice->SetInputData(body);
  PALPATE_CHECK(runs(choice.Get()));
}

/// Force on a tip in a ball whose centre is moved by `away` mm along each axis. Points are stored
/// as `type`.
double forceFarAway(double away, int type)
{
  const Body ball = sphereBody(20.0, 3);
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x{};
    ball->GetPoint(i, x.data());
    points->InsertNextPoint(x[0] + away, x[1] - away, x[2] + away);
  }
  vtkNew<vtkPolyData> far;
  far->SetPoints(points);
  far->SetPolys(ball->GetPolys());
  const Body body = withResponse(far, "paraboloid:5");
  const Body felt = probed(body, tipsAt({ { away + 11.0, 11.0 - away, away + 10.9 } }));
  return valueOf(felt, "NormalForce", 0);
}

void checkFarAway()
{
  const double here = forceFarAway(0.0, VTK_DOUBLE);
  PALPATE_CHECK(here > 1.0);
  // The tip is 1 mm deep. Corners have a rounding error of half a unit in the last place of 20 mm
  // as a float, 1e-6 mm, in both bodies; the tip has one of 1e-10 mm.
  PALPATE_CHECK_NEAR(forceFarAway(1e6, VTK_DOUBLE), here, 2.0 * 1.5 * 1.7e-6 * here);
  // Floats have a spacing of 0.0625 mm at this distance. The error of the corners is at most √3/32
  // mm, and it must not be zero.
  const double coarse = forceFarAway(1e6, VTK_FLOAT);
  PALPATE_CHECK_NEAR(coarse, here, 0.085 * here);
  PALPATE_CHECK(std::abs(coarse - here) > 1e-4 * here);
}

/// The input is rejected before anything is built. The message states the required and the
/// available memory.
void checkSolidsTooLarge()
{
  for (const double spacing : { 1e-300, 1e-12, 1e-5, 5e-3 })
  {
    vtkNew<vtkVoxelBody> voxels;
    Messages messages(voxels.Get());
    voxels->SetInputData(boxBody(5.0, 5.0, 5.0, 2));
    voxels->SetSpacing(spacing);
    voxels->Update();
    PALPATE_CHECK_TEXT(messages.errors(), "Spacing", "points of the bounding box", "too many");
    PALPATE_CHECK(voxels->GetOutput()->GetNumberOfCells() == 0);
  }

  // The solid needs one and a half times the available memory at 350 bytes per voxel, or has too
  // many voxels on a large machine.
  const double voxelTotal = 1.5 * palpate::availableMemory() / 350.0;
  vtkNew<vtkVoxelBody> large;
  Messages words(large.Get());
  large->SetInputData(boxBody(5.0, 5.0, 5.0, 2));
  large->SetSpacing(10.0 / std::cbrt(voxelTotal));
  large->Update();
  PALPATE_CHECK_TEXT(words.errors(), "Spacing", "points of the bounding box");
  PALPATE_CHECK_TEXT(words.errors(), voxelTotal < 2e8 ? "MiB are available" : "");

  vtkNew<vtkVoxelBody> voxels;
  voxels->SetInputData(boxBody(5.0, 5.0, 5.0, 2));
  voxels->SetSpacing(1.0);
  vtkNew<vtkElasticCompliance> compliance;
  compliance->SetInputConnection(voxels->GetOutputPort());
  compliance->Update();
  const double needed = compliance->GetMemoryEstimate();
  PALPATE_CHECK(needed > 1.0 && compliance->GetOutput()->GetNumberOfPoints() > 0);
  Messages messages(compliance.Get());
  // Limits near the stated need are checked by the symbolic analysis, much smaller ones by the
  // forecast.
  compliance->SetMemoryLimit(1.01 * needed);
  compliance->Update();
  PALPATE_CHECK(messages.none() && compliance->GetOutput()->GetNumberOfPoints() > 0);
  for (const double limit : { 0.99 * needed, 0.1 * needed })
  {
    compliance->SetMemoryLimit(limit);
    compliance->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), "unknowns", "needs about", "Memory Limit", "MiB");
    PALPATE_CHECK(compliance->GetOutput()->GetNumberOfPoints() == 0);
    PALPATE_CHECK(compliance->GetMemoryEstimate() > limit);
  }
}
} // namespace

int TestExtremeBodies(int argc, char* argv[])
{
  checkOneTriangle(argv[argc - 1]);
  checkToolLargerThanBody();
  checkManyPieces();
  checkFarAway();
  checkSolidsTooLarge();
  return palpate::testing::result();
}
