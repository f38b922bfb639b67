// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VoxelCompliance_h
#define palpate_VoxelCompliance_h

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace palpate
{
/// How a surface becomes a body: --voxel, --fixed, --young, --poisson.
struct VoxelComplianceOptions
{
  double spacing = 2.0;          ///< mm
  std::string fixedFaces = "z-"; ///< as vtkVoxelBody takes them
  double youngsModulus = 0.05;   ///< MPa
  double poissonsRatio = 0.45;
};

/**
 * Gives a closed surface the point array `GlobalCompliance` (mm/N) of the solid it encloses: filled
 * with hexahedra (vtkVoxelBody), solved (vtkElasticCompliance), and carried back to the surface's
 * own points from the six nearest valid points of the solid whose normals lie within 60°, weighted
 * by 1/distance², so that nothing crosses a thin lobe. A sentence on what was done is added to
 * `notes`. Returns an error, or "".
 */
std::string attachVoxelCompliance(
  vtkPolyData* body, const VoxelComplianceOptions& options, std::vector<std::string>& notes);

/// Carries a point array of one component from the points of `solid` whose `ComplianceStatus` is 0
/// to those of `body`; both have normals. Returns an error that names the first point without any
/// source, or "".
std::string carryCompliance(vtkPolyData* solid, vtkPolyData* body);
} // namespace palpate

#endif
