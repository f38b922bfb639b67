// SPDX-License-Identifier: BSD-3-Clause
// vtkStaticCellLocator with its default settings: buckets of cells, without use of the last result.
#include "TimedMethod.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <cmath>

namespace palpate::benchmarks
{
namespace
{
class VtkStaticPoint
{
public:
  explicit VtkStaticPoint(const testing::Surface& surface)
  {
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(surface.points.size()));
    const double* const xyz = surface.points.front().data();
    std::copy_n(xyz, 3 * surface.points.size(), coordinates->GetPointer(0));
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);

    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(static_cast<vtkIdType>(3 * surface.triangles.size()));
    std::copy_n(
      surface.triangles.front().data(), 3 * surface.triangles.size(), corners->GetPointer(0));
    vtkNew<vtkCellArray> triangles;
    triangles->SetData(3, corners);

    vtkNew<vtkPolyData> body;
    body->SetPoints(points);
    body->SetPolys(triangles);
    this->Locator->SetDataSet(body);
    this->Locator->BuildLocator();
  }

  Vector3 prepare(const Vector3* tips) { return *tips; }
  double operator()(const Vector3& tip)
  {
    Vector3 closest;
    vtkIdType cell = -1;
    int part = 0;
    double squaredDistance = 0.0;
    this->Locator->FindClosestPoint(
      tip.data(), closest.data(), this->Cell, cell, part, squaredDistance);
    return cell < 0 ? std::nan("") : squaredDistance;
  }
  double distance(const Vector3* /*tips*/, double squaredDistance) const
  {
    return std::sqrt(squaredDistance);
  }
  void reset() {}

private:
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};
} // namespace

std::unique_ptr<TimedMethod> makeVtkStaticPoint(const testing::Surface& surface)
{
  return timed<VtkStaticPoint>(surface);
}
} // namespace palpate::benchmarks
