// SPDX-License-Identifier: BSD-3-Clause
#ifndef VoxelGrid_h
#define VoxelGrid_h

#include "Solids/FiniteElements/VolumeMesh.h"

#include <array>
#include <functional>
#include <vector>

namespace palpate
{
/// A regular grid over a box, each voxel inside or outside.
struct VoxelGrid
{
  std::array<int, 3> size{}; ///< voxels along each axis
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d spacing = Eigen::Vector3d::Ones();
  std::vector<unsigned char> inside; ///< x fastest

  /// Number of a voxel; of a node.
  std::size_t voxel(int i, int j, int k) const;
  std::size_t node(int i, int j, int k) const;
  std::size_t nodeTotal() const { return this->node(0, 0, this->size[2] + 1); }
  Eigen::Vector3d place(int i, int j, int k) const;
  bool isInside(int i, int j, int k) const;
};

/// Marks as inside the voxels whose eight nodes all lie at least `depth` (mm) inside; `depthOf` by
/// node.
void takeCore(VoxelGrid& grid, const std::vector<double>& depthOf, double depth);

/// Removes voxels until no two touch at an edge or a corner only, nor two holes.
void openPinches(VoxelGrid& grid);

/// Keeps the largest part connected by faces. Returns how many voxels are removed.
std::size_t keepLargestPart(VoxelGrid& grid);

/// The voxels inside as hexahedra.
VolumeMesh makeVoxelMesh(const VoxelGrid& grid);

/**
 * Puts a layer of hexahedra between the mesh and a surface around it: one on each outer face, its
 * far nodes where `reach` puts them, given the near node's position and the mean outward normal of
 * the core's faces there. Where that would spoil a hexahedron - a Jacobian below a twentieth of the
 * voxel's - the far nodes are moved back towards it.
 */
void coverWithLayer(VolumeMesh& mesh, const VoxelGrid& grid,
  const std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>& reach);
} // namespace palpate

#endif
