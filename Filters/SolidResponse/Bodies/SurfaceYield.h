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
/// The values of all points for the first contact radius are followed by the values for the next
/// contact radius.
struct SurfaceYield
{
  std::vector<double> compliance;
  std::vector<double> error;         ///< error of the compliance, mm/N, >= 0
  std::vector<unsigned char> status; ///< PatchStatus of each point
};

/// Compliance of a body in addition to that of a half-space at one position, mm/N, with one value
/// per contact radius.
struct SpotYield
{
  std::vector<double> compliance;
  std::vector<double> error;
  unsigned char status = 0;
};

/// The compliance at any position of a surface. `solid` is the surface to which the point numbers
/// of the landmarks refer. `meshes` is null if there is no second mesh. All arguments must outlive
/// this object.
class YieldField
{
public:
  YieldField(vtkPolyData* solid, const LandmarkKernels& landmarks, const MeshDifference* meshes);

  /// Returns the compliance at a position with the given normal, for each contact radius.
  /// Thread-safe.
  SpotYield at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
    const std::vector<double>& radii) const;

private:
  double ofHalfSpace(double radius) const;

  const LandmarkKernels& Landmarks;
  NearLandmarks Near;
  const MeshDifference* Meshes;
  double Modulus; ///< reduced modulus E*, MPa
};

/**
 * Computes the compliance C in series with the law of a tool on a half-space: δ = δ_local(F) + C F.
 * C is the mean of H(x, X) (RegularGreen) over x and X, both weighted by the pressure of a round
 * tool with one of the contact radii.
 *
 * The error includes the error of the elements, of the interpolation between the sources of H and
 * of the order of the kernel. It also includes the difference between a round tool and a flat end,
 * and the change of C from the first touch to the contact radius. At points whose status is not
 * Valid, C is 0 and its error is that of a contact on a half-space. Large triangles are also
 * checked at points inside them (LargeTriangles.h).
 *
 * `surface` must have passed checkTriangles. `normals` has three numbers per point. `radii` (mm)
 * are in descending order.
 */
SurfaceYield yieldOf(vtkPolyData* surface, const float* normals, const YieldField& field,
  const std::vector<double>& radii);
} // namespace palpate

#endif
