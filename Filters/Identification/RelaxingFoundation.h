// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RelaxingFoundation_h
#define palpate_RelaxingFoundation_h

#include "Identification/PressHistory.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/PronySeries.h"
#include "Mechanics/Relaxation/RelaxationElements.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * The force of a relaxing body over a history of presses, holds and releases, by
 * RelaxationElements: more of them than in a servo tick, accurate enough to compare with readings.
 * The slow curve is given by its forces at the gaps of the elements, D (j/n)², and at its end D;
 * several curves share the work.
 *
 * Against Ting's integrals, of the largest force: 1e-4 of a sphere, 2e-4 of a cone with 99 elements
 * on unloading, exact on loading but for the steps in time. Cost: 0.2 µs per point, element and
 * branch for 99 elements.
 */
class PALPATE_EXPORT RelaxingFoundation
{
public:
  /// A curve at the depths of depths(): force and, unless empty, dF/dδ for higher accuracy.
  struct SlowCurve
  {
    Eigen::VectorXd force;
    Eigen::VectorXd stiffness;
  };

  /// Down to this depth (mm, > 0), with 33 elements per block.
  RelaxingFoundation(double depth, std::size_t blocks);

  /// From 0 to the end, mm; one more than elements.
  const Eigen::VectorXd& depths() const noexcept { return this->Depths; }

  /// The forces of each curve (column) at each point of a history, N. `offset`: the deflection of
  /// first contact, mm. A history that begins in contact is continued backwards at its first speed.
  Eigen::MatrixXd follow(const PressHistory& history, double offset, const PronySeries& series,
    const std::vector<SlowCurve>& curves) const;

private:
  struct Prepared;
  Prepared prepare(const SlowCurve& curve) const;
  double remainder(const SlowCurve& curve, double depth) const;

  Eigen::VectorXd Depths;
  std::vector<RelaxationElements::Gaps> Gaps;
};
} // namespace palpate

#endif
