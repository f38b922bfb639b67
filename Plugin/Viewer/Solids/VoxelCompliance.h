// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VoxelCompliance_h
#define palpate_VoxelCompliance_h

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace palpate
{
/// Options for making a solid of a surface: --voxel, --fixed, --young, --poisson.
struct VoxelComplianceOptions
{
  double spacing = 2.0;          ///< mm
  std::string fixedFaces = "z-"; ///< sides that hold the body, as for vtkVoxelBody
  double youngsModulus = 0.1;    ///< MPa
  double poissonRatio = 0.45;
};

/**
 * Attaches to a closed surface the point array `GlobalCompliance` (mm/N) of the enclosed solid, and
 * six modes of the solid's global motion (`GlobalMode0`..., `GlobalModeSign`). Fills the surface
 * with hexahedra (vtkVoxelBody), solves (vtkElasticCompliance), and interpolates at the surface's
 * own points. Adds a sentence about the solid to `notes`. Returns "" or an error.
 */
std::string attachVoxelCompliance(
  vtkPolyData* body, const VoxelComplianceOptions& options, std::vector<std::string>& notes);

/// Interpolates compliance and modes at the points of `body`, each from the nearest points of
/// `solid` whose normals have a similar direction (FacingPoints). The compliance is taken from
/// points whose `ComplianceStatus` is 0 or, if none of them has such a normal, from the other
/// points. The modes are taken from all points. Returns "", or an error that names the first point
/// without any source.
std::string carryCompliance(vtkPolyData* solid, vtkPolyData* body);
} // namespace palpate

#endif
