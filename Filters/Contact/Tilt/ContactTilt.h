// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactTilt_h
#define palpate_ContactTilt_h

#include "Contact/Contact.h"
#include "Contact/Jet.h"
#include "Contact/Tilt/BodyTilt.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
/**
 * Computes one contact of a tilted tool, tick by tick. The energy of the contact is the work of the
 * upright tool times the factor τ of the table (TiltTable). τ is evaluated at the depth D of the
 * tool's deepest point and at the angle θ between the axis of the tool and the smooth normal of the
 * body, which is interpolated from the response's normals.
 *
 * The deepest point of a tilted end is below the tip and to one side of it, so that contact begins
 * while the tip is still outside. The tracker therefore follows a point that is below the tip by
 * the drop, along the last normal (along the axis if there is no normal yet). The depth is computed
 * from this followed point.
 *
 * On a curved body θ depends on the contact point, so that the force -M ∇θ is added to the force
 * along the normal. The torque M (axis × normal)/sin θ about the tip acts to turn the tool upright.
 *
 * No function allocates or throws. One object stores the history of one contact.
 */
class PALPATE_EXPORT ContactTilt
{
public:
  /// `body` must outlive this object; it is null if tilts have no effect.
  explicit ContactTilt(const BodyTilt* body) noexcept
    : Body(body)
  {
  }

  /// Returns whether the tilt at the contact changes the force of the upright tool. If not, the
  /// following functions have no effect.
  bool isTilted() const noexcept
  {
    // Rad; at this angle M and the change of F, relative to F, are of the same order.
    constexpr double upright = 1e-7;
    return this->IsFelt && this->Angle > upright;
  }

  /// Returns the point that the tracker follows for a tool in this pose. This is the tip if tilts
  /// have no effect.
  Vector3 follow(const ToolPose& pose, bool isFollowed) noexcept;

  /// Computes the tilt from the smooth normal at the contact. Returns the depth of the followed
  /// point minus the depth of the tool's deepest point, mm.
  double lean(
    const TriangleCorners& corners, const Vector3& weights, const ResponseField& response) noexcept
  {
    return this->IsFelt ? this->leanAt(corners, weights, response) : 0.0;
  }

  /// Converts gradients of the area coordinates with respect to the position of the followed point
  /// to gradients with respect to the position of the tip. On a curved body the two points move
  /// differently.
  void changeToTip(Eigen::Matrix3d& weightGradients, const TriangleCorners& corners,
    const ResponseField& response) const noexcept
  {
    if (this->IsFelt)
    {
      this->changeGradients(weightGradients, corners, response);
    }
  }

  /// Multiplies the work of the upright tool at a depth > 0 by τ. `weightGradients` are the
  /// gradients of the area coordinates with respect to the tip's position. If they are given, the
  /// differences of τ between the three corners are included; if null, they are neglected.
  void multiply(Jet& work, const TriangleCorners& corners, const Vector3& weights, double depth,
    const Eigen::Matrix3d* weightGradients) const noexcept
  {
    if (this->isTilted())
    {
      work *= this->factor(corners, weights, depth, weightGradients);
    }
  }

  /// The upright tool that has the same force as the tilted tool.
  struct Alike
  {
    double depth = 0.0; ///< mm
    ResponseValue value;
    double stiffening = 1.0; ///< stiffness of the tilted tool divided by that of the upright tool
  };
  /// Finds the upright tool with the same force. `tilted` is the slow response of the tilted tool
  /// at `depth`.
  Alike alike(
    const BlendedResponse& curve, double depth, const ResponseValue& tilted) const noexcept
  {
    return this->isTilted() && tilted.force > 0.0 ? this->findAlike(curve, depth, tilted)
                                                  : Alike{ depth, tilted, 1.0 };
  }

  /// Adds tilt and torque to the result, computed from the whole work. If `weightGradients` (with
  /// respect to the tip's position) are given, also adds the force -M ∇θ; null if the force form
  /// has no energy.
  void addTorque(const Jet& work, const TriangleCorners& corners,
    const Eigen::Matrix3d* weightGradients, const ResponseField& response,
    Contact& result) const noexcept
  {
    if (this->isTilted())
    {
      this->addMoment(work.byTilt, corners, weightGradients, response, result);
    }
  }

private:
  double leanAt(
    const TriangleCorners& corners, const Vector3& weights, const ResponseField& response) noexcept;
  void changeGradients(Eigen::Matrix3d& weightGradients, const TriangleCorners& corners,
    const ResponseField& response) const noexcept;
  /// Returns τ with its derivatives.
  Jet factor(const TriangleCorners& corners, const Vector3& weights, double depth,
    const Eigen::Matrix3d* weightGradients) const noexcept;
  Alike findAlike(
    const BlendedResponse& curve, double depth, const ResponseValue& tilted) const noexcept;
  void addMoment(double byTilt, const TriangleCorners& corners,
    const Eigen::Matrix3d* weightGradients, const ResponseField& response,
    Contact& result) const noexcept;

  const BodyTilt* Body;
  bool IsFelt = false;
  Vector3 Axis = Vector3::Zero();
  Vector3 Down = Vector3::Zero();   ///< unit vector from the tip to the followed point
  double Under = 0.0;               ///< distance between the tip and the followed point, mm
  Vector3 Normal = Vector3::Zero(); ///< smooth normal at the last contact
  /// Length of the interpolated normal before it was normalized to Normal.
  double NormalLength = 1.0;
  double Angle = 0.0;
  DeepestPoint Deepest;
};
} // namespace palpate

#endif
