// SPDX-License-Identifier: BSD-3-Clause
#ifndef VoxelGrid_h
#define VoxelGrid_h

#include "Solids/FiniteElements/VolumeMesh.h"

#include <array>
#include <functional>
#include <vector>

namespace palpate
{
/// A regular grid over a box. Each voxel is inside or outside.
struct VoxelGrid
{
  std::array<int, 3> size{}; ///< voxels along each axis
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  std::vector<unsigned char> inside; ///< x varies fastest

  /// Index of a voxel.
  std::size_t voxel(int i, int j, int k) const;
  std::size_t node(int i, int j, int k) const;
  std::size_t nodeTotal() const { return this->node(0, 0, this->size[2] + 1); }
  Eigen::Vector3d place(int i, int j, int k) const;
  bool isInside(int i, int j, int k) const;
};

/// Marks the voxels as inside whose eight nodes are all at least `depth` (mm) inside. `depthOf`:
/// one value per node.
void takeCore(VoxelGrid& grid, const std::vector<double>& depthOf, double depth);

/// Removes voxels until no two voxels and no two holes touch only at an edge or a corner.
void openPinches(VoxelGrid& grid);

/// Keeps the largest part connected by faces. Returns the number of removed voxels.
std::size_t keepLargestPart(VoxelGrid& grid);

/// Makes a hexahedron of each inside voxel.
VolumeMesh makeVoxelMesh(const VoxelGrid& grid);

/**
 * Adds a layer of hexahedra between the mesh and a surface around it, one on each outer face.
 * `reach` returns the place of a far node for the position of the near node and the mean outward
 * normal of the core's faces there. If the Jacobian of a hexahedron would be below a twentieth of
 * that of a voxel, the far nodes of the hexahedron are moved back towards its near nodes.
 */
void coverWithLayer(VolumeMesh& mesh, const VoxelGrid& grid,
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>& reach);
} // namespace palpate

#endif
