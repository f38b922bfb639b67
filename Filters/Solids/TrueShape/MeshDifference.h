// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshDifference_h
#define palpate_MeshDifference_h

#include "Solids/TrueShape/LandmarkKernels.h"

#include <vector>

namespace palpate
{
/**
 * Error of the kernels of a body due to its elements, estimated from a second, coarser mesh of the
 * same body.
 *
 * The values of c₀₀ on the two meshes are compared at the landmarks of the coarser mesh, for each
 * contact radius. If the side lengths of the elements have the ratio k, the error of the finer mesh
 * is 1/(k^p - 1) times the difference (Richardson 1911). p is 2 where H is smooth. However, the
 * stress at the edge of held points is singular, and the bending of the body about this edge
 * converges with p = 1. Therefore p = 1 is used. k is the ratio of the two surfaces' spacings at
 * the position. A single difference may be zero by chance, where its sign changes. Therefore the
 * estimate at a position is the root mean square of the differences at the surrounding landmarks
 * with a similar normal. MeshDifferenceTest checks how often the error is within the estimate.
 */
class PALPATE_EXPORT MeshDifference
{
public:
  /// Both arguments must be complete and solved for the same contact radius. The object keeps no
  /// reference to them. Cost: one BlendedKernels per landmark of the coarser mesh, on threadCount()
  /// threads.
  MeshDifference(const LandmarkKernels& body, const LandmarkKernels& coarser);

  /// Returns the estimate at a position on the surface. `normal` is the outward normal at the
  /// position. The estimate is unknown if no landmark of the coarser mesh has a similar normal.
  /// Thread-safe. Cost: a few tens of ns per landmark.
  MissedCompliance at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

private:
  /// A landmark of the coarser mesh.
  struct Sample
  {
    Eigen::Vector3d place;
    Eigen::Vector3d normal;
    double spacing = 0.0;       ///< distance of neighbouring nodes of the coarser mesh, mm
    std::vector<double> missed; ///< error of c₀₀ for each radius of Radii, mm/N
  };

  Sample sample(const LandmarkKernels& body, const LandmarkKernels& coarser, std::size_t i) const;

  std::vector<double> Radii; ///< contact radii in ascending order, mm
  std::vector<Sample> Samples;
};
} // namespace palpate

#endif
