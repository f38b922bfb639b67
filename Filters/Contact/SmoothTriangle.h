// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SmoothTriangle_h
#define palpate_SmoothTriangle_h

#include "Mechanics/PalpateExport.h"
#include "Contact/TriangleProjection.h"

#include <array>

namespace palpate
{
/// A point of a surface and its derivatives by two parameters v and w.
struct PALPATE_EXPORT SurfaceJet
{
  Vector3 point = Vector3::Zero();
  Vector3 dv = Vector3::Zero();
  Vector3 dw = Vector3::Zero();
  Vector3 dvv = Vector3::Zero();
  Vector3 dvw = Vector3::Zero();
  Vector3 dww = Vector3::Zero();

  /// dv × dw: outward if the triangle is wound counter-clockwise seen from outside; not normalised.
  Vector3 across() const noexcept;
};

/**
 * A curved patch over one triangle, through its corners and perpendicular to their unit normals.
 *
 * It is the quartic Gregory patch of Walton and Meek (1996, A triangular G1 patch from boundary
 * curves, Computer-Aided Design 28). Over an edge the patch is a cubic that depends only on the
 * positions and normals of the two ends. The tangent plane along the edge depends on the same data:
 * it is spanned by the tangent of the curve and a quadratic blend of the two directions across the
 * edge. Therefore two neighbours meet in the same curve with the same tangent planes, although each
 * uses only its own three corners: the surface is G1. Nothing is stored in addition to the points
 * and the normals of the response. The interior control points that belong to two edges are blended
 * rationally (Gregory).
 *
 * Reason for this patch: cubic patches of one triangle (PN triangles, Nagata) have discontinuous
 * normals across edges, so that the closest point would still jump. Nielson's side-vertex
 * interpolant is G1 too, but costs three curves per evaluation. A Clough-Tocher split is
 * polynomial, but has three patches and three more edges across which the curvature jumps. With
 * equal normals perpendicular to the triangle, the patch is the flat triangle in its area
 * coordinates.
 *
 * One difference from the paper: the length of the end tangents of an edge is 2l/(1 + cos θ), where
 * l is the chord and θ its angle with the tangent plane. The middle of the cubic is then on the
 * circle if the ends are: on a sphere of radius R the error of the edges is O(l⁶/R⁵) and that of
 * the faces O(l⁴/R³), compared with l²/(6R) of the facet.
 *
 * Second derivatives are bounded, but jump across edges and depend on the direction at corners.
 * evaluate() may be called slightly outside the triangle. No function allocates or throws.
 */
class PALPATE_EXPORT SmoothTriangle
{
public:
  /// Smallest cosine (41°) between the normals of a corner and of the facet. A smaller cosine means
  /// a crease: the angle is 45° at the edges of a box, and 35° on a sphere in triangles as wide as
  /// its radius.
  static constexpr double SmallestCosine = 0.75;

  SmoothTriangle() noexcept;

  /// Points counter-clockwise seen from outside, normals outward. Returns false, and evaluate()
  /// must not be called, if a normal is zero, not finite or that of a crease, or if the triangle
  /// has no area.
  bool build(const std::array<Vector3, 3>& points, const std::array<Vector3, 3>& normals) noexcept;

  /// Evaluates at area coordinates u with the sum 1. The derivatives are by v = u_1 and w = u_2,
  /// with u_0 = 1 - v - w.
  SurfaceJet evaluate(const Vector3& u) const noexcept;

private:
  static constexpr int Order = 4;
  static constexpr int Points = 15;
  /// Index of the control point of u_0^(4-j-r) u_1^j u_2^r.
  static constexpr int index(int j, int r) noexcept
  {
    return r * (Order + 1) - r * (r - 1) / 2 + j;
  }

  struct Edge;
  static int alongEdge(int edge, int step) noexcept;
  static int insideEdge(int edge, int step) noexcept;

  /// Four doubles each, so that two can be processed at a time.
  std::array<Eigen::Vector4d, Points> Control;
  /// Half the difference of the two interior points that Gregory blends at each corner.
  std::array<Eigen::Vector4d, 3> Twist;
};
} // namespace palpate

#endif
