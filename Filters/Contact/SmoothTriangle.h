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

  /// dv × dw: outward where the triangle winds counter-clockwise seen from outside; not unit.
  Vector3 across() const noexcept;
};

/**
 * A curved patch over one triangle, through its corners and perpendicular to their unit normals.
 *
 * It is the quartic Gregory patch of Walton and Meek (1996, A triangular G1 patch from boundary
 * curves, Computer-Aided Design 28). An edge becomes a cubic that follows from the positions and
 * normals of its two ends alone, and so does the plane that the patch touches along it: a quadratic
 * blend of the two directions across the edge, and the tangent of the curve. So two neighbours,
 * each knowing only its own three corners, meet in the same curve with the same tangent planes: the
 * surface is G1. Nothing is stored beyond the points and the normals that a response has anyway.
 * The interior control points that belong to two edges are blended rationally (Gregory).
 *
 * Why this one: cubic patches of one triangle (PN triangles, Nagata) have gaps in the normal across
 * edges, so the closest point would still jump; Nielson's side-vertex interpolant is G1 too, but
 * costs three curves per evaluation; a Clough-Tocher split is polynomial, but has three patches and
 * three more edges where the curvature jumps. Flat data give the flat triangle in its own area
 * coordinates.
 *
 * One thing differs from the paper: the end tangents of an edge are 2l/(1 + cos θ) long, l the
 * chord and θ its angle with the tangent plane. The middle of the cubic then lies on the circle
 * when the ends do: on a sphere of radius R the edges are off by O(l⁶/R⁵), the faces by O(l⁴/R³),
 * where the facet is off by l²/(6R).
 *
 * Second derivatives are bounded, but jump across edges and depend on the direction at corners.
 * evaluate() may be called a little outside of the triangle. Nothing allocates or throws.
 */
class PALPATE_EXPORT SmoothTriangle
{
public:
  /// A corner normal that makes a smaller cosine than this with the facet's (41°) belongs to a
  /// crease: the edges of a box (45°), not a sphere in triangles as wide as its radius (35°).
  static constexpr double SmallestCosine = 0.75;

  SmoothTriangle() noexcept;

  /// Points counter-clockwise seen from outside, normals outward. False, and nothing to evaluate,
  /// when a normal is zero, not finite or of a crease, or when the triangle has no area.
  bool build(const std::array<Vector3, 3>& points, const std::array<Vector3, 3>& normals) noexcept;

  /// At area coordinates u of sum 1; derivatives by v = u_1 and w = u_2, u_0 taking the rest.
  SurfaceJet evaluate(const Vector3& u) const noexcept;

private:
  static constexpr int Order = 4;
  static constexpr int Points = 15;
  /// Of the control point of u_0^(4-j-r) u_1^j u_2^r.
  static constexpr int index(int j, int r) noexcept
  {
    return r * (Order + 1) - r * (r - 1) / 2 + j;
  }

  struct Edge;
  static int alongEdge(int edge, int step) noexcept;
  static int insideEdge(int edge, int step) noexcept;

  /// Of four doubles, so that two are worked on at a time.
  std::array<Eigen::Vector4d, Points> Control;
  /// Half the difference of the two interior points that Gregory blends at each corner.
  std::array<Eigen::Vector4d, 3> Twist;
};
} // namespace palpate

#endif
