// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MissedEnergy_h
#define palpate_MissedEnergy_h

#include "Mechanics/FiniteElements/PatchCut.h"

namespace palpate
{
/// Middles and sizes of a body's elements, for the energy missed beyond a cut.
class MissedEnergy
{
public:
  explicit MissedEnergy(const VolumeMesh& mesh);

  /// What to add of (outer - inner) to the self-term of the outer cut; 0 for quadratic elements.
  double fraction(const Eigen::Vector3d& point, const LocalPatch& patch) const;

private:
  double of(const Eigen::Vector3d& point, std::size_t element) const;

  Eigen::Matrix3Xd Middles;
  std::vector<double> Weights; ///< V h², 0 for quadratic elements
};
} // namespace palpate

#endif
