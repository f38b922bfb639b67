// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactTilt_h
#define palpate_ContactTilt_h

#include "Contact/Contact.h"
#include "Contact/Tilt/BodyTilt.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * One contact of a tool that is tilted, tick by tick: its energy is the work of the upright tool
 * times the table's τ (TiltTable), at the depth D of the tool's deepest point and the angle θ
 * between its axis and the body's smooth normal, the blend of the response's normals.
 *
 * The deepest point of a tilted end lies beside the tip and lower: there is contact while the tip
 * is still outside. So a point is followed that lies under the tip by as much, along the normal
 * that was last found (the axis, before there is one); the depth is told back from it.
 *
 * On a curved body θ changes with the place: the energy then has the force -M ∇θ beside that along
 * the normal. The torque M (axis × normal)/sin θ about the tip sets the tool upright.
 *
 * Allocates nothing, throws nothing. One object is one history.
 */
class PALPATE_EXPORT ContactTilt
{
public:
  /// `body` must outlive it; null: tilts are not felt.
  explicit ContactTilt(const BodyTilt* body) noexcept
    : Body(body)
  {
  }

  /// Whether the last pose had an axis, and the body knows of tilts.
  bool isFelt() const noexcept { return this->IsFelt; }
  /// Whether the tilt at the contact changes the force of the upright tool.
  bool isTilted() const noexcept
  {
    constexpr double upright = 1e-7; // rad: M and the change of F are as small a part of F
    return this->IsFelt && this->Angle > upright;
  }

  /// The point to be followed, of a tool in this pose; its tip, if no tilt is felt.
  Vector3 follow(const ToolPose& pose, bool isFollowed) noexcept;

  /// Where the contact is: sets the tilt by the smooth normal there. By how much the point followed
  /// lies deeper than the deepest point of the tool, mm.
  double turn(
    const TriangleCorners& corners, const Vector3& weights, const ResponseField& response) noexcept;

  /// The gradients of the area coordinates as the tip moves, from those as the point followed does,
  /// which lies under it and, on a curved body, goes another way.
  Eigen::Matrix3d ofTip(const Eigen::Matrix3d& weightGradients, const TriangleCorners& corners,
    const ResponseField& response) const noexcept;

  /// What press() would give at another depth.
  ResponseValue tilted(const TriangleCorners& corners, const Vector3& weights, double depth,
    const ResponseValue& upright, double work) const noexcept;
  /// The force of the tilted tool at a depth > 0 of its deepest point, from that of the upright one
  /// and its work there.
  ResponseValue press(const TriangleCorners& corners, const Vector3& weights, double depth,
    const ResponseValue& upright, double work) noexcept;

  // Of the last press:
  /// The work it has taken, N mm.
  double work() const noexcept { return this->Factor.value * this->Work; }
  /// The depth at which the upright tool has the same force, mm, and how stiff it is there.
  struct Alike
  {
    double depth = 0.0;
    ResponseValue value;
    double stiffening = 1.0; ///< that of the tilted tool over it
  };
  Alike alike(const BlendedResponse& curve) const noexcept;
  /// The energies at the corners, from those of the upright tool (BlendedResponse::energies).
  Vector3 energies(const TriangleCorners& corners, const Vector3& upright) const noexcept;
  /// M/N mm, where `force` (N) is what has become of the force and `share` of the energy.
  double moment(double force, double share) const noexcept
  {
    return force * this->Deepest.offset + share * this->Work * this->Factor.byAngle;
  }
  /// On the tool, about its tip, N mm.
  Vector3 torque(double moment) const noexcept;
  /// -M ∇θ, N; gradients ofTip.
  Vector3 forceBeside(double moment, const TriangleCorners& corners,
    const Eigen::Matrix3d& weightGradients, const ResponseField& response) const noexcept;

  double angle() const noexcept { return this->Angle; }
  bool isTooFar() const noexcept { return this->Body->table().isBeyond(this->Angle); }

private:
  const BodyTilt* Body;
  bool IsFelt = false;
  Vector3 Axis = Vector3::Zero();
  Vector3 Down = Vector3::Zero();   ///< unit, from the tip to the point followed
  double Under = 0.0;               ///< how far, mm
  Vector3 Normal = Vector3::Zero(); ///< smooth, where the contact was last
  double NormalLength = 1.0;        ///< of the sum it is made of
  double Angle = 0.0;
  DeepestPoint Deepest;
  double Depth = 0.0;
  TiltFactor Factor;
  ResponseValue Force;
  double Work = 0.0; ///< of the upright tool
};
} // namespace palpate

#endif
