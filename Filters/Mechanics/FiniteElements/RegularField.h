// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RegularField_h
#define palpate_RegularField_h

#include "Mechanics/FiniteElements/ElasticBody.h"

namespace palpate
{
/**
 * How the surface of a body moves under 1 N pressed into it at a point X, less the dent: the field
 * whose normal part at X itself is -C_g (PatchCompliance).
 *
 * The whole field is solved for, under the two patches of X put together as (4 p(c) - p(2c)) / 3,
 * so that the bias in c² goes and the force acts as at a point. The dent is that of the same
 * patches on a half-space: within the cut around X that of the same elements (PatchSelfTerm),
 * beyond it Boussinesq's surface, u_n = 1/(πE*r) and u_r = -(1-2ν)(1+ν)/(2πEr), r the straight
 * distance. It is taken off where a dent is seen: on the surface that is connected to X and faces
 * the same way, fully within 50° of the normal at X and fading to nothing at 60°.
 */
class RegularField
{
public:
  /// `radius` (mm) as in patchCompliances(). The body, factorised, must stay.
  RegularField(const ElasticBody& body, double radius)
    : Body(body)
    , Radius(radius)
  {
  }

  /// 3 × surface points, mm/N. The patches of the point must be valid (PatchStatus::Valid).
  Eigen::Matrix3Xd at(std::int32_t point) const;

private:
  const ElasticBody& Body;
  double Radius;
};
} // namespace palpate

#endif
