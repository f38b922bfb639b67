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
 * Compliance between two points of a body: the displacement of the surface at point i, divided by
 * the force at point j that causes it, mm/N:
 *   C_ij = (n_i·n_j)⁺ g(r/h) / (πr √(E*_i E*_j)) + Σ_m φ_m(i) φ_m(j),
 * with g from CouplingLaw, h = √(h_i h_j), and r the straight distance between the points. r is at
 * least the sum of the contact radii, because rigid tools would collide at a smaller distance. Two
 * points whose normals are more than 90° apart are coupled only by the modes of the body, not
 * through the surface. C is symmetric. If g = 1 and the diagonal has the compliances 1/K_i of the
 * single contacts, C is positive definite, so that the forces exist and are unique.
 *
 * C_ij is a function of the area coordinates of the two points. gradient() returns its derivatives
 * with respect to these coordinates, so that moving contacts have an energy. Immutable; can be used
 * from any number of threads.
 */
class PALPATE_EXPORT BodyCoupling
{
public:
  /// Data of one contact for its coupling with other contacts.
  struct Spot
  {
    TriangleCorners corners{};
    Vector3 point = Vector3::Zero();  ///< local coordinates
    Vector3 normal = Vector3::Zero(); ///< unit vector; the normal interpolated from the vertices
    double normalLength = 1.0;        ///< length of the interpolated normal before normalization
    double modulus = 0.0;
    double thickness = 0.0;
    double radius = 0.0;
    std::array<double, CouplingTerms::MostModes> modes{};
  };

  /// `response` is the response of the body at the points of the same mesh; both must outlive this
  /// object. `terms` must be valid (faultOfCoupling).
  BodyCoupling(const PackedMesh& mesh, const ResponseField& response, const CouplingTerms& terms);

  /// Returns the data of a contact. `stiffness` is the stiffness of the contact, N/mm.
  Spot at(std::int32_t triangle, const Vector3& weights, double stiffness) const noexcept;
  /// Returns C_ij, mm/N.
  double compliance(const Spot& one, const Spot& other) const noexcept;
  /// Returns the relative error of the force of two contacts due to their approximation as point
  /// forces in the coupling. This is the error for equal forces; the error of the weaker contact
  /// grows with the ratio of the forces. Comparison with boundary elements of two full contacts
  /// (Data/Reference/tilt/two_contacts_halfspace.csv): the error is at most 0.85 % of (R/r)^1.5,
  /// where R is the sum of the contact radii and r >= R the distance. Bonded layers add at most 14
  /// % of (R/r)^4.2. Modes of the body are not included.
  double pointForceError(const Spot& one, const Spot& other) const noexcept;
  /// Returns the derivatives of C_ij with respect to the area coordinates of the contact `of`, up
  /// to an additive constant common to all three. If the sum of the contact radii is used as the
  /// distance, the distance contributes nothing.
  Vector3 gradient(const Spot& of, std::int32_t triangle, const Spot& other) const noexcept;

  bool hasModes() const noexcept { return this->ModeCount > 0; }

private:
  /// The part of C_ij that acts through the surface, with its derivatives.
  struct Surface
  {
    double value = 0.0;
    double facing = 0.0; ///< n_i·n_j, but at least 0
    double byDistance = 0.0;
    double byThickness = 0.0; ///< derivative with respect to ln h_i
    Vector3 away = Vector3::Zero();
  };
  Surface surface(const Spot& one, const Spot& other) const noexcept;
  /// Returns E*, h and the modes at a point.
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
