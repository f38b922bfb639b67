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
 * c₀₀ of the two meshes is compared at the landmarks of the coarser mesh, radius by radius. If the
 * side lengths have the ratio k, the error of the finer mesh is 1/(k^p - 1) of the difference
 * (Richardson 1911). p is 2 where H is smooth. However, the stress at the edge of held points is
 * singular, and the bending of the body about that edge converges with p = 1; therefore p = 1 is
 * used. k is the ratio of the two surfaces' spacings at the place. A single difference may be zero
 * by chance, where its sign changes. The estimate at a place is therefore the root mean square of
 * the differences at the surrounding landmarks that face the same way. MeshDifferenceTest checks
 * how often the estimate holds.
 */
class PALPATE_EXPORT MeshDifference
{
public:
  /// Both arguments must be complete and solved for the same contact radius. The object keeps no
  /// reference to them. Cost: one BlendedKernels per landmark of the coarser mesh, on threadCount()
  /// threads.
  MeshDifference(const LandmarkKernels& body, const LandmarkKernels& coarser);

  /// The estimate at a place of the surface with this outward normal. It is unknown if no landmark
  /// of the coarser mesh faces that way. Safe from any number of threads. Cost: a few tens of ns
  /// per landmark.
  MissedCompliance at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

private:
  /// A landmark of the coarser mesh.
  struct Sample
  {
    Eigen::Vector3d place;
    Eigen::Vector3d normal;
    double spacing = 0.0;       ///< spacing of the coarser mesh's nodes, mm
    std::vector<double> missed; ///< one per radius of Radii, mm/N
  };

  Sample sample(const LandmarkKernels& body, const LandmarkKernels& coarser, std::size_t i) const;

  std::vector<double> Radii; ///< ascending, mm
  std::vector<Sample> Samples;
};
} // namespace palpate

#endif
