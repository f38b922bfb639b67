// SPDX-License-Identifier: BSD-3-Clause
// Input and results of a tick as plain values, from the closest point to the force.
#ifndef palpate_Contact_h
#define palpate_Contact_h

#include "Contact/TriangleProjection.h"

#include <Eigen/Core>

#include <cstdint>

namespace palpate
{
/// Pose of a tool in the body's frame, mm.
struct ToolPose
{
  /// The tool's axis is unknown and is assumed to be parallel to the body's normal.
  explicit ToolPose(const Eigen::Vector3d& at) noexcept
    : tip(at)
  {
  }
  /// `along` is the direction of the axis and need not have unit length. If it is zero or not
  /// finite, the axis is unknown.
  ToolPose(const Eigen::Vector3d& at, const Eigen::Vector3d& along) noexcept
    : tip(at)
  {
    const double length = along.norm();
    if (length > 0.0 && along.allFinite())
    {
      this->axis = along / length;
    }
  }

  bool hasAxis() const noexcept { return !this->axis.isZero(0.0); }

  Eigen::Vector3d tip; ///< position of the tip, on the tool's axis
  /// Unit vector from the tip up the shaft; zero if the axis is unknown.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
};

/// The closest point of a body: its triangle (-1 if there is none), its position on the triangle,
/// and the side of the surface on which the tip is.
struct SurfacePoint
{
  std::int32_t triangle = -1; ///< index in the PackedMesh, not in the input
  TriangleProjection projection;
  /// Distance from the surface to the tip, mm: positive outside, negative inside.
  double signedDistance = 0.0;
  /// Whether the closest point is on an open border, where inside and outside are not defined.
  bool onBorder = false;
  /// Whether the closest point is on a sharp edge at which the surface was cut
  /// (PackedMesh::Crease). Then the side of the tip is determined only from the face of this
  /// triangle.
  bool onCrease = false;
};

/// The closest point followed by a tracker, and its derivatives with respect to the tip's position.
/// Normal and gradients are those of the smooth surface or those of EnergyGradient::onFacet.
struct ContactPlace : SurfacePoint
{
  bool isSmooth = false; ///< whether the contact is on the smooth surface instead of the facets
  /// Unit normal of the surface, outward. At an edge or corner of facets it points from the tip to
  /// the closest point.
  Vector3 normal = Vector3::Zero();
  /// Column i: gradient of area coordinate i with respect to the tip's position, 1/mm; tangential.
  Eigen::Matrix3d weightGradients = Eigen::Matrix3d::Zero();
};

/// State of a contact.
enum class ContactState : std::uint8_t
{
  None,
  Stick,
  Slide,
  BeyondRange,
  LostAtBorder,
  Invalid,
  /// The tilt exceeds the response's largest tilt; the force is that at the largest tilt.
  TiltedTooFar
};

/// Result of one tick for a tool, in the body's frame: force (N), torque (N mm), contact point (mm)
/// and state.
struct Contact
{
  ContactState state = ContactState::None;
  Vector3 force = Vector3::Zero();    ///< total force on the tool, N
  Vector3 friction = Vector3::Zero(); ///< part of `force` that is due to friction, N
  /// Torque on the tool about its tip, N mm; zero if its axis is unknown or the response has no
  /// tilt data.
  Vector3 torque = Vector3::Zero();
  double normalForce = 0.0;
  /// Part of normalForce, N, that a relaxing body adds to the slow force.
  double memory = 0.0;
  double stiffness = 0.0;           ///< sum of n_i dF_i/dδ over the corners, N/mm
  double deflection = 0.0;          ///< δ, depth of the tool's deepest point, mm
  double tilt = 0.0;                ///< angle between the tool's axis and the normal, rad
  Vector3 normal = Vector3::Zero(); ///< unit normal, outward; normalForce acts along it
  Vector3 contactPoint = Vector3::Zero();
  std::int32_t triangle = -1; ///< index in the input; -1 if there is no contact
};
} // namespace palpate

#endif
