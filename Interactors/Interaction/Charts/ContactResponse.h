// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactResponse_h
#define ContactResponse_h

#include "Contact/ResponseField.h"
#include "Mechanics/Tilt/TiltTable.h"

#include "vtkType.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
/// The position of a contact on a body.
struct ContactTriangle
{
  std::array<vtkIdType, 3> corners{};
  Vector3 weights = Vector3::Zero(); ///< area coordinates of the contact point: >= 0, sum 1

  /// Sets corners and weights from triangle `index` of the body's polygons and a point, mm. The
  /// point must be on the triangle, or on the smooth surface over the triangle that is defined by
  /// the normals of the response `name`. Returns false if there is no such triangle.
  bool find(vtkPolyData* body, const std::string& name, vtkIdType index, const Vector3& point);
};

/**
 * One response of a body at one contact: the curves of the triangle's corners and their blend by
 * area coordinates. The kernel of the tick evaluates them. The cost does not depend on the size of
 * the body.
 */
class ContactResponse
{
public:
  /// Makes the object. Returns null and an error if the body has no valid response `name`.
  static std::unique_ptr<ContactResponse> read(vtkPolyData* body, const std::string& name,
    const ContactTriangle& triangle, std::string& error);

  /// Force of corner k at a deflection (mm), N; NaN if the corner has no response.
  double cornerForce(int k, double deflection) const;
  double cornerRange(int k) const { return this->Field.range(k); }
  /// Blended force (N) and blended range (mm); NaN if a corner of weight > 0 has no response.
  double force(double deflection) const;
  double range() const;
  /// Whether tilting the tool changes the force.
  bool hasTilt() const { return this->Tilts.terms().areFelt(); }
  /// The force of the tool tilted by `angle` (rad) with its deepest point at this deflection, N.
  double tiltedForce(double deflection, double angle) const;
  /// Estimated relative error of force(), blended in the same way; NaN beyond a range.
  bool hasError() const { return !this->Errors.empty(); }
  double error(double deflection) const;
  /// Depth to which all corners are valid, mm; infinite if the body has no validity.
  double validity() const { return this->Validity; }

private:
  ContactResponse(const ResponseArrays& arrays, const Vector3& weights)
    : Field(arrays)
    , Weights(weights)
  {
  }
  bool isSound() const;
  BlendedResponse blend() const { return { this->Field, { 0, 1, 2 }, this->Weights }; }

  ResponseField Field; ///< response of the three corners
  Vector3 Weights;
  TiltTable Tilts;
  std::array<double, TiltTerms::MostLaws> TiltWeights{}; ///< of the laws, at the contact
  std::vector<float> Errors; ///< errors at the samples of the three corners; empty: no errors are
                             ///< stored
  double Validity = std::numeric_limits<double>::infinity();
};
} // namespace palpate

#endif
