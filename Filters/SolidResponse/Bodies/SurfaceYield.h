// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceYield_h
#define SurfaceYield_h

#include "SolidResponse/Bodies/NearLandmarks.h"

#include <Eigen/Core>

#include <vector>

class vtkPolyData;

namespace palpate
{
class LandmarkKernels;
class MeshDifference;

/// Compliance of a body in addition to that of a half-space, at the points of its surface, mm/N.
/// The values of all points for the first contact radius are followed by those for the next.
struct SurfaceYield
{
  std::vector<double> compliance;
  std::vector<double> error;         ///< >= 0
  std::vector<unsigned char> status; ///< a PatchStatus per point
};

/// Compliance of a body in addition to that of a half-space at one place, mm/N; one value per
/// contact radius.
struct SpotYield
{
  std::vector<double> compliance;
  std::vector<double> error;
  unsigned char status = 0;
};

/// The compliance at any place of a surface. `solid`: the surface to which the landmarks' point
/// numbers refer. `meshes`: null if there is no second mesh. All arguments must outlive this
/// object.
class YieldField
{
public:
  YieldField(vtkPolyData* solid, const LandmarkKernels& landmarks, const MeshDifference* meshes);

  /// Safe from any number of threads.
  SpotYield at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
    const std::vector<double>& radii) const;

private:
  double ofHalfSpace(double radius) const;

  const LandmarkKernels& Landmarks;
  NearLandmarks Near;
  const MeshDifference* Meshes;
  double Modulus; ///< reduced, MPa
};

/**
 * Computes the compliance C in series with the law of a tool on a half-space: δ = δ_local(F) + C F.
 * C is the mean of H (RegularGreen) over both of its points, weighted by the pressure of a round
 * tool with one of the contact radii.
 *
 * The error includes the elements, the interpolation between the sources of H, the order of the
 * kernel, the difference between a round tool and a flat end, and the change of C from the first
 * touch to this radius. At points whose status is not Valid, C is 0 and its error is that of a
 * contact on a half-space. Large triangles are checked inside as well (LargeTriangles.h).
 *
 * `surface` must have passed checkTriangles; `normals`: three per point. `radii`: descending.
 */
SurfaceYield yieldOf(vtkPolyData* surface, const float* normals, const YieldField& field,
  const std::vector<double>& radii);
} // namespace palpate

#endif
