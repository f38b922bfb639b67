// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_VoxelCompliance_h
#define palpate_VoxelCompliance_h

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace palpate
{
/// The options for making a solid from a surface: --voxel, --fixed, --young and --poisson.
struct VoxelComplianceOptions
{
  double spacing = 2.0; ///< side of the hexahedra, mm
  /// Faces of the bounding box at which the body is held, as for vtkVoxelBody.
  std::string fixedFaces = "z-";
  double youngsModulus = 0.1; ///< MPa
  double poissonRatio = 0.45;
};

/**
 * Attaches to a closed surface the point array `GlobalCompliance` (mm/N) of the enclosed solid, and
 * six modes of the solid's global motion (`GlobalMode0`..., `GlobalModeSign`). The surface is
 * filled with hexahedra (vtkVoxelBody), the compliance is computed (vtkElasticCompliance), and the
 * result is interpolated at the points of the surface. Adds a sentence about the solid to `notes`.
 * Returns "" or an error.
 */
std::string attachVoxelCompliance(
  vtkPolyData* body, const VoxelComplianceOptions& options, std::vector<std::string>& notes);

/// Interpolates compliance and modes at each point of `body` from the nearest points of `solid`
/// whose normals have a similar direction (FacingPoints). The compliance is taken from points whose
/// `ComplianceStatus` is 0 or, if none of them has such a normal, from the other points. The modes
/// are taken from all points. Returns "", or an error that names the first point without any
/// source.
std::string carryCompliance(vtkPolyData* solid, vtkPolyData* body);
} // namespace palpate

#endif
