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
 * Compliance between two points of a body: the displacement of the surface at one point per force
 * at the other, mm/N:
 *   C_ij = (n_i·n_j)⁺ g(r/h) / (πr √(E*_i E*_j)) + Σ_m φ_m(i) φ_m(j),
 * with g of CouplingLaw, h = √(h_i h_j), and r the straight distance. r is at least the sum of the
 * contact radii, because rigid tools would collide at a smaller distance. Points with opposite
 * normals are coupled by the modes of the body only, not through the surface. C is symmetric. With
 * g = 1 and the contacts' own compliances 1/K_i on the diagonal it is positive definite, so that
 * the forces exist and are unique.
 *
 * C_ij is a function of the area coordinates of the two points. Its gradients by these coordinates
 * are known, so that moving contacts have an energy. Immutable, safe from any number of threads.
 */
class PALPATE_EXPORT BodyCoupling
{
public:
  /// Data of a contact for its coupling with the others.
  struct Spot
  {
    TriangleCorners corners{};
    Vector3 point = Vector3::Zero();  ///< local
    Vector3 normal = Vector3::Zero(); ///< unit; the blended normal
    double normalLength = 1.0;        ///< length of the blended normal before it is normalized
    double modulus = 0.0;
    double thickness = 0.0;
    double radius = 0.0;
    std::array<double, CouplingTerms::MostModes> modes{};
  };

  /// `response` is the response of the body at the points of the same mesh; both must outlive this
  /// object. `terms` must be valid (faultOfCoupling).
  BodyCoupling(const PackedMesh& mesh, const ResponseField& response, const CouplingTerms& terms);

  /// The data of a contact with this stiffness (N/mm).
  Spot at(std::int32_t triangle, const Vector3& weights, double stiffness) const noexcept;
  /// C_ij, mm/N.
  double compliance(const Spot& one, const Spot& other) const noexcept;
  /// Relative error of the force of two contacts because they act on one another as point forces,
  /// if the two forces are equal; the error of the weaker one grows with the ratio of the forces.
  /// Comparison with boundary elements of two full contacts
  /// (Data/Reference/tilt/two_contacts_halfspace.csv): at most 0.85 % of (R/r)^1.5, where R is the
  /// sum of the contact radii and r >= R the distance. Bonded layers: at most 14 % of (R/r)^4.2 in
  /// addition. Modes of the body are not included.
  double pointForceError(const Spot& one, const Spot& other) const noexcept;
  /// Derivatives of C_ij by the area coordinates of the first contact, up to an additive constant
  /// common to all three. If the distance is limited to the sum of the contact radii, it
  /// contributes nothing.
  Vector3 gradient(const Spot& of, std::int32_t triangle, const Spot& other) const noexcept;

  bool hasModes() const noexcept { return this->ModeCount > 0; }

private:
  /// The part of C_ij that acts through the surface.
  struct Surface
  {
    double value = 0.0;
    double facing = 0.0; ///< n_i·n_j, at least 0
    double byDistance = 0.0;
    double byThickness = 0.0; ///< derivative by ln h_i
    Vector3 away = Vector3::Zero();
  };
  Surface surface(const Spot& one, const Spot& other) const noexcept;
  /// E*, h and modes at a point.
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
