// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_VisitLedger_h
#define palpate_endurance_VisitLedger_h

#include <Eigen/Core>

namespace palpate::endurance
{
/**
 * Work of the contact force on the tip during a visit, by the trapezoidal rule. A visit lasts from
 * one time outside to the next. The work is the energy that a hand gains from the body in this
 * visit. It must not be positive, except for the error of the force forms on facets (stability
 * study: 1 % of force times path), for any relaxation. If a step crosses the surface, the place
 * between its ends where the force begins or ends is unknown. The work of such a step is between
 * zero and the whole force times the step, so half of this product is subtracted from the gain.
 */
class VisitLedger
{
public:
  static constexpr double Allowed = 0.01; ///< fraction of force times path
  /// N mm of force times path; a smaller value is not a visit
  static constexpr double Least = 0.01;
  /// mm. The trapezoidal rule is too inaccurate for a longer path in one tick, as after a late
  /// reading.
  static constexpr double LongestStep = 0.2;

  /// Discards the visit, for missed ticks. A new visit starts when the tip is outside.
  void lose() noexcept { this->IsOpen = false; }
  /// Adds the force on the tip, N, at `tip`, mm. Returns true if a visit ends.
  bool move(const Eigen::Vector3d& tip, const Eigen::Vector3d& force, bool isOutside) noexcept
  {
    const Eigen::Vector3d way = tip - this->Tip;
    const bool ends = this->IsOpen && isOutside && this->Scale > Least;
    if (this->IsOpen)
    {
      this->Work += 0.5 * (force + this->Force).dot(way);
      const double scale = 0.5 * (force.norm() + this->Force.norm()) * way.norm();
      this->Scale += scale;
      this->Doubt += force.isZero(0.0) != this->Force.isZero(0.0) ? scale : 0.0;
      this->IsOpen = way.norm() <= LongestStep;
    }
    this->Gain = ends && this->IsOpen ? (this->Work - this->Doubt) / this->Scale : 0.0;
    const bool isJudged = ends && this->IsOpen;
    if (isOutside)
    {
      this->IsOpen = true;
      this->Work = 0.0;
      this->Scale = 0.0;
      this->Doubt = 0.0;
    }
    this->Tip = tip;
    this->Force = force;
    return isJudged;
  }
  /// Lower bound of the energy gained in the visit that has ended, divided by force times path.
  double gain() const noexcept { return this->Gain; }

private:
  bool IsOpen = false;
  Eigen::Vector3d Tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d Force = Eigen::Vector3d::Zero();
  double Work = 0.0;
  double Scale = 0.0;
  double Doubt = 0.0; ///< largest error of Work, from the steps across the surface, N mm
  double Gain = 0.0;
};
} // namespace palpate::endurance

#endif
