// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VoxelCompliance_h
#define palpate_VoxelCompliance_h

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace palpate
{
/// The options by which a surface becomes a solid: --voxel, --fixed, --young, --poisson.
struct VoxelComplianceOptions
{
  double spacing = 2.0;          ///< mm
  std::string fixedFaces = "z-"; ///< as for vtkVoxelBody
  double youngsModulus = 0.05;   ///< MPa
  double poissonsRatio = 0.45;
};

/**
 * Gives a closed surface the point array `GlobalCompliance` (mm/N) of the solid it encloses, and
 * six modes of its global motion (`GlobalMode0`..., `GlobalModeSign`): fills it with hexahedra
 * (vtkVoxelBody), solves (vtkElasticCompliance), and interpolates at the surface's own points. A
 * sentence on what was done is added to `notes`. Returns an error, or "".
 */
std::string attachVoxelCompliance(
  vtkPolyData* body, const VoxelComplianceOptions& options, std::vector<std::string>& notes);

/// Interpolates the compliance, from the points of `solid` whose `ComplianceStatus` is 0 or, where
/// none faces the same way, from the others, and the modes, from all, at the points of `body`: each
/// from the nearest that face the same way (FacingPoints). Returns an error that names the first
/// point without any source, or "".
std::string carryCompliance(vtkPolyData* solid, vtkPolyData* body);
} // namespace palpate

#endif
