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
 * Direction of the normal force in a force form, and the ratio of the normal force to the
 * derivative of the work by the depth.
 */
struct ForceDirection
{
  Vector3 normal = Vector3::Zero(); ///< unit, outward; not finite if there is no direction
  double ratio = 1.0; ///< the force divided by the derivative of the work: 1 except in Paper

  /// The direction for a contact whose curves have the force `upright` (N) at its depth. `out` is a
  /// vector of any length out of the body (ToolContact::vectorToContact).
  static ForceDirection of(ForceForm form, const ResponseField& response,
    const TriangleCorners& corners, const Pressed& at, double upright, const Vector3& out) noexcept;

  /// A force without its part against `out` (which need not have unit length). On a thin fin the
  /// normals of the vertices can point into the body; so can the normal of a face beyond its
  /// border.
  static Vector3 outwardPart(const Vector3& force, const Vector3& out) noexcept
  {
    const double along = force.dot(out);
    return along < 0.0 ? Vector3(force - along / out.squaredNorm() * out) : force;
  }

private:
  /// A direction without its part against `out`; `out` if nothing remains.
  static Vector3 outward(const Vector3& direction, const Vector3& out) noexcept
  {
    constexpr double rounding = 1e-12; // fraction of the squared length
    const Vector3 part = outwardPart(direction, out);
    const bool isAgainst =
      direction.dot(out) < 0.0 && !(part.squaredNorm() > rounding * direction.squaredNorm());
    return isAgainst ? out.normalized() : part;
  }
  /// 1/√x.
  static double inverseRoot(double x) noexcept;
  /// Σ n_i factor_i U_i.
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

// The square of a sum of nearly parallel normals is near 1. There the series is exact to rounding
// and saves a tick the latency of a root and a division.
inline double ForceDirection::inverseRoot(double x) noexcept
{
  constexpr double little = 0.01; // its eighth power, times 0.2, is 2e-17
  const double e = 1.0 - x;
  if (!(std::abs(e) < little))
  {
    return 1.0 / std::sqrt(x);
  }
  // The terms are grouped in pairs that are independent of each other.
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
  if (sum.isZero(0.0)) // another form, or Paper's force is zero
  {
    // The normal of a smooth surface differs from that of the facet.
    sum = outward(
      place.isSmooth ? place.normal : sumOfNormals(response, corners, weights, Vector3::Ones()),
      out);
  }
  direction.normal = inverseRoot(sum.squaredNorm()) * sum;
  return direction;
}
} // namespace palpate

#endif
