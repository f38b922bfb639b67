// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactTilt_h
#define palpate_ContactTilt_h

#include "Contact/Contact.h"
#include "Contact/Tilt/BodyTilt.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * One contact of a tilted tool, computed tick by tick. Its energy is the work of the upright tool
 * times the factor τ of the table (TiltTable). τ is evaluated at the depth D of the tool's deepest
 * point and at the angle θ between the axis of the tool and the smooth normal of the body, which is
 * the blend of the response's normals.
 *
 * The deepest point of a tilted end is below the tip and to one side of it, so that contact begins
 * while the tip is still outside. The tracker therefore follows a point that is below the tip by
 * the drop, along the last normal (along the axis if there is none yet). The depth is computed from
 * that point.
 *
 * On a curved body θ depends on the contact point; the energy then adds the force -M ∇θ to the
 * force along the normal. The torque M (axis × normal)/sin θ about the tip turns the tool upright.
 *
 * No function allocates or throws. One object is one history.
 */
class PALPATE_EXPORT ContactTilt
{
public:
  /// `body` must outlive this object; null: tilts have no effect.
  explicit ContactTilt(const BodyTilt* body) noexcept
    : Body(body)
  {
  }

  /// Whether the last pose had an axis and the body has tilt data.
  bool isFelt() const noexcept { return this->IsFelt; }
  /// Whether the tilt at the contact changes the force of the upright tool.
  bool isTilted() const noexcept
  {
    constexpr double upright = 1e-7; // rad; M and the change of F are of this order, relative to F
    return this->IsFelt && this->Angle > upright;
  }

  /// The point to follow for a tool in this pose; it is the tip if tilts have no effect.
  Vector3 follow(const ToolPose& pose, bool isFollowed) noexcept;

  /// Sets the tilt from the smooth normal at the contact. Returns by how much the followed point is
  /// deeper than the deepest point of the tool, mm.
  double turn(
    const TriangleCorners& corners, const Vector3& weights, const ResponseField& response) noexcept;

  /// Gradients of the area coordinates by the position of the tip, from those by the position of
  /// the followed point. On a curved body the two points move differently.
  Eigen::Matrix3d ofTip(const Eigen::Matrix3d& weightGradients, const TriangleCorners& corners,
    const ResponseField& response) const noexcept;

  /// The result that press() would have at another depth; changes nothing.
  ResponseValue tilted(const TriangleCorners& corners, const Vector3& weights, double depth,
    const ResponseValue& upright, double work) const noexcept;
  /// The force of the tilted tool at a depth > 0 of its deepest point, computed from the force and
  /// the work of the upright tool at that depth.
  ResponseValue press(const TriangleCorners& corners, const Vector3& weights, double depth,
    const ResponseValue& upright, double work) noexcept;

  // Results of the last press.
  /// The work done, N mm.
  double work() const noexcept { return this->Factor.value * this->Work; }
  /// The depth at which the upright tool has the same force, mm, and its force and stiffness at
  /// that depth.
  struct Alike
  {
    double depth = 0.0;
    ResponseValue value;
    double stiffening = 1.0; ///< stiffness of the tilted tool divided by that of the upright tool
  };
  Alike alike(const BlendedResponse& curve) const noexcept;
  /// The energies at the corners, computed from those of the upright tool
  /// (BlendedResponse::energies).
  Vector3 energies(const TriangleCorners& corners, const Vector3& upright) const noexcept;
  /// Moment M in N mm. `force` (N) is the force after all reductions, `share` the remaining
  /// fraction of the work.
  double moment(double force, double share) const noexcept
  {
    return force * this->Deepest.offset + share * this->Work * this->Factor.byAngle;
  }
  /// Torque on the tool about its tip, N mm.
  Vector3 torque(double moment) const noexcept;
  /// -M ∇θ, N; `weightGradients` as returned by ofTip().
  Vector3 forceBeside(double moment, const TriangleCorners& corners,
    const Eigen::Matrix3d& weightGradients, const ResponseField& response) const noexcept;

  double angle() const noexcept { return this->Angle; }
  bool isTooFar() const noexcept { return this->Body->table().isBeyond(this->Angle); }

private:
  const BodyTilt* Body;
  bool IsFelt = false;
  Vector3 Axis = Vector3::Zero();
  Vector3 Down = Vector3::Zero();   ///< unit, from the tip to the followed point
  double Under = 0.0;               ///< distance of the followed point from the tip, mm
  Vector3 Normal = Vector3::Zero(); ///< smooth, at the last contact
  /// Length of the sum of point normals of which Normal is the direction.
  double NormalLength = 1.0;
  double Angle = 0.0;
  DeepestPoint Deepest;
  double Depth = 0.0;
  TiltFactor Factor;
  ResponseValue Force;
  double Work = 0.0; ///< of the upright tool
};
} // namespace palpate

#endif
