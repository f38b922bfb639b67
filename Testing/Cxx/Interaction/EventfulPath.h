// SPDX-License-Identifier: BSD-3-Clause
// A body, and a trajectory over it in which every event of a contact occurs.
#ifndef palpate_testing_EventfulPath_h
#define palpate_testing_EventfulPath_h

#include "Response/TestBodies.h"
#include "Haptics/Simulation/SimulatedDevice.h"
#include "Contact/TriangleProjection.h"
#include "Haptics/Devices/WorkspaceMapping.h"

#include <cmath>
#include <vector>

namespace palpate::testing
{
constexpr double Rate = 1000.0;    // Hz
constexpr double Duration = 2.5;   // s
constexpr double Radius = 20.0;    // mm; radius of the body
constexpr double Range = 1.0;      // mm; range of the responses
constexpr double BorderAt = -12.0; // mm, z of the opening

/// Returns the triangles whose first corner is above a height, with their points.
inline Body above(vtkPolyData* whole, double height)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  std::vector<vtkIdType> place(static_cast<std::size_t>(whole->GetNumberOfPoints()), -1);
  for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corner = nullptr;
    whole->GetCellPoints(cell, size, corner);
    if (whole->GetPoint(corner[0])[2] <= height)
    {
      continue;
    }
    triangles->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      vtkIdType& id = place[static_cast<std::size_t>(corner[k])];
      id = id < 0 ? points->InsertNextPoint(whole->GetPoint(corner[k])) : id;
      triangles->InsertCellPoint(id);
    }
  }
  auto kept = Body::New();
  kept->SetPoints(points);
  kept->SetPolys(triangles);
  return kept;
}

/// A bumpy ball without its bottom. Modulus and normals differ from point to point.
inline Body openBall()
{
  Body whole = sphereBody(Radius, 4);
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    double x[3];
    whole->GetPoint(i, x);
    vtkMath::MultiplyScalar(x, 1.0 + 0.01 * std::sin(0.5 * x[0]) * std::cos(0.4 * x[1] + x[2]));
    whole->GetPoints()->SetPoint(i, x);
  }
  const Body cut = above(whole, BorderAt);
  pointArray(cut, "E", [](vtkIdType i) { return 0.1 + 0.03 * static_cast<double>(i % 7); });
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(cut);
  filter->SetTool(makeTool("sphere:5"));
  filter->SetMaximumDeflection(Range);
  makePlain(filter);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
  filter->Update();
  Body body = Body::New();
  body->DeepCopy(filter->GetOutput());
  return body;
}

/// Path of the hand, mm: along z to the border and over it, back and forth around the axis, into
/// the body and out.
inline Body handPath()
{
  auto path = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  for (double t = 0.0; t < Duration + 0.005; t += 0.01)
  {
    const double height = 0.3 - std::pow(std::sin(0.5 * vtkMath::Pi() * t / Duration), 4.0);
    const double around = 0.9 * t + 0.05 * std::sin(30.0 * t);
    const double depth = 0.5 + 0.9 * std::sin(8.0 * t - 0.9);
    const double across = std::sqrt(1.0 - height * height);
    const double r = Radius - depth;
    points->InsertNextPoint(
      r * across * std::cos(around), r * across * std::sin(around), r * height);
    time->InsertNextValue(t);
  }
  path->SetPoints(points);
  path->GetPointData()->AddArray(time);
  return path;
}

/// Returns the samples of the simulated device on this path, tick by tick.
inline std::vector<palpate::DeviceSample> samplesOf(vtkPolyData* path)
{
  const palpate::WorkspaceMapping mapping;
  std::vector<palpate::SimulatedDevice::WayPoint> way;
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    palpate::Vector3 position;
    path->GetPoint(i, position.data());
    way.push_back(
      { path->GetPointData()->GetArray("Time")->GetTuple1(i), mapping.toDevice(position) });
  }
  palpate::SimulatedDevice device(way);
  std::vector<palpate::DeviceSample> samples;
  for (int i = 0; i < static_cast<int>(Duration * Rate); ++i)
  {
    samples.push_back(device.read(i * (1.0 / Rate)));
  }
  return samples;
}
} // namespace palpate::testing

#endif
