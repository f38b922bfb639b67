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

/// What a tick needs of a tool and a body to leave over an edge; of a body whose edges are not felt
/// the exponent is 0.
struct EdgeTerms
{
  double exponent = 0.0;     ///< m of F ∝ δ^m far inside: 1 flat, 1.5 sphere, 2 cone
  double radius = 0.0;       ///< of the contact at a depth of 1 mm, mm: a₀ = radius δ^(m-1)
  double poissonRatio = 0.5; ///< of the body
  /// How deep (mm) the body goes until it is held, by a layer's base or its own other side: from
  /// there an edge is not felt; 0: endless.
  double extent = 0.0;
  /// The curves know the edge already, as those of finite elements do: only what lies beyond it is
  /// missing.
  bool isInCurves = false;

  bool areFelt() const noexcept { return this->exponent > 0.0 && this->radius > 0.0; }
};

/// What is wrong with them, naming it and the number; "" for what can be felt, or for none.
PALPATE_EXPORT std::string faultOfEdges(const EdgeTerms& terms);

/// Of a tool down to a depth (mm) that it can be pressed, on a body of Poisson's ratio ν: m and the
/// contact radius are those of a half-space at that depth.
PALPATE_EXPORT EdgeTerms edgeTermsOf(
  const AxisymmetricTool& tool, double deflection, double poissonRatio);

/**
 * How much of a contact's work is left beside the straight edge of an elastic body: W = W₀(δ) Ψ(u),
 * with W₀ the work at the same depth far inside, u = d/a₀(δ), d the distance of the tool's axis
 * from the edge (> 0 inside) and a₀ its contact radius far inside. With an energy it follows that
 *   F = F₀ Ψ - W₀ Ψ' u a₀'/a₀,   F_side = W₀ Ψ'/a₀, off the body:
 * nothing is gained on closed paths, and the tool leaves as an elastic body lets it, at u = -1 (a
 * flat), -√2 (a paraboloid), -π/2 (a cone).
 *
 * Ψ of a right edge: Hetényi's two overlapping half-spaces (Data/Reference/edges/edge_law.csv), a
 * C¹ spline through values and slopes, between the m of the table by m, between its ν by ln ψ
 * (pointLoadSoftness). Beyond u = 8 it is u/(u + k). The very end differs: force and sideways force
 * go to nothing together, for a flat at u = -1.175, where the table's sideways force would end with
 * a knock. An edge of another angle: the softness of the edge, 1/Ψ - 1, by its sharpness.
 */
class PALPATE_EXPORT EdgeLaw
{
public:
  /// Ψ and its derivatives by u.
  struct Value
  {
    double share = 1.0;
    double slope = 0.0;
    double bend = 0.0;
  };

  EdgeLaw() = default;
  explicit EdgeLaw(const EdgeTerms& terms);

  /// `sharpness`: see edgeSharpness; 1 for a right edge.
  Value at(double u, double sharpness) const noexcept;
  /// Where nothing is left: -u, > 0.
  double end() const noexcept { return this->End; }

private:
  static constexpr double TailStart = 8.0;
  static constexpr std::size_t Cells = 160; ///< from the end to where the tail starts

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

/// ψ of a point load at distance d from a right edge: C = ψ/(2πE* d) is how much softer it is than
/// a half-space. Within 0.02 (Data/Reference: Hetényi's quarter space).
PALPATE_EXPORT double pointLoadSoftness(double poissonsRatio);

/// ψ of a point load at distance d from an edge where the surface turns by an angle (rad), over
/// that of a right one. An edge that turns by little takes far less than in proportion, as what is
/// missing lies where hardly any strain is: with t = tan of half the angle, t³, and for bodies that
/// change their volume up to a quarter of t; t^3.4 beyond a right angle, to 120° (a thinner wedge
/// counts as that). At most 1.4 times what finite elements find, or 0.13 of a right angle's more,
/// and not less (Data/Reference/edges/wedge_point_law.csv).
PALPATE_EXPORT double edgeSharpness(double poissonsRatio, double turn);
} // namespace palpate

#endif
