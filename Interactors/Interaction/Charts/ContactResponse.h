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
/// The position of a contact on a body: a triangle and area coordinates.
struct ContactTriangle
{
  std::array<vtkIdType, 3> corners{};
  Vector3 weights = Vector3::Zero(); ///< area coordinates of the contact point: >= 0, sum 1

  /// Sets corners and weights. `index` is the index of the triangle among the body's polygons.
  /// `point` (mm) must be on the triangle, or on the smooth surface over the triangle that is
  /// defined by the normals of the response `name`. Returns false if there is no such triangle.
  bool find(vtkPolyData* body, const std::string& name, vtkIdType index, const Vector3& point);
};

/**
 * One response of a body at one contact: the curves of the triangle's corners and their average
 * weighted by the area coordinates. The kernel of the servo tick evaluates the curves. The cost
 * does not depend on the size of the body.
 */
class ContactResponse
{
public:
  /// Creates the object. Returns null and sets `error` if the body has no valid response `name`.
  static std::unique_ptr<ContactResponse> read(vtkPolyData* body, const std::string& name,
    const ContactTriangle& triangle, std::string& error);

  /// Force of corner k at a deflection (mm), N. NaN if the corner has no response.
  double cornerForce(int k, double deflection) const;
  double cornerRange(int k) const { return this->Field.range(k); }
  /// Weighted average of the corners' forces (N) and of their ranges (mm). NaN if a corner with a
  /// weight > 0 has no response.
  double force(double deflection) const;
  double range() const;
  /// Whether tilting the tool changes the force.
  bool hasTilt() const { return this->Tilts.terms().areFelt(); }
  /// The force, N, if the tool is tilted by `angle` (rad) and the deflection of its deepest point
  /// is `deflection` (mm).
  double tiltedForce(double deflection, double angle) const;
  /// Estimated relative error of force(), as a weighted average of the corners' errors. NaN beyond
  /// the range of a corner.
  bool hasError() const { return !this->Errors.empty(); }
  double error(double deflection) const;
  /// Depth to which the responses of all corners are valid, mm. Infinite if the body stores no
  /// validity.
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
  std::array<double, TiltTerms::MostLaws> TiltWeights{}; ///< weights of the laws at the contact
  /// Errors at the samples of the three corners; empty if no errors are stored.
  std::vector<float> Errors;
  double Validity = std::numeric_limits<double>::infinity();
};
} // namespace palpate

#endif
