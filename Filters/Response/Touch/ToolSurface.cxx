// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/ToolSurface.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkRotationalExtrusionFilter.h"
#include "vtkTriangleFilter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
// Approximate number of points of the profile, in addition to its kinks.
constexpr int ProfilePoints = 48;

/// Returns the radius at which the drawn profile ends. It is the radius of the outer wall or, if
/// the profile widens without end, a radius of at most `maximum`.
double outerRadius(const AxisymmetricTool& tool, double maximum, double length)
{
  if (std::isfinite(tool.largestContactRadius()))
  {
    return tool.largestContactRadius();
  }
  double inside = 0.0;
  double outside = maximum;
  const auto fits = [&](double r) { return tool.profile(r) <= 0.9 * length; };
  if (fits(outside))
  {
    return outside;
  }
  for (int i = 0; i < 80; ++i)
  {
    const double middle = 0.5 * (inside + outside);
    (fits(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// Returns the radii at which the profile is drawn: the kinks of the profile, and points between
/// them. The points are denser towards the outer end, because a sphere is steep there.
std::vector<double> drawnRadii(const AxisymmetricTool& tool, double outer)
{
  std::vector<double> ends;
  for (const double kink : tool.kinks())
  {
    if (kink < outer)
    {
      ends.push_back(kink);
    }
  }
  ends.push_back(outer);
  std::vector<double> radii = { 0.0 };
  for (const double end : ends)
  {
    const double begin = radii.back();
    const int count =
      std::max(1, static_cast<int>(std::ceil(ProfilePoints * (end - begin) / outer)));
    for (int i = 1; i < count; ++i)
    {
      radii.push_back(begin + (end - begin) * std::sin(0.5 * Pi * i / count));
    }
    radii.push_back(end);
  }
  return radii;
}
} // namespace

std::string makeToolSurface(
  const AxisymmetricTool& tool, const ToolSurfaceSize& size, vtkPolyData* output)
{
  const double outer = outerRadius(tool, size.maximumRadius, size.length);
  const double top = std::max(size.length, tool.profile(outer) + 1e-3 * size.length);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double r : drawnRadii(tool, outer))
  {
    points->InsertNextPoint(r, 0.0, tool.profile(r));
  }
  points->InsertNextPoint(outer, 0.0, top);
  points->InsertNextPoint(0.0, 0.0, top);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    line->InsertCellPoint(i);
  }
  vtkNew<vtkPolyData> profile;
  profile->SetPoints(points);
  profile->SetLines(line);

  vtkNew<vtkRotationalExtrusionFilter> turn;
  turn->SetInputData(profile);
  turn->SetResolution(size.resolution);
  turn->CappingOff();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(turn->GetOutputPort());
  // The rotational sweep duplicates the points at its start and on the axis. These points are
  // merged, because otherwise the shading shows a seam.
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputConnection(triangles->GetOutputPort());
  merged->ToleranceIsAbsoluteOn();
  merged->SetAbsoluteTolerance(1e-6 * top);
  merged->ConvertPolysToLinesOff();
  merged->ConvertLinesToPointsOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(merged->GetOutputPort());
  normals->SetFeatureAngle(30.0);
  normals->ConsistencyOn();
  normals->AutoOrientNormalsOn();
  normals->Update();
  if (!normals->GetOutput()->GetPointData()->GetNormals())
  {
    return joined("A tool of Length ", size.length, " mm and Maximum Radius ", size.maximumRadius,
      " mm has no surface: these lengths are too far from the size of the tool");
  }
  output->ShallowCopy(normals->GetOutput());
  return {};
}

void standTool(const Vector3& tip, const Vector3& axis, vtkPolyData* surface)
{
  const Eigen::Matrix3d turn =
    Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axis).toRotationMatrix();
  vtkPoints* upright = surface->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(upright->GetNumberOfPoints());
  vtkDataArray* uprightNormals = surface->GetPointData()->GetNormals();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(upright->GetNumberOfPoints());
  for (vtkIdType i = 0; i < upright->GetNumberOfPoints(); ++i)
  {
    Vector3 x;
    upright->GetPoint(i, x.data());
    x = tip + turn * x;
    points->SetPoint(i, x.data());
    uprightNormals->GetTuple(i, x.data());
    x = turn * x;
    normals->SetTuple(i, x.data());
  }
  surface->SetPoints(points);
  surface->GetPointData()->SetNormals(normals);
}
} // namespace palpate
