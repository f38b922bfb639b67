// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SlidingDrag_h
#define palpate_SlidingDrag_h

#include "Contact/FrictionFrame.h"

namespace palpate
{
/**
 * What it takes to lead a tool on to material that was not pressed yet (hysteresis friction): a
 * contact that sticks, with the tangential stiffness of the body itself, until the pull is what the
 * new material stores per length.
 *
 * The stiffness changes with the depth: a spring that gets stiffer keeps its force, one that gets
 * softer its displacement, so that no change gives energy (ShapeFriction does the same). What the
 * contact does not slide, it does not exchange: to and fro about one place nothing is new.
 */
class SlidingDrag
{
public:
  void reset() noexcept
  {
    this->Frame.reset();
    this->Displacement.setZero();
  }

  /// To the contact of this tick; the way there, mm. The first after reset() has none.
  double advance(const Vector3& contactPoint, const Vector3& normal) noexcept
  {
    if (!this->Frame.advance(contactPoint, normal))
    {
      this->Displacement.setZero();
      this->Stiffness = 0.0;
    }
    return this->Frame.step().length();
  }

  /// Along that way. `limit` in N, `stiffness` in N/mm; the length that slid, mm.
  double slide(double limit, double stiffness) noexcept
  {
    if (stiffness > this->Stiffness)
    {
      this->Displacement *= this->Stiffness / stiffness;
    }
    this->Stiffness = stiffness;
    const StraightStep& step = this->Frame.step();
    const double longest = stiffness > 0.0 ? limit / stiffness : 0.0;
    if (!(longest > Shortest))
    {
      this->Displacement.setZero();
      return step.length();
    }
    StraightStep::clip(this->Displacement, longest);
    Vector2 z = step.toPath(this->Displacement);
    const double slid = StraightStep::moveFreely(z, longest, step.length());
    if (slid > 0.0)
    {
      StraightStep::drag(z, longest, slid);
    }
    this->Displacement = step.fromPath(z);
    return slid;
  }

  /// On the tool, N.
  Vector3 force() const noexcept
  {
    return -this->Stiffness * this->Frame.toSpace(this->Displacement);
  }

private:
  static constexpr double Shortest = 1e-12; ///< mm

  FrictionFrame Frame;
  Vector2 Displacement = Vector2::Zero(); ///< elastic
  double Stiffness = 0.0;
};
} // namespace palpate

#endif
