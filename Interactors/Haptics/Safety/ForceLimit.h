// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceLimit_h
#define palpate_ForceLimit_h

#include <Eigen/Core>

namespace palpate
{
/// The clamp of the magnitude, which keeps the direction.
class ForceLimit
{
public:
  /// `maximum` in N; infinite: no limit; negative or NaN: no force.
  explicit ForceLimit(double maximum) noexcept
    : Maximum(maximum > 0.0 ? maximum : 0.0)
  {
  }

  /// Of a force that is finite.
  Eigen::Vector3d limit(const Eigen::Vector3d& force) const noexcept
  {
    // The plain norm wherever its squares neither overflow nor vanish: it is what C and C++ loops
    // have been given from the first, to the bit.
    const double plain = force.norm();
    const double size = plain > 1e-100 && plain < 1e100 ? plain : force.stableNorm();
    return size <= this->Maximum ? force : Eigen::Vector3d(this->Maximum / size * force);
  }

private:
  double Maximum;
};
} // namespace palpate

#endif
