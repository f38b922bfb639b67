// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RegularField_h
#define palpate_RegularField_h

#include "Solids/FiniteElements/ElasticBody.h"

namespace palpate
{
/**
 * Displacement of a body's surface under an inward force of 1 N at a point X, without the dent. The
 * normal component of this field at X itself is -C_g (PatchCompliance).
 *
 * The whole field is computed under the combination (4 p(c) - p(2c)) / 3 of the two patch loads at
 * X. This combination eliminates the bias in c² and acts as a point force. The dent is the
 * displacement under the same patches on a half-space. Within the cut around X it is computed with
 * the same elements (PatchSelfTerm), beyond the cut it is Boussinesq's surface, u_n = 1/(πE*r) and
 * u_r = -(1-2ν)(1+ν)/(2πEr) with the straight distance r. The dent is subtracted on the part of the
 * surface that is connected to X and has a similar normal. It is fully subtracted where the normal
 * is within 50° of the normal at X, and its fraction decreases to zero at 60°.
 */
class RegularField
{
public:
  /// `radius` (mm) is that of patchCompliances(). The body must be factorised and must outlive this
  /// object.
  RegularField(const ElasticBody& body, double radius)
    : Body(body)
    , Radius(radius)
  {
  }

  /// Returns the field of a point, 3 × surface points, mm/N. The patches of the point must be valid
  /// (PatchStatus::Valid).
  Eigen::Matrix3Xd at(std::int32_t point) const;

private:
  const ElasticBody& Body;
  double Radius;
};
} // namespace palpate

#endif
