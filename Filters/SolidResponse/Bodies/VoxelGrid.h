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
  std::array<int, 3> size{}; ///< number of voxels along each axis
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  std::vector<unsigned char> inside; ///< 1 for each inside voxel, else 0; x varies fastest

  /// Returns the index of a voxel.
  std::size_t voxel(int i, int j, int k) const;
  std::size_t node(int i, int j, int k) const;
  std::size_t nodeTotal() const { return this->node(0, 0, this->size[2] + 1); }
  Eigen::Vector3d place(int i, int j, int k) const;
  bool isInside(int i, int j, int k) const;
};

/// Marks those voxels as inside whose eight nodes are all at least `depth` (mm) below the surface.
/// `depthOf` has one value per node.
void takeCore(VoxelGrid& grid, const std::vector<double>& depthOf, double depth);

/// Removes voxels until no two voxels and no two holes touch only at an edge or a corner.
void openPinches(VoxelGrid& grid);

/// Keeps the largest part that is connected by faces. Returns the number of removed voxels.
std::size_t keepLargestPart(VoxelGrid& grid);

/// Creates a mesh with a hexahedron for each inside voxel.
VolumeMesh makeVoxelMesh(const VoxelGrid& grid);

/**
 * Adds a layer of hexahedra between the mesh and a surface around it, one hexahedron on each outer
 * face. `reach` returns the position of an outer node. Its arguments are the position of the inner
 * node and the mean outward normal of the mesh's faces at the inner node. If the Jacobian of a
 * hexahedron would be below a twentieth of that of a voxel, the outer nodes of the hexahedron are
 * moved back towards its inner nodes.
 */
void coverWithLayer(VolumeMesh& mesh, const VoxelGrid& grid,
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>& reach);
} // namespace palpate

#endif
