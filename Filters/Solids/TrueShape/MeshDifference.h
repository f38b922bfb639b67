// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshDifference_h
#define palpate_MeshDifference_h

#include "Solids/TrueShape/LandmarkKernels.h"

#include <vector>

namespace palpate
{
/**
 * What the elements of a body miss of its kernels, told by a second, coarser mesh of the same body.
 *
 * c₀₀ of both is compared at the landmarks of the coarser one, radius by radius. Of two meshes
 * whose sides are as 1 to k the finer one misses 1/(k^p - 1) of what lies between them (Richardson
 * 1911). Where H is smooth p is 2, but the stress at the edge of what is held is singular, and how
 * the body bends about it converges with p = 1, which is what is taken; k is that of the surfaces
 * there. One such difference may be nothing by chance, where it changes its sign, so that what is
 * told at a place is the root of the mean square of those around it that face the
 * same way. How often it holds: MeshDifferenceTest.
 */
class PALPATE_EXPORT MeshDifference
{
public:
  /// Both complete and solved for the same contact radius; neither is kept. Cost: that of a
  /// BlendedKernels per landmark of the coarser one, on threadCount() threads.
  MeshDifference(const LandmarkKernels& body, const LandmarkKernels& coarser);

  /// At a place of the surface with this outward normal: not known where no landmark of the coarser
  /// mesh faces that way. From any number of threads. Cost: some 10 ns per landmark.
  MissedCompliance at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

private:
  /// A landmark of the coarser mesh.
  struct Sample
  {
    Eigen::Vector3d place;
    Eigen::Vector3d normal;
    double spacing = 0.0;       ///< of the coarser mesh's nodes, mm
    std::vector<double> missed; ///< beside Radii, mm/N
  };

  Sample sample(const LandmarkKernels& body, const LandmarkKernels& coarser, std::size_t i) const;

  std::vector<double> Radii; ///< ascending, mm
  std::vector<Sample> Samples;
};
} // namespace palpate

#endif
