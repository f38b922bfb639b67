// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/ContactArrow.h"

#include "Mechanics/Numerics/Constants.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int Facets = 32;         // number of facets around the shaft
constexpr double HeadRadius = 1.4; // radius of the head in shaft diameters
constexpr double HeadLength = 3.5;
// Largest length of the head, as a fraction of the length of the arrow.
constexpr double LargestHead = 0.4;

/// A circle at one end of a band of facets, described by its height above the tail, its radius, and
/// the direction of the normal.
struct Ring
{
  double height;
  double radius;
  double outward; // component of the normal away from the axis
  double upward;
};
} // namespace

vtkSmartPointer<vtkPolyData> makeContactArrow(
  const Vector3& tail, const Vector3& way, double thickness)
{
  auto arrow = vtkSmartPointer<vtkPolyData>::New();
  const double length = way.norm();
  if (!(length > 0.0 && std::isfinite(length) && thickness > 0.0))
  {
    return arrow;
  }
  const double head = std::min(HeadLength * thickness, LargestHead * length);
  const double slim = head / (HeadLength * thickness);
  const double shaft = 0.5 * thickness * slim;
  const double wide = HeadRadius * thickness * slim;
  const double side = std::hypot(head, wide);
  const double neck = length - head;
  // Each band has its own two rings, so that the edges of the band remain sharp.
  const std::array<Ring, 8> rings = { { { 0.0, 0.0, 0.0, -1.0 }, { 0.0, shaft, 0.0, -1.0 },
    { 0.0, shaft, 1.0, 0.0 }, { neck, shaft, 1.0, 0.0 }, { neck, shaft, 0.0, -1.0 },
    { neck, wide, 0.0, -1.0 }, { neck, wide, head / side, wide / side },
    { length, 0.0, head / side, wide / side } } };

  const Vector3 axis = way / length;
  const Vector3 first = axis.unitOrthogonal();
  const Vector3 second = axis.cross(first);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> triangles;
  for (std::size_t ring = 0; ring < rings.size(); ++ring)
  {
    for (int i = 0; i < Facets; ++i)
    {
      const double angle = 2.0 * Pi * i / Facets;
      const Vector3 away = std::cos(angle) * first + std::sin(angle) * second;
      const Vector3 point = tail + rings[ring].height * axis + rings[ring].radius * away;
      const Vector3 normal = rings[ring].outward * away + rings[ring].upward * axis;
      points->InsertNextPoint(point.data());
      normals->InsertNextTuple(normal.data());
      if (ring % 2 == 0)
      {
        const auto low = static_cast<vtkIdType>(ring) * Facets;
        const vtkIdType high = low + Facets;
        const vtkIdType next = (i + 1) % Facets;
        triangles->InsertNextCell({ low + i, low + next, high + next });
        triangles->InsertNextCell({ low + i, high + next, high + i });
      }
    }
  }
  arrow->SetPoints(points);
  arrow->SetPolys(triangles);
  arrow->GetPointData()->SetNormals(normals);
  return arrow;
}
} // namespace palpate
