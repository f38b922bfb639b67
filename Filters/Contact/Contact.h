// SPDX-License-Identifier: BSD-3-Clause
// Input and results of a tick, from the closest point to the force, as plain values.
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
  /// The axis is unknown, and taken to be the body's normal.
  explicit ToolPose(const Eigen::Vector3d& at) noexcept
    : tip(at)
  {
  }
  /// `along`: any length; zero or not finite: unknown.
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

  Eigen::Vector3d tip;                            ///< on the tool's axis
  Eigen::Vector3d axis = Eigen::Vector3d::Zero(); ///< unit, from the tip up the shaft; or zero
};

/// The closest point of a body: its triangle (-1: none), the place on it, and the side of the tip.
struct SurfacePoint
{
  std::int32_t triangle = -1; ///< of the PackedMesh, not of the input
  TriangleProjection projection;
  /// Distance from the surface to the tip, mm: > 0 outside, < 0 inside.
  double signedDistance = 0.0;
  /// The closest point is on an open border, where inside and outside are not defined.
  bool onBorder = false;
  /// The closest point is where the surface was cut along a sharp edge (PackedMesh::Crease): the
  /// side of the tip is that of the triangle's own face alone.
  bool onCrease = false;
};

/// A closest point that is followed, with its motion by the tip. Normal and gradients are those of
/// the smooth surface, or of EnergyGradient::onFacet.
struct ContactPlace : SurfacePoint
{
  bool isSmooth = false; ///< on the smooth surface, or on the facets
  /// Surface normal, unit, outward; at an edge or corner of facets from the tip to the point.
  Vector3 normal = Vector3::Zero();
  /// Column i: gradient of area coordinate i as the tip moves, 1/mm; tangential.
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
  TiltedTooFar ///< the force is that at the response's largest tilt
};

/// Result of one tick for a tool: force, torque, place and state. Body frame; mm, N, N/mm.
struct Contact
{
  ContactState state = ContactState::None;
  Vector3 force = Vector3::Zero();    ///< total, on the tool
  Vector3 friction = Vector3::Zero(); ///< its part that is friction
  /// Torque on the tool about its tip, N mm; zero if its axis is unknown, or the response has no
  /// tilt data.
  Vector3 torque = Vector3::Zero();
  double normalForce = 0.0;
  /// Part of normalForce in addition to the slow response, for a body that relaxes.
  double memory = 0.0;
  double stiffness = 0.0;           ///< Σ n_i dF_i/dδ
  double deflection = 0.0;          ///< of the deepest point of the tool
  double tilt = 0.0;                ///< of the axis from the normal, rad
  Vector3 normal = Vector3::Zero(); ///< unit, outward, along which normalForce acts
  Vector3 contactPoint = Vector3::Zero();
  std::int32_t triangle = -1; ///< of the input; -1: none
};
} // namespace palpate

#endif
