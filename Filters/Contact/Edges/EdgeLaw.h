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

/// Data of a tool and a body for contacts that leave the body over an edge. If edges have no
/// effect, the exponent is 0.
struct EdgeTerms
{
  double exponent = 0.0;     ///< m of F ∝ δ^m far inside: 1 flat, 1.5 sphere, 2 cone
  double radius = 0.0;       ///< contact radius at a depth of 1 mm, mm: a₀ = radius δ^(m-1)
  double poissonRatio = 0.5; ///< Poisson's ratio of the body
  /// Depth (mm) at which the body is fixed, by the base of a layer or by its own opposite side. An
  /// edge farther away than 1.5 times this depth has no effect. 0: a half-space.
  double extent = 0.0;
  /// Whether the curves already contain the effect of the edge, as curves from finite elements do.
  /// Then only the effect beyond the edge is added.
  bool isInCurves = false;

  bool areFelt() const noexcept { return this->exponent > 0.0 && this->radius > 0.0; }
};

/// Checks the terms. Returns "" if they can be used, else a message that names the term and its
/// number.
PALPATE_EXPORT std::string faultOfEdges(const EdgeTerms& terms);

/// Terms of a tool that is pressed to `deflection` (mm) on a body of Poisson's ratio ν. The
/// exponent m and the contact radius are those on a half-space at that deflection.
PALPATE_EXPORT EdgeTerms edgeTermsOf(
  const AxisymmetricTool& tool, double deflection, double poissonRatio);

/**
 * The part of a contact's work that remains near the straight edge of an elastic body: W = W₀(δ)
 * Ψ(u). W₀ is the work at the same depth far inside, u = d/a₀(δ), d the distance of the tool's axis
 * from the edge (> 0 inside), and a₀ the contact radius far inside. The forces follow from this
 * energy:
 *   F = F₀ Ψ - W₀ Ψ' u a₀'/a₀,   F_side = W₀ Ψ'/a₀, away from the body.
 * Therefore no energy is gained on closed paths, and the tool leaves an elastic body at u = -1
 * (flat), -√2 (paraboloid), -π/2 (cone).
 *
 * Ψ of a right-angled edge comes from Hetényi's two overlapping half-spaces
 * (Data/Reference/edges/edge_law.csv). It is a C¹ spline through values and slopes, interpolated
 * linearly in m between the m of the table, and in ln ψ between its ν (pointLoadSoftness). Beyond u
 * = 8, Ψ is u/(u + k). The outer end is modified so that normal and sideways force vanish together,
 * for a flat at u = -1.175; with the table alone the sideways force would drop in one step. For an
 * edge of another angle, the softness of the edge, 1/Ψ - 1, is multiplied by its sharpness.
 */
class PALPATE_EXPORT EdgeLaw
{
public:
  /// Ψ and its first and second derivative by u.
  struct Value
  {
    double share = 1.0;
    double slope = 0.0;
    double bend = 0.0;
  };

  EdgeLaw() = default;
  explicit EdgeLaw(const EdgeTerms& terms);

  /// `sharpness` is that of edgeSharpness(); 1 for a right-angled edge.
  Value at(double u, double sharpness) const noexcept;
  /// Ψ is 0 for u <= -end(); end() > 0.
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

/// ψ of a point load at distance d from a right-angled edge: the edge adds C = ψ/(2πE* d) to the
/// compliance of a half-space. Within 0.02 (Data/Reference: Hetényi's quarter space).
PALPATE_EXPORT double pointLoadSoftness(double poissonRatio);

/// ψ of a point load at distance d from an edge at which the surface turns by the angle `turn`
/// (rad), divided by ψ of a right-angled edge. The effect of an edge with a small turn is far less
/// than proportional to the turn, because the missing material would hardly be strained. With t =
/// tan of half the angle: up to a right angle t³, of which up to a quarter is replaced by t for
/// compressible bodies; beyond a right angle t^3.4, up to 120° (a thinner wedge counts as 120°).
/// Compared with finite elements the result is at most 1.4 times as large, or larger by 0.13 of the
/// value of a right angle, and never smaller (Data/Reference/edges/wedge_point_law.csv).
PALPATE_EXPORT double edgeSharpness(double poissonRatio, double turn);
} // namespace palpate

#endif
