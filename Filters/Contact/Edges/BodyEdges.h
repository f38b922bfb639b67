// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyEdges_h
#define palpate_BodyEdges_h

#include "Contact/Edges/EdgeChains.h"
#include "Contact/Edges/EdgeLaw.h"
#include "Contact/Jet.h"
#include "Contact/PackedMesh.h"
#include "Contact/Pressed.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/**
 * The sharp convex edges of a body, and their effect on a contact that is followed on one face.
 *
 * The turn of an edge is the angle between the normals of its two faces. At an edge with a turn of
 * BluntTurn or more, the contact stays on its face, and the plane of the face continues beyond the
 * edge. The work of the contact is W₀(δ) Π Ψ(d/a₀(δ)), where the product is over the nearby chains
 * of edges (EdgeLaw). The contact ends where this work is zero. Therefore the force does not drop
 * suddenly, and no energy is gained on any path. If the body is fixed at a depth h, the effect of
 * an edge is smaller: the softness 1/Ψ - 1 decreases as e^(-2.75 d/h) with the distance d from the
 * edge (finite elements of bonded blocks give 2.5 to 3.1, for d/h up to 0.5 and ν of 0.3 and 0.45).
 * An edge has no effect beyond a distance of Reach contact radii or 1.5 h. The effect fades from
 * half of that distance on.
 *
 * At a blunt edge (a smaller turn) the depths of both faces are combined: δ^-4 = δ_A^-4 + δ_B^-4.
 * The result is nearly the smaller of the two depths, except near the edge, where the surface of
 * equal depth is rounded with a radius of about the depth of the tip. While the direction of the
 * force rotates, the force changes by at most 0.0038 mm/δ of its magnitude per 1 µm of motion.
 * Directly under the edge the force of a sphere is 23 % less than far from it; on an elastic wedge
 * it is 3 % (30°) to 43 % (75°) less. The factor Ψ of sharp edges is then the sum of the factors of
 * the two faces, each weighted by the share of the face in δ^-4.
 *
 * A re-entrant edge needs no special treatment: the nearest point of the surface remains on the
 * edge, and the force rotates from the normal of one wall to that of the other.
 */
class PALPATE_EXPORT BodyEdges
{
public:
  /// The smallest turn (rad) of an edge at which the surface is cut.
  static constexpr double LeastTurn = 0.349; // 20°
  static constexpr double Reach = 32.0;

  /// `mesh` must be cut along its creases. `range` is the longest range of the curves, mm.
  BodyEdges(const PackedMesh& mesh, const EdgeTerms& terms, double range);

  /// Returns whether any edge affects a contact on a triangle.
  bool areNear(std::int32_t triangle) const noexcept
  {
    return this->Chains.near(triangle) != nullptr;
  }
  void prefetch(std::int32_t triangle) const noexcept { this->Chains.prefetch(triangle); }
  /// Computes the ContactReach of a tip. `depth` is its depth (mm) under the plane of the face,
  /// `normal` the normal of that plane. Local coordinates.
  ContactReach at(
    const Vector3& tip, std::int32_t triangle, const Vector3& normal, double depth) const noexcept;
  /// Sets Pressed::reach of a tool near or beyond edges. `tip` is the point that the tracker
  /// follows. Beyond an edge the plane of the face continues, and the contact point lies on this
  /// plane.
  void reach(const PackedMesh& mesh, const Vector3& tip, Pressed& pressed) const noexcept;

  const EdgeTerms& terms() const noexcept { return this->Terms; }
  /// Returns the memory used, bytes.
  std::size_t memory() const noexcept { return sizeof(*this) + this->Chains.memory(); }

private:
  class Faces;
  struct Softness;
  Softness softnessAt(double distance) const noexcept;
  /// Returns the product of the factors Ψ of all sharp edges of a face. `foot` is the tip's
  /// projection on the plane of the face.
  Jet shareOf(
    std::int32_t triangle, const Vector3& foot, const Vector3& normal, double depth) const noexcept;

  EdgeTerms Terms;
  EdgeLaw Law;
  EdgeChains Chains;
};
} // namespace palpate

#endif
