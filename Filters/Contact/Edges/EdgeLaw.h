// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EdgeLaw_h
#define palpate_EdgeLaw_h

#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <string>

namespace palpate
{
class AxisymmetricTool;

/// Data of a tool and a body for contacts that leave the body over an edge. The exponent is 0 if
/// edges have no effect.
struct EdgeTerms
{
  /// m of F ∝ δ^m far from the edge: 1 for a flat end, 1.5 for a sphere, 2 for a cone.
  double exponent = 0.0;
  double radius = 0.0; ///< contact radius at a depth of 1 mm, mm: a₀ = radius δ^(m-1), with δ in mm
  double poissonRatio = 0.5; ///< Poisson's ratio of the body
  /// Depth (mm) at which the body is fixed: that of the base of a layer, or of the opposite side of
  /// the body. An edge has no effect at a distance of more than 1.5 times this depth. 0 for a
  /// half-space.
  double extent = 0.0;
  /// Whether the curves already contain the effect of the edge, as curves from finite elements do.
  /// Then only the effect beyond the edge is added.
  bool isInCurves = false;

  bool areFelt() const noexcept { return this->exponent > 0.0 && this->radius > 0.0; }
};

/// Checks the terms. Returns "" if they are valid, else a message with the name and the value of
/// the invalid term.
PALPATE_EXPORT std::string faultOfEdges(const EdgeTerms& terms);

/// Returns the terms of a tool that is pressed to `deflection` (mm) on a body with Poisson's ratio
/// `poissonRatio`. The exponent m and the contact radius are those on a half-space at that
/// deflection.
PALPATE_EXPORT EdgeTerms edgeTermsOf(
  const AxisymmetricTool& tool, double deflection, double poissonRatio);

/**
 * Fraction Ψ of a contact's work that remains near the straight edge of an elastic body: W = W₀(δ)
 * Ψ(u). W₀ is the work at the same depth far from the edge, and a₀ is the contact radius there. u =
 * d/a₀(δ), where d is the distance of the tool's axis from the edge, positive inside the body. The
 * forces follow from this energy:
 *   F = F₀ Ψ - W₀ Ψ' u a₀'/a₀,   F_side = W₀ Ψ'/a₀, away from the body.
 * Therefore no energy is gained on closed paths. The tool loses contact with an elastic body at u =
 * -1 (flat), -√2 (paraboloid) or -π/2 (cone).
 *
 * Ψ of a right-angled edge comes from Hetényi's two overlapping half-spaces
 * (Data/Reference/edges/edge_law.csv). It is a C¹ spline through values and slopes. Between the
 * tabulated exponents m the interpolation is linear; between the tabulated ν, ln ψ is interpolated
 * (pointLoadSoftness). Beyond u = 8, Ψ is u/(u + k). The outer end of the spline is modified so
 * that normal and sideways force vanish together, for a flat end at u = -1.175; with the unmodified
 * table the sideways force would drop in one step. For an edge with another angle, the softness of
 * the edge, 1/Ψ - 1, is multiplied by its sharpness.
 */
class PALPATE_EXPORT EdgeLaw
{
public:
  /// Ψ and its first and second derivatives with respect to u.
  struct Value
  {
    double share = 1.0;
    double slope = 0.0;
    double bend = 0.0;
  };

  EdgeLaw() = default;
  explicit EdgeLaw(const EdgeTerms& terms);

  /// Evaluates Ψ at `u`. `sharpness` is that of edgeSharpness(); it is 1 for a right-angled edge.
  Value at(double u, double sharpness) const noexcept;
  /// Returns the distance end() > 0 such that Ψ is 0 for u <= -end().
  double end() const noexcept { return this->End; }

private:
  static constexpr double TailStart = 8.0;
  static constexpr std::size_t Cells = 160; ///< number of cells between the end and the tail

  struct Node
  {
    double value;
    double slope;
  };

  Value rightEdge(double u) const noexcept;

  double End = 1.0;
  bool IsInCurves = false;
  double Tail = 0.0; ///< k of u/(u + k)
  double CellWidth = 1.0;
  std::array<Node, Cells + 1> Nodes{};
};

/// Returns the softness ψ for a point load at distance d from a right-angled edge: the edge adds C
/// = ψ/(2πE* d) to the compliance of a half-space. The error is at most 0.02 (Data/Reference:
/// Hetényi's quarter space).
PALPATE_EXPORT double pointLoadSoftness(double poissonRatio);

/// Returns ψ for a point load near an edge whose two faces have normals that differ by the angle
/// `turn` (rad), divided by ψ of a right-angled edge. At a small angle the effect is far less than
/// proportional to the angle, because the missing material would hardly be strained. With t =
/// tan(turn/2), the ratio is t³ up to a right angle, of which up to a quarter is replaced by t for
/// compressible bodies. Beyond a right angle it is t^3.4, up to 120°; a larger angle counts as
/// 120°. Compared with finite elements, the ratio is never smaller, and is at most 1.4 times as
/// large or larger by at most 0.13 (Data/Reference/edges/wedge_point_law.csv).
PALPATE_EXPORT double edgeSharpness(double poissonRatio, double turn);
} // namespace palpate

#endif
