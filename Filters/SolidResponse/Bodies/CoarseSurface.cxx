// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/CoarseSurface.h"

#include "Contact/TriangleColumns.h"
#include "Mechanics/SharedWork.h"
#include "Response/BodyConversion.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int Border = 3;    // number of voxels around the body
constexpr double Blur = 0.8; // standard deviation in voxels
} // namespace

vtkSmartPointer<vtkPolyData> coarseSurface(vtkPolyData* body, double voxel)
{
  std::array<double, 6> bounds{};
  body->GetBounds(bounds.data());
  vtkNew<vtkImageData> inside;
  std::array<int, 3> size{};
  std::array<double, 3> origin{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double extent = bounds[2 * axis + 1] - bounds[2 * axis];
    size[axis] = static_cast<int>(std::ceil(extent / voxel)) + 2 * Border;
    origin[axis] = bounds[2 * axis] - Border * voxel;
  }
  inside->SetOrigin(origin.data());
  inside->SetSpacing(voxel, voxel, voxel);
  inside->SetDimensions(size.data());
  inside->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(inside->GetScalarPointer());
  const BodyMesh mesh = makeBodyMesh(body);
  std::vector<TriangleColumns::Corners> triangles;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    const TriangleCorners& corners = mesh.corners(t);
    triangles.push_back({ mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2]) });
  }
  const TriangleColumns columns(std::move(triangles));
  shareWork(static_cast<std::size_t>(inside->GetNumberOfPoints()),
    [&](std::size_t i)
    {
      Eigen::Vector3d place;
      inside->GetPoint(static_cast<vtkIdType>(i), place.data());
      values[i] = columns.crossingsAbove(place) % 2 == 1 ? 1.0F : 0.0F;
    });
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(inside);
  smooth->SetStandardDeviation(Blur);
  smooth->SetRadiusFactor(3.0);
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputConnection(smooth->GetOutputPort());
  surface->SetValue(0, 0.5);
  surface->ComputeNormalsOff();
  surface->ComputeScalarsOff();
  surface->Update();
  return surface->GetOutput();
}
} // namespace palpate
