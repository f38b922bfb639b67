// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceDirection_h
#define palpate_ForceDirection_h

#include "Contact/ContactSettings.h"
#include "Contact/Pressed.h"
#include "Contact/ResponseField.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/**
 * Direction of the normal force in a ForceForm, and the ratio of the normal force to the derivative
 * of the work with respect to the depth.
 */
struct ForceDirection
{
  Vector3 normal = Vector3::Zero(); ///< unit vector, outward; not finite if there is no direction
  /// The force divided by the derivative of the work; 1 except for ForceForm::Paper.
  double ratio = 1.0;

  /// Returns the direction for a contact whose curves have the force `upright` (N) at its depth.
  /// `out` is a vector of any length that points out of the body (ToolContact::vectorToContact).
  static ForceDirection of(ForceForm form, const ResponseField& response,
    const TriangleCorners& corners, const Pressed& at, double upright, const Vector3& out) noexcept;

  /// Returns a force without its component against `out`, which need not have unit length. The
  /// normals of the vertices can point into the body on a thin fin, and the normal of a face can do
  /// so beyond the border of the face.
  static Vector3 outwardPart(const Vector3& force, const Vector3& out) noexcept
  {
    const double along = force.dot(out);
    return along < 0.0 ? Vector3(force - along / out.squaredNorm() * out) : force;
  }

private:
  /// Returns a direction without its component against `out`, or `out` if nothing remains.
  static Vector3 outward(const Vector3& direction, const Vector3& out) noexcept
  {
    constexpr double rounding = 1e-12; // fraction of the squared length
    const Vector3 part = outwardPart(direction, out);
    const bool isAgainst =
      direction.dot(out) < 0.0 && !(part.squaredNorm() > rounding * direction.squaredNorm());
    return isAgainst ? out.normalized() : part;
  }
  /// Returns 1/√x.
  static double inverseRoot(double x) noexcept;
  /// Returns Σ n_i factor_i U_i, where n_i are the weights and U_i the normals at the corners.
  static Vector3 sumOfNormals(const ResponseField& response, const TriangleCorners& corners,
    const Vector3& weights, const Vector3& factors) noexcept
  {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto i = static_cast<Eigen::Index>(k);
      sum += weights[i] * factors[i] * response.normal(corners[k]);
    }
    return sum;
  }
};

// The squared length of a sum of nearly parallel unit normals is near 1. Near 1 the series is exact
// to rounding, and is faster than a square root and a division.
inline double ForceDirection::inverseRoot(double x) noexcept
{
  // The first omitted term of the series is 0.2 little⁸, that is 2e-17.
  constexpr double little = 0.01;
  const double e = 1.0 - x;
  if (!(std::abs(e) < little))
  {
    return 1.0 / std::sqrt(x);
  }
  // The terms are grouped in independent pairs, which the processor can evaluate in parallel.
  const double e2 = e * e;
  const double low = (1.0 + 1.0 / 2 * e) + e2 * (3.0 / 8 + 5.0 / 16 * e);
  const double high = (35.0 / 128 + 63.0 / 256 * e) + e2 * (231.0 / 1024 + 429.0 / 2048 * e);
  return low + e2 * e2 * high;
}

inline ForceDirection ForceDirection::of(ForceForm form, const ResponseField& response,
  const TriangleCorners& corners, const Pressed& at, double upright, const Vector3& out) noexcept
{
  const ContactPlace& place = at.place();
  const Vector3& weights = place.projection.weights;
  if (form == ForceForm::EnergyConsistent)
  {
    const bool isAgainst = place.onBorder && place.normal.dot(out) < 0.0;
    return { isAgainst ? outward(place.normal, out).normalized() : place.normal };
  }
  ForceDirection direction;
  Vector3 sum = Vector3::Zero();
  if (form == ForceForm::Paper && upright > 0.0)
  {
    const std::array<ResponseValue, 3> each =
      BlendedResponse(response, corners, weights).evaluateEach(at.reach.depth);
    const Vector3 forces(each[0].force, each[1].force, each[2].force);
    sum = outwardPart(sumOfNormals(response, corners, weights, forces), out);
    direction.ratio = sum.norm() / upright;
  }
  if (sum.isZero(0.0)) // the form is not Paper, or its force is zero
  {
    // On a smooth surface the normal differs from the interpolated normals of the facet.
    sum = outward(
      place.isSmooth ? place.normal : sumOfNormals(response, corners, weights, Vector3::Ones()),
      out);
  }
  direction.normal = inverseRoot(sum.squaredNorm()) * sum;
  return direction;
}
} // namespace palpate

#endif
