// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyCoupling_h
#define palpate_BodyCoupling_h

#include "Contact/Coupled/CouplingTerms.h"
#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"
#include "Contact/ResponseField.h"
#include "Mechanics/Coupling/CouplingLaw.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/**
 * By how much a force at one place of a body lets the surface down at another, mm/N:
 *   C_ij = (n_i·n_j)⁺ g(r/h) / (πr √(E*_i E*_j)) + Σ_m φ_m(i) φ_m(j),
 * g of CouplingLaw, h = √(h_i h_j), r the straight distance, no less than the sum of the contact
 * radii: nearer, rigid tools collide. Places that face away from each other feel nothing through
 * the surface, only what the modes of the body tell. Symmetric; with g = 1 and the contacts' own
 * compliance 1/K_i on the diagonal positive definite, so that forces exist and are unique.
 *
 * All of it is a function of the area coordinates of the two places, with its gradients, so that
 * contacts that move have an energy. Immutable, safe from any number of threads.
 */
class PALPATE_EXPORT BodyCoupling
{
public:
  /// A contact, as others feel it.
  struct Spot
  {
    TriangleCorners corners{};
    Vector3 point = Vector3::Zero();  ///< local
    Vector3 normal = Vector3::Zero(); ///< unit: the blended one
    double normalLength = 1.0;        ///< before it was
    double modulus = 0.0;
    double thickness = 0.0;
    double radius = 0.0;
    std::array<double, CouplingTerms::MostModes> modes{};
  };

  /// `response` is the body's, of the same mesh; both must outlive this. Terms without fault.
  BodyCoupling(const PackedMesh& mesh, const ResponseField& response, const CouplingTerms& terms);

  /// Of a contact of this stiffness (N/mm).
  Spot at(std::int32_t triangle, const Vector3& weights, double stiffness) const noexcept;
  /// C_ij, mm/N.
  double compliance(const Spot& one, const Spot& other) const noexcept;
  /// Its derivatives by the area coordinates of the first, but for a common constant; zero of the
  /// surface's part where the distance is held.
  Vector3 gradient(const Spot& of, std::int32_t triangle, const Spot& other) const noexcept;

  bool hasModes() const noexcept { return this->ModeCount > 0; }

private:
  /// What of C_ij the surface has.
  struct Surface
  {
    double value = 0.0;
    double facing = 0.0; ///< n_i·n_j, at least 0
    double byDistance = 0.0;
    double byThickness = 0.0; ///< by ln h_i
    Vector3 away = Vector3::Zero();
  };
  Surface surface(const Spot& one, const Spot& other) const noexcept;
  /// E*, h and modes of a point.
  const float* record(std::int32_t point) const noexcept
  {
    return this->Records.data() + this->Stride * static_cast<std::size_t>(point);
  }

  const PackedMesh& Mesh;
  const ResponseField& Response;
  CouplingLaw Law;
  bool HasSurface;
  std::size_t ModeCount;
  std::size_t Stride;
  LargeVector<float> Records;
};
} // namespace palpate

#endif
