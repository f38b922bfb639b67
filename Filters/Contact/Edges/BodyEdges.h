// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyEdges_h
#define palpate_BodyEdges_h

#include "Contact/Edges/EdgeChains.h"
#include "Contact/Edges/EdgeLaw.h"
#include "Contact/PackedMesh.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// What the sharp edges around a contact do to it, all as functions of the tip's place alone.
struct EdgeEffect
{
  double depth = 0.0; ///< δ, mm, at which the curve is to be taken; <= 0: no contact
  /// Of the normals of depth: that of the contact's own face, and the sum of the others'.
  double ownNormal = 1.0;
  Vector3 otherNormals = Vector3::Zero();
  /// Ψ, of the work at that depth, and how it changes with the depth (1/mm, 1/mm²) and with the
  /// place at the same depth.
  double share = 1.0;
  double byDepth = 0.0;
  double byDepthTwice = 0.0;
  Vector3 byPlace = Vector3::Zero();
  /// The triangle on the other side of a blunt edge, where that is nearer; else -1.
  std::int32_t nearerAcross = -1;
};

/**
 * The sharp convex edges of a body, as a contact feels them that is followed on one face.
 *
 * Over an edge of BluntTurn and more the contact stays with its face, whose plane goes on: it has
 * the work W₀(δ) Π Ψ(d/a₀(δ)), over the chains of edges nearby (EdgeLaw; at a corner the product),
 * and ends where nothing is left of it. So no force drops and no energy is gained, whatever the
 * way. A base at a depth h holds what an edge lets go: the softness 1/Ψ - 1 falls as e^(-2.75 d/h)
 * with the distance from the edge (finite elements of bonded blocks: 2.5 to 3.1, d/h to 0.5, ν 0.3
 * and 0.45). More than Reach contact radii away, or 1.5 h, an edge is not felt; it fades from half
 * of that.
 *
 * Over a blunt edge the depth is that of both faces: δ^-4 = δ_A^-4 + δ_B^-4, nearly the lesser of
 * the two but beside the edge, which is a fillet as large as the tip is deep. Over a micrometre the
 * force turns by no more than 0.0038 mm/δ of itself; right under the edge a sphere's is 23 % less
 * than far from it, where an elastic wedge takes 3 % (30°) to 43 % (75°). What is left beside sharp
 * edges is then that of each face, by its part of the sum.
 *
 * A re-entrant edge needs nothing: the nearest point of the surface stays on it, and the force
 * turns from wall to wall.
 */
class PALPATE_EXPORT BodyEdges
{
public:
  /// The least turn (rad) of a surface to be cut for this.
  static constexpr double LeastTurn = 0.349; // 20°
  static constexpr double Reach = 32.0;

  /// `mesh` is cut along its creases; `range` is the longest of its curves, mm.
  BodyEdges(const PackedMesh& mesh, const EdgeTerms& terms, double range);

  /// Whether any edge is felt over a triangle.
  bool areNear(std::int32_t triangle) const noexcept
  {
    return this->Chains.near(triangle) != nullptr;
  }
  void prefetch(std::int32_t triangle) const noexcept { this->Chains.prefetch(triangle); }
  /// The effect on a contact `depth` under the plane whose normal is `normal`; local coordinates.
  EdgeEffect at(
    const Vector3& tip, std::int32_t triangle, const Vector3& normal, double depth) const noexcept;

  const EdgeTerms& terms() const noexcept { return this->Terms; }
  /// Bytes held.
  std::size_t memory() const noexcept { return sizeof(*this) + this->Chains.memory(); }

private:
  class Faces;
  struct Share;
  struct Softness;
  Softness softnessAt(double distance) const noexcept;
  Share shareOf(
    std::int32_t triangle, const Vector3& foot, const Vector3& normal, double depth) const noexcept;

  EdgeTerms Terms;
  EdgeLaw Law;
  EdgeChains Chains;
};
} // namespace palpate

#endif
