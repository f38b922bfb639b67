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
 * Gives a closed surface the point array `GlobalCompliance` (mm/N) of the solid it encloses, and
 * six modes of its motion as a whole (`GlobalMode0`..., `GlobalModeSign`): filled with hexahedra
 * (vtkVoxelBody), solved (vtkElasticCompliance), and carried back to the surface's own points. A
 * sentence on what was done is added to `notes`. Returns an error, or "".
 */
std::string attachVoxelCompliance(
  vtkPolyData* body, const VoxelComplianceOptions& options, std::vector<std::string>& notes);

/// Carries the compliance, from the points of `solid` whose `ComplianceStatus` is 0 or, where none
/// faces the same way, from the others, and the modes it has, from all, to the points of `body`:
/// each from the nearest that face the same way (FacingPoints). Returns an error that names the
/// first point without any source, or "".
std::string carryCompliance(vtkPolyData* solid, vtkPolyData* body);
} // namespace palpate

#endif
