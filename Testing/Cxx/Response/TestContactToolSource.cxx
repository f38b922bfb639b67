// SPDX-License-Identifier: BSD-3-Clause
// The geometry of a tool: its points are on the profile, its surface is closed with outward
// normals, and it has the stated size.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkCleanPolyData.h"
#include "vtkContactToolSource.h"
#include "vtkFeatureEdges.h"
#include "vtkTriangle.h"

namespace
{
using namespace palpate::testing;

constexpr double Length = 40.0;

struct Case
{
  const char* tool;
  double outer;  // radius of the shaft, mm
  double volume; // mm³, of the ideal tool
};

/// Checks that the points are on the profile, on the shaft or on the lid.
void checkPoints(vtkPolyData* geometry, vtkContactTool* tool, double outer)
{
  // Float coordinates of 40 mm have an error of 2e-6, which on a steep profile is a height of 1e-4.
  constexpr double Rounding = 4e-6;
  for (vtkIdType i = 0; i < geometry->GetNumberOfPoints(); ++i)
  {
    const double* x = geometry->GetPoint(i);
    const double r = std::hypot(x[0], x[1]);
    const double slightly = std::max(0.0, r - Rounding);
    const bool onProfile = x[2] >= tool->GetProfile(slightly) - Rounding &&
      (r + Rounding >= outer || x[2] <= tool->GetProfile(r + Rounding) + Rounding);
    const bool onLid = std::abs(x[2] - Length) <= Rounding;
    PALPATE_CHECK(r <= outer + Rounding && (onProfile || onLid));
  }
}

/// Checks that point normals agree with the winding. Returns the enclosed volume, which is > 0 for
/// outward winding.
double checkNormals(vtkPolyData* geometry)
{
  vtkDataArray* normals = geometry->GetPointData()->GetNormals();
  PALPATE_CHECK(normals != nullptr);
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < geometry->GetNumberOfCells(); ++cell)
  {
    PALPATE_CHECK(geometry->GetCellType(cell) == VTK_TRIANGLE);
    vtkNew<vtkIdList> ids;
    geometry->GetCellPoints(cell, ids);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      geometry->GetPoint(ids->GetId(k), p[k]);
    }
    double facet[3];
    vtkTriangle::ComputeNormal(p[0], p[1], p[2], facet);
    if (vtkTriangle::TriangleArea(p[0], p[1], p[2]) < 1e-6)
    {
      continue; // slivers that the sweep makes on the axis
    }
    for (int k = 0; k < 3; ++k)
    {
      // Normals are split at 30°, so no normal differs by more from its facet.
      PALPATE_CHECK(vtkMath::Dot(facet, normals->GetTuple3(ids->GetId(k))) > std::cos(0.53));
    }
    double cross[3];
    vtkMath::Cross(p[1], p[2], cross);
    volume += vtkMath::Dot(p[0], cross) / 6.0;
  }
  return volume;
}

void checkClosed(vtkPolyData* geometry)
{
  vtkNew<vtkCleanPolyData> merged; // the normals were split along sharp edges
  merged->SetInputData(geometry);
  merged->SetToleranceIsAbsolute(true);
  merged->SetAbsoluteTolerance(1e-5);
  vtkNew<vtkFeatureEdges> border;
  border->SetInputConnection(merged->GetOutputPort());
  border->FeatureEdgesOff();
  border->NonManifoldEdgesOff();
  border->ManifoldEdgesOff();
  border->BoundaryEdgesOn();
  border->Update();
  PALPATE_CHECK(border->GetOutput()->GetNumberOfCells() == 0);
}

void checkShapes()
{
  const double pi = vtkMath::Pi();
  const double cot60 = 1.0 / std::sqrt(3.0);
  const Case cases[] = { { "flat:1.6", 1.6, pi * 1.6 * 1.6 * Length },
    // half a ball and a shaft; the space between a paraboloid or cone and the plane at its tip is
    // 1/2 or 2/3 of a cylinder
    { "sphere:5", 5.0, pi * 25.0 * (Length - 5.0) + 2.0 / 3.0 * pi * 125.0 },
    { "paraboloid:5", 8.0, pi * 64.0 * (Length - 0.5 * 6.4) },
    { "cone:60", 8.0, pi * 64.0 * (Length - 2.0 / 3.0 * 8.0 * cot60) },
    // the volume below a profile f is 2π ∫ f r dr
    { "truncated:1,60", 8.0, pi * 64.0 * Length - 2.0 * pi * cot60 * (511.0 / 3.0 - 63.0 / 2.0) },
    { "blunted:4,60", 8.0,
      // a spherical cap of 4 mm up to r = 2, then the cone, whose apex is 4 (1/sin 60° - 1) below
      // the cap
      pi * 64.0 * Length -
        (2.0 * pi * (2.0 * 4.0 - (64.0 - std::pow(12.0, 1.5)) / 3.0) +
          2.0 * pi * (cot60 * 504.0 / 3.0 - 4.0 * (2.0 / std::sqrt(3.0) - 1.0) * 60.0 / 2.0)) },
    { "rounded:3,4", 8.0,
      // f = (r-3)²/8, with s = r - 3: ∫ s² (s+3) ds / 8 over s = 0..5
      pi * 64.0 * Length - 2.0 * pi * (625.0 / 4.0 + 125.0) / 8.0 },
    { "power:3,0.01", 8.0, pi * 64.0 * Length - 2.0 * pi * 0.01 * std::pow(8.0, 5) / 5.0 },
    { "profile:0,0;2,0.5;6,6.5", 6.0,
      // slope 1/4 up to r = 2, then 3/2
      pi * 36.0 * Length - 2.0 * pi * (0.25 * 8.0 / 3.0 + 1.5 * 208.0 / 3.0 - 2.5 * 32.0 / 2.0) } };
  for (const Case& wanted : cases)
  {
    const auto tool = makeTool(wanted.tool);
    vtkNew<vtkContactToolSource> source;
    Messages messages(source);
    source->SetTool(tool);
    source->SetLength(Length);
    source->Update();
    vtkPolyData* geometry = source->GetOutput();
    PALPATE_CHECK(messages.none() && geometry->GetNumberOfCells() > 64);
    checkPoints(geometry, tool, wanted.outer);
    checkClosed(geometry);
    // 64 facets around the axis have sin(2π/64)/(2π/64) = 0.9984 of the circle's area. The chords
    // of the profile remove up to 1e-3 more from the volume of the tip.
    PALPATE_CHECK_NEAR(checkNormals(geometry) / wanted.volume, 0.9984, 5e-4);
    const double* bounds = geometry->GetBounds();
    PALPATE_CHECK_NEAR(bounds[4], 0.0, 1e-6);
    PALPATE_CHECK_NEAR(bounds[5], Length, 1e-5);
    PALPATE_CHECK_NEAR(bounds[1], wanted.outer, 1e-5);
    PALPATE_CHECK_NEAR(bounds[0], -wanted.outer, 0.002 * wanted.outer);
  }
}

/// Each corner of the profile is a ring of points.
void checkCorners()
{
  const struct
  {
    const char* tool;
    double r;
    double z;
  } corners[] = { { "truncated:1.7,60", 1.7, 0.0 }, { "rounded:1.7,0.4", 1.7, 0.0 },
    { "blunted:3,60", 1.5, 3.0 - std::sqrt(9.0 - 2.25) }, { "profile:0,0;2.3,0.5;6,6", 2.3, 0.5 },
    { "profile:0,0;2.3,0.5;6,6", 6.0, 6.0 } };
  for (const auto& corner : corners)
  {
    const auto tool = makeTool(corner.tool);
    vtkNew<vtkContactToolSource> source;
    source->SetTool(tool);
    source->Update();
    int found = 0;
    for (vtkIdType i = 0; i < source->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const double* x = source->GetOutput()->GetPoint(i);
      found +=
        std::abs(std::hypot(x[0], x[1]) - corner.r) < 1e-5 && std::abs(x[2] - corner.z) < 1e-5 ? 1
                                                                                               : 0;
    }
    PALPATE_CHECK(found >= 64);
  }
}

/// The profile of a steep cone reaches the length before the radius, so its shaft begins lower.
void checkSteep()
{
  const auto tool = makeTool("cone:5");
  vtkNew<vtkContactToolSource> source;
  source->SetTool(tool);
  source->SetLength(Length);
  source->Update();
  const double* bounds = source->GetOutput()->GetBounds();
  PALPATE_CHECK_NEAR(bounds[5], Length, 1e-5);
  PALPATE_CHECK(bounds[1] < Length * std::tan(vtkMath::RadiansFromDegrees(5.0)));
  checkClosed(source->GetOutput());
}

void checkErrors()
{
  vtkNew<vtkContactToolSource> source;
  Messages messages(source);
  source->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Tool");
  const auto tool = makeTool("sphere:5");
  source->SetTool(tool);
  source->SetLength(0.0);
  source->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Length");
  source->SetLength(30.0);
  source->SetMaximumRadius(-1.0);
  source->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Maximum Radius");
  PALPATE_CHECK(source->GetOutput()->GetNumberOfPoints() == 0);
  source->SetMaximumRadius(1e300); // a size as from a body with a damaged coordinate
  source->SetLength(1e300);
  source->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "no surface");
  source->SetLength(30.0);
  source->SetMaximumRadius(8.0);
  source->Update();
  PALPATE_CHECK(messages.none() && source->GetOutput()->GetNumberOfPoints() > 0);
  tool->SetRadius(2.0); // a change of the tool must change the geometry
  source->Update();
  PALPATE_CHECK_NEAR(source->GetOutput()->GetBounds()[1], 2.0, 1e-5);
}
} // namespace

int TestContactToolSource(int, char*[])
{
  checkShapes();
  checkCorners();
  checkSteep();
  checkErrors();
  return palpate::testing::result();
}
