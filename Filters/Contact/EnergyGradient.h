// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EnergyGradient_h
#define palpate_EnergyGradient_h

#include "Contact/PackedMesh.h"

#include <Eigen/Geometry>

namespace palpate
{
/**
 * The force as the negative gradient of an energy. Let the contact point have the area coordinates
 * n_i and the tip the depth δ. At depth δ the curves of the corners have the forces f_i(δ) and the
 * work e_i(δ) = ∫₀^δ f_i. Then
 *   E = Σ n_i e_i,   F = -∇E = Σ n_i f_i n - Σ e_i ∇n_i,
 * because ∇δ = -n, where n is the unit vector from the tip to the contact point (the surface's
 * outward normal). A force along the normal alone lacks the second sum. With different responses,
 * pressing at one point and unloading at another would then gain the difference of the works e. As
 * Σ ∇n_i = 0, the second sum vanishes for equal responses. Only with both sums in exactly this form
 * does no closed path of a tip within one contact gain or lose energy. The direction of F is not
 * continuous: the ∇n_i jump across edges, and the second sum jumps with them by the second
 * differences of e.
 */
struct EnergyGradient
{
  /// Column i is ∇n_i on the triangle abc with respect to the tip's position, 1/mm. It is in the
  /// plane of the triangle if the closest point is on the face, along the edge if it is on an edge,
  /// and zero if it is at a corner.
  static Eigen::Matrix3d facetWeightGradients(
    TriangleFeature feature, const Vector3& a, const Vector3& b, const Vector3& c) noexcept;

  /// Returns the point of a mesh closest to a tip, with its normal and gradients. The tip and the
  /// point must be in the same frame.
  static ContactPlace onFacet(
    const PackedMesh& mesh, const Vector3& tip, const SurfacePoint& surface) noexcept;

  /// Returns Σ e_i ∇n_i, N. Element i of `energies` is e_i, N mm. A constant added to all three
  /// energies has no effect.
  static Vector3 ofEnergies(
    const Eigen::Matrix3d& weightGradients, const Vector3& energies) noexcept
  {
    return weightGradients.col(1) * (energies[1] - energies[0]) +
      weightGradients.col(2) * (energies[2] - energies[0]);
  }
};

inline Eigen::Matrix3d EnergyGradient::facetWeightGradients(
  TriangleFeature feature, const Vector3& a, const Vector3& b, const Vector3& c) noexcept
{
  Eigen::Matrix3d gradients = Eigen::Matrix3d::Zero();
  const auto alongEdge = [&](int from, int to, const Vector3& edge)
  {
    gradients.col(to) = edge / edge.squaredNorm();
    gradients.col(from) = -gradients.col(to);
  };
  switch (feature)
  {
    case TriangleFeature::Face:
    {
      const Vector3 normal = (b - a).cross(c - a);
      const Vector3 scaled = normal / normal.squaredNorm();
      gradients.col(0) = scaled.cross(c - b);
      gradients.col(1) = scaled.cross(a - c);
      gradients.col(2) = scaled.cross(b - a);
      break;
    }
    case TriangleFeature::Edge0:
      alongEdge(0, 1, b - a);
      break;
    case TriangleFeature::Edge1:
      alongEdge(1, 2, c - b);
      break;
    case TriangleFeature::Edge2:
      alongEdge(2, 0, a - c);
      break;
    default:
      break;
  }
  return gradients;
}

inline ContactPlace EnergyGradient::onFacet(
  const PackedMesh& mesh, const Vector3& tip, const SurfacePoint& surface) noexcept
{
  ContactPlace place{ surface };
  place.weightGradients =
    facetWeightGradients(surface.projection.feature, mesh.corner(surface.triangle, 0),
      mesh.corner(surface.triangle, 1), mesh.corner(surface.triangle, 2));
  if (surface.projection.feature == TriangleFeature::Face || surface.signedDistance == 0.0)
  {
    place.normal = mesh.faceNormal(surface.triangle);
  }
  else
  {
    place.normal = (tip - surface.projection.point) / surface.signedDistance;
  }
  return place;
}
} // namespace palpate

#endif
