// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmoothTriangle_h
#define palpate_SmoothTriangle_h

#include "Mechanics/PalpateExport.h"
#include "Contact/TriangleProjection.h"

#include <array>

namespace palpate
{
/// A point of a surface and its derivatives with respect to two parameters v and w.
struct PALPATE_EXPORT SurfaceJet
{
  Vector3 point = Vector3::Zero();
  Vector3 dv = Vector3::Zero();
  Vector3 dw = Vector3::Zero();
  Vector3 dvv = Vector3::Zero();
  Vector3 dvw = Vector3::Zero();
  Vector3 dww = Vector3::Zero();

  /// Returns dv × dw, which is not normalised. It points outward if the triangle is wound
  /// counter-clockwise as seen from outside.
  Vector3 across() const noexcept;
};

/**
 * A curved patch over one triangle, through its corners and perpendicular to their unit normals.
 *
 * The patch is the quartic Gregory patch of Walton and Meek (1996, A triangular G1 patch from
 * boundary curves, Computer-Aided Design 28). Over an edge the patch is a cubic that depends only
 * on the positions and normals of the two ends. The tangent plane along the edge depends on the
 * same data: it is spanned by the tangent of the curve and a quadratic interpolation between the
 * directions across the edge at its two ends. Therefore two neighbouring patches meet in the same
 * curve with the same tangent planes, although each patch uses only its own three corners: the
 * surface is G1. Only the points and the normals of the response need to be stored. An interior
 * control point that belongs to two edges is a rational mean of two points (Gregory).
 *
 * Other patches were rejected for the following reasons. Cubic patches of one triangle (PN
 * triangles, Nagata) have discontinuous normals across edges, so that the closest point would still
 * jump. Nielson's side-vertex interpolant is G1 too, but needs three curves per evaluation. A
 * Clough-Tocher split is polynomial, but has three patches and three more edges across which the
 * curvature jumps. If all normals are perpendicular to the triangle, the patch is the flat
 * triangle, parametrised by its area coordinates.
 *
 * There is one difference from the paper: the length of the end tangents of an edge is 2l/(1 + cos
 * θ), where l is the length of the chord and θ its angle with the tangent plane. If the ends are on
 * a circle, the middle of the cubic is then on the circle too. On a sphere of radius R the error of
 * the edges is O(l⁶/R⁵) and that of the faces O(l⁴/R³), compared with l²/(6R) for the facet.
 *
 * Second derivatives are bounded, but they jump across edges and depend on the direction at
 * corners. evaluate() may be called slightly outside the triangle. No function allocates or throws.
 */
class PALPATE_EXPORT SmoothTriangle
{
public:
  /// Smallest allowed cosine (angle 41°) between the normal at a corner and that of the facet. A
  /// smaller cosine indicates a crease. The angle is 45° at the edges of a box, and 35° on a sphere
  /// with triangles as wide as its radius.
  static constexpr double SmallestCosine = 0.75;

  SmoothTriangle() noexcept;

  /// Computes the control points. The points must be counter-clockwise as seen from outside, and
  /// the normals outward. Returns false if a normal is zero, not finite or that of a crease, or if
  /// the triangle has no area; then evaluate() must not be called.
  bool build(const std::array<Vector3, 3>& points, const std::array<Vector3, 3>& normals) noexcept;

  /// Evaluates the patch at area coordinates u with the sum 1. The derivatives are with respect to
  /// v = u_1 and w = u_2, with u_0 = 1 - v - w.
  SurfaceJet evaluate(const Vector3& u) const noexcept;

private:
  static constexpr int Order = 4;
  static constexpr int Points = 15;
  /// Returns the index of the control point of u_0^(4-j-r) u_1^j u_2^r.
  static constexpr int index(int j, int r) noexcept
  {
    return r * (Order + 1) - r * (r - 1) / 2 + j;
  }

  struct Edge;
  static int alongEdge(int edge, int step) noexcept;
  static int insideEdge(int edge, int step) noexcept;

  /// Padded to four doubles, so that several can be processed at a time.
  std::array<Eigen::Vector4d, Points> Control;
  /// Half the difference of the two interior points that are averaged at each corner (Gregory).
  std::array<Eigen::Vector4d, 3> Twist;
};
} // namespace palpate

#endif
