// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FrictionFrame_h
#define palpate_FrictionFrame_h

#include <Eigen/Core>

namespace palpate
{
using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;

/// What a friction model answers, in the frame below.
struct TangentialForce
{
  Vector2 force = Vector2::Zero(); ///< on the tool, N
  bool sliding = true;
};

/**
 * A tangent frame that goes along with the contact point, so that what happened along the surface
 * can be kept in two numbers.
 *
 * Parallel transport: from one tick to the next the frame takes the smallest rotation that brings
 * the last normal to the new one. A vector of fixed components neither turns nor changes length as
 * seen on the surface; around a closed path it comes back turned by the integral of the curvature
 * inside (on a sphere, the solid angle). No trigonometry; going back undoes it.
 *
 * Displacement over the surface: the chord from the last contact point, its components averaged
 * over the two frames (on a circular arc that is the arc's own direction), with the length of the
 * arc that has this chord and turns as much as the normals: 5e-7 too short at 0.3 rad per tick,
 * 0.8 % at a right angle. What of the chord lies along the normals only lengthens the rest, to no
 * more than twice: a contact that moves along its normal is not displaced.
 *
 * Normals more than 177 degrees apart have no smallest rotation: history ends there.
 */
class FrictionFrame
{
public:
  /// Forget the last contact.
  void reset() noexcept { this->Started = false; }

  /// To the next contact: `point` on the undeformed surface, mm; `normal` unit. Whether the last
  /// one was carried along; if not, the frame starts here, and the displacement is 0.
  bool advance(const Vector3& point, const Vector3& normal) noexcept;

  /// Of the last advance, mm, in this frame.
  const Vector2& displacement() const noexcept { return this->Displacement; }

  /// A tangent vector given in this frame.
  Vector3 toSpace(const Vector2& tangent) const noexcept
  {
    return tangent.x() * this->First + tangent.y() * this->Second;
  }

private:
  void start(const Vector3& point, const Vector3& normal) noexcept;

  bool Started = false;
  Vector3 Point = Vector3::Zero();
  Vector3 Normal = Vector3::Zero();
  Vector3 First = Vector3::Zero();
  Vector3 Second = Vector3::Zero();
  Vector2 Displacement = Vector2::Zero();
};
} // namespace palpate

#endif
