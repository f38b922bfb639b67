// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_VisitLedger_h
#define palpate_endurance_VisitLedger_h

#include <Eigen/Core>

namespace palpate::endurance
{
/**
 * The work of the contact force on the tip from being outside to being outside again, by
 * trapezoids: what a hand gets out of a body in one visit. None may be left over, but for what the
 * force forms leave on facets (study stability: 1 % of force times way), whatever the body
 * remembers of being pressed.
 */
class VisitLedger
{
public:
  static constexpr double Allowed = 0.01; ///< of force times way
  static constexpr double Least = 0.01;   ///< N mm, of force times way: else it was no visit
  /// mm: over a longer way in one tick, as after a late reading, trapezoids are too coarse.
  static constexpr double LongestStep = 0.2;

  /// Begins anew when the tip is outside: something was not seen.
  void lose() noexcept { this->IsOpen = false; }
  /// `force` on the tip, N, at `tip`, mm. True where a visit ends.
  bool move(const Eigen::Vector3d& tip, const Eigen::Vector3d& force, bool isOutside) noexcept
  {
    const Eigen::Vector3d way = tip - this->Tip;
    const bool ends = this->IsOpen && isOutside && this->Scale > Least;
    if (this->IsOpen)
    {
      this->Work += 0.5 * (force + this->Force).dot(way);
      this->Scale += 0.5 * (force.norm() + this->Force.norm()) * way.norm();
      this->IsOpen = way.norm() <= LongestStep;
    }
    this->Gain = ends && this->IsOpen ? this->Work / this->Scale : 0.0;
    const bool isJudged = ends && this->IsOpen;
    if (isOutside)
    {
      this->IsOpen = true;
      this->Work = 0.0;
      this->Scale = 0.0;
    }
    this->Tip = tip;
    this->Force = force;
    return isJudged;
  }
  /// Of the visit that has ended: got out, over force times way.
  double gain() const noexcept { return this->Gain; }

private:
  bool IsOpen = false;
  Eigen::Vector3d Tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d Force = Eigen::Vector3d::Zero();
  double Work = 0.0;
  double Scale = 0.0;
  double Gain = 0.0;
};
} // namespace palpate::endurance

#endif
