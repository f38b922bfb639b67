// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceRateLimit_h
#define palpate_ForceRateLimit_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

namespace palpate
{
/**
 * The slew limit: between two ticks the force changes by no more than the rate times the time
 * between them, along the straight line to where it should be. It starts from the force that was
 * sent last, none at first, so that what later links take away does not come back at once.
 */
class PALPATE_EXPORT ForceRateLimit
{
public:
  /// `rate` in N/s; infinite: no limit; negative or NaN: the force does not change.
  explicit ForceRateLimit(double rate) noexcept
    : Rate(rate)
  {
  }

  Eigen::Vector3d limit(double time, const Eigen::Vector3d& force) const noexcept;
  /// What has left the chain in this tick.
  void sent(double time, const Eigen::Vector3d& force) noexcept;
  /// Nothing has been sent.
  void reset() noexcept;

private:
  double Rate;
  Eigen::Vector3d Last = Eigen::Vector3d::Zero();
  bool HasTime = false; ///< else no time has passed yet
  double LastTime = 0.0;
};
} // namespace palpate

#endif
