// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelBody.h"

#include "Mechanics/Checked.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "SolidResponse/Bodies/ChosenSpacing.h"
#include "SolidResponse/Bodies/ClosedSurface.h"
#include "SolidResponse/Bodies/ClosestPlace.h"
#include "Response/FilterStage.h"
#include "SolidResponse/Bodies/VoxelGrid.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkFeatureEdges.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSelectEnclosedPoints.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
/// Depth of the core below the surface, in spacings. The layer of hexahedra fills this gap.
constexpr double LayerDepth = 0.4;

/// Edges of the surface with a larger dihedral angle than this are kept, degrees.
constexpr double SharpAngle = 45.0;

/// Longest outward search for the surface, relative to the distance of the closest point. The ratio
/// is √3 at a corner.
constexpr double LongestReach = 1.75;
/// Peak memory of the filter, measured on a filled box and on a ball.
constexpr double BytesPerGridPoint = 40.0;
constexpr double BytesPerVoxel = 310.0;
/// Largest number of grid points. It is well within the range of 32 bits.
constexpr double MostGridPoints = std::numeric_limits<std::int32_t>::max() / 8.0;

/// Tolerance of the intersection with a line, relative to the spacing. With a tolerance of 0,
/// vtkStaticCellLocator misses faces at the borders of its bins.
constexpr double PickTolerance = 1e-6;

/// Returns the number of voxels along each side of a box. The numbers are doubles, because they may
/// exceed the range of int.
Eigen::Array3d voxelsAlong(const vtkBoundingBox& box, double spacing)
{
  Eigen::Array3d voxels;
  for (int axis = 0; axis < 3; ++axis)
  {
    voxels[axis] = std::max(1.0, std::round(box.GetLength(axis) / spacing));
  }
  return voxels;
}

palpate::VoxelGrid gridOver(const vtkBoundingBox& box, const Eigen::Array3d& voxels)
{
  palpate::VoxelGrid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(voxels[axis]);
    grid.origin[axis] = box.GetBound(2 * axis);
    grid.spacing[axis] = box.GetLength(axis) / voxels[axis];
  }
  return grid;
}
} // namespace

vtkStandardNewMacro(vtkVoxelBody);

int vtkVoxelBody::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkVoxelBody::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  this->UsedSpacing = 0.0;
  if (!(this->Spacing >= 0.0 && std::isfinite(this->Spacing)))
  {
    vtkErrorMacro(<< "Spacing must be 0 or positive, and finite (mm), but is " << this->Spacing
                  << ".");
    return 0;
  }
  palpate::HeldFaces faces{};
  palpate::ClosedSurface closed;
  double spacing = this->Spacing;
  std::string fault = palpate::firstFault([&] { return palpate::takeClosedSurface(body, closed); },
    [&]
    {
      spacing = spacing > 0.0 ? spacing : palpate::chosenVoxel(closed.volume);
      return palpate::readHeldFaces(this->FixedFaces, 0.5 * spacing, faces);
    });
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  this->UsedSpacing = spacing;
  vtkPolyData* surface = closed.surface;
  const vtkBoundingBox box(surface->GetBounds());
  const Eigen::Array3d voxels = voxelsAlong(box, spacing);
  const double total = (voxels + 1.0).prod();
  if (!(total < MostGridPoints))
  {
    vtkErrorMacro(<< "Spacing " << spacing << " mm makes " << total
                  << " points of the bounding box: too many.");
    return 0;
  }
  const double voxelTotal = closed.volume / std::pow(spacing, 3);
  const double needed = BytesPerGridPoint * total + BytesPerVoxel * voxelTotal;
  const double available = palpate::availableMemory();
  if (needed > available)
  {
    vtkErrorMacro(<< "Spacing " << spacing << " mm makes " << total
                  << " points of the bounding box and " << voxelTotal
                  << " voxels, which need about " << needed / palpate::Mebibyte << " MiB, but "
                  << available / palpate::Mebibyte << " MiB are available.");
    return 0;
  }
  palpate::VoxelGrid grid = gridOver(box, voxels);

  // Depth of each node of the grid below the surface; negative outside.
  vtkNew<vtkPoints> nodes;
  nodes->SetDataType(VTK_DOUBLE);
  nodes->SetNumberOfPoints(static_cast<vtkIdType>(grid.nodeTotal()));
  for (int k = 0; k <= grid.size[2]; ++k)
  {
    for (int j = 0; j <= grid.size[1]; ++j)
    {
      for (int i = 0; i <= grid.size[0]; ++i)
      {
        nodes->SetPoint(
          static_cast<vtkIdType>(grid.node(i, j, k)), grid.place(i, j, k).eval().data());
      }
    }
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(nodes);
  vtkNew<vtkSelectEnclosedPoints> enclosed;
  enclosed->SetInputData(cloud);
  enclosed->SetSurfaceData(surface);
  enclosed->SetTolerance(1e-9);
  if (!palpate::runWithin(enclosed, { this, 0.0, 0.6 }))
  {
    return 1;
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetFeatureAngle(SharpAngle);
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  const bool isSharp = edges->GetOutput()->GetNumberOfCells() > 0;
  vtkNew<vtkStaticCellLocator> edgeLocator;
  if (isSharp)
  {
    edgeLocator->SetDataSet(edges->GetOutput());
    edgeLocator->BuildLocator();
  }
  // Moves a node to a sharp edge if there is one in the outward direction. Otherwise moves the node
  // to the closest point of the surface.
  const auto reach = [&](const Eigen::Vector3d& x, const Eigen::Vector3d& outward)
  {
    const Eigen::Vector3d near = palpate::closestPlace(locator, x).at;
    Eigen::Vector3d from = x;
    Eigen::Vector3d to = x + LongestReach * (near - x).norm() * outward;
    Eigen::Vector3d at = near;
    Eigen::Vector3d coordinates;
    double along = 0.0;
    int part = 0;
    if (isSharp &&
      locator->IntersectWithLine(from.data(), to.data(), PickTolerance * spacing, along, at.data(),
        coordinates.data(), part))
    {
      const Eigen::Vector3d edge = palpate::closestPlace(edgeLocator, at).at;
      if ((edge - at).norm() < 0.5 * spacing)
      {
        return edge;
      }
    }
    return near;
  };
  std::vector<double> depth(grid.nodeTotal(), -1.0);
  for (std::size_t i = 0; i < depth.size(); ++i)
  {
    if (enclosed->IsInside(static_cast<vtkIdType>(i)))
    {
      Eigen::Vector3d x;
      nodes->GetPoint(static_cast<vtkIdType>(i), x.data());
      depth[i] = (palpate::closestPlace(locator, x).at - x).norm();
    }
  }
  palpate::takeCore(grid, depth, this->Conform ? LayerDepth * grid.spacing.minCoeff() : 0.0);
  palpate::openPinches(grid);
  const std::size_t out = palpate::keepLargestPart(grid);
  palpate::VolumeMesh mesh = palpate::makeVoxelMesh(grid);
  if (mesh.elements.empty())
  {
    vtkErrorMacro(<< "No voxel of " << spacing
                  << " mm lies inside the surface: Spacing is too coarse.");
    return 0;
  }
  if (out > 0)
  {
    vtkWarningMacro(<< out
                    << " voxels are not connected to the others by a face and are left out: are "
                       "there walls thinner than three Spacings?");
  }
  if (this->Conform)
  {
    palpate::coverWithLayer(mesh, grid, reach);
  }
  if (!palpate::FilterStage{ this, 0.6, 1.0 }(0.9))
  {
    return 1;
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(mesh.nodeTotal());
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    points->SetPoint(i, mesh.nodes.col(i).data());
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.elementTotal(), 8 * vtkIdType{ mesh.elementTotal() });
  for (const palpate::VolumeElement& element : mesh.elements)
  {
    std::array<vtkIdType, 8> ids{};
    std::copy_n(element.nodes.begin(), 8, ids.begin());
    cells->InsertNextCell(8, ids.data());
  }
  output->SetPoints(points);
  output->SetCells(VTK_HEXAHEDRON, cells);
  output->GetPointData()->AddArray(palpate::holdFaces(output, faces));
  this->UpdateProgress(1.0);
  return 1;
}

void vtkVoxelBody::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Spacing: " << this->Spacing << " mm\n";
  os << indent << "UsedSpacing: " << this->UsedSpacing << " mm\n";
  os << indent << "FixedFaces: " << this->FixedFaces << "\n";
  os << indent << "Conform: " << (this->Conform ? "on" : "off") << "\n";
}
