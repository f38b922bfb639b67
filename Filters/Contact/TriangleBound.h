// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TriangleBound_h
#define palpate_TriangleBound_h

#include "Contact/TriangleProjection.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace palpate
{
/**
 * A lower bound of the distance between a tip and each of four triangles, computed in float for all
 * four triangles at once. Only triangles that may be the nearest are then computed in double.
 *
 * The bound combines the distance from the plane of the triangle and, within the plane, the
 * distance from the half-plane of each edge. It is the exact distance unless a corner is nearest.
 */
class TriangleBound
{
public:
  using Lane = Eigen::Array<float, 4, 1>;

  /// A computed bound exceeds the true bound by less than this fraction of the largest coordinate
  /// of tip and triangles. This covers a dozen rounding errors, amplified thirty times by the
  /// sharpest allowed angle.
  static constexpr double Rounding = 2e-5;
  /// Largest allowed coordinate of tip and triangles, mm. Sixth powers of larger lengths do not fit
  /// into a float.
  static constexpr double LargestCoordinate = 3e5;

  /// Returns the squared bounds. `corners` has nine coordinates for each triangle. The bound is 0
  /// for slivers, because float rounding makes their planes uncertain.
  [[gnu::always_inline]] static Lane squaredDistances(
    const Eigen::Vector3f& tip, const std::array<const float*, 4>& corners) noexcept
  {
    std::array<Lanes, 3> to = load(corners); // vectors from the tip to the corners
    for (std::size_t k = 0; k < 3; ++k)
    {
      const float t = tip[static_cast<Eigen::Index>(k)];
      to[0][k] -= t;
      to[1][k] -= t;
      to[2][k] -= t;
    }
    const Lanes ab = minus(to[1], to[0]);
    const Lanes bc = minus(to[2], to[1]);
    const Lanes ca = minus(to[0], to[2]);
    const Lanes normal = cross(ab, ca); // directed inward; its length is twice the area
    const Lane area2 = dot(normal, normal);
    const Lane height = dot(normal, to[0]);
    const Lane ab2 = dot(ab, ab);
    const Lane ca2 = dot(ca, ca);
    // Signed distance of the tip's projection from the line of each edge, multiplied by |normal|
    // |edge|; negative outside the triangle.
    const Lanes turned = cross(to[0], normal);
    const Lane insideAb = dot(ab, turned);
    const Lane insideCa = dot(ca, turned);
    const Lane insideBc = area2 - insideAb - insideCa;
    const Lane beside2 = (insideAb.min(0.0F).square() / ab2)
                           .max(insideCa.min(0.0F).square() / ca2)
                           .max(insideBc.min(0.0F).square() / dot(bc, bc));
    const Lane bound = (height.square() + beside2) / area2;
    const Lane smallest = (SliverSine2 * ab2 * ca2).max(SmallestArea2);
    Lane safe;
    for (Eigen::Index i = 0; i < safe.size(); ++i)
    {
      safe[i] = area2[i] > smallest[i] ? bound[i] : 0.0F;
    }
    return safe;
  }

private:
  using Lanes = std::array<Lane, 3>; ///< x, y, z

  static constexpr float SliverSine2 = 1e-3F;
  static constexpr float SmallestArea2 = 1e-30F; ///< mm^4; prevents denormal divisors

  /// Loads the coordinates: one Lanes per corner, one Lane per coordinate, with one value for each
  /// triangle.
  static std::array<Lanes, 3> load(const std::array<const float*, 4>& corners) noexcept
  {
    std::array<Lanes, 3> to;
#ifdef __SSE2__
    for (std::size_t k = 0; k < 8; k += 4) // loads eight of the nine coordinates, four at a time
    {
      __m128 a = _mm_loadu_ps(corners[0] + k);
      __m128 b = _mm_loadu_ps(corners[1] + k);
      __m128 c = _mm_loadu_ps(corners[2] + k);
      __m128 d = _mm_loadu_ps(corners[3] + k);
      _MM_TRANSPOSE4_PS(a, b, c, d);
      _mm_storeu_ps(to[k / 3][k % 3].data(), a);
      _mm_storeu_ps(to[(k + 1) / 3][(k + 1) % 3].data(), b);
      _mm_storeu_ps(to[(k + 2) / 3][(k + 2) % 3].data(), c);
      _mm_storeu_ps(to[(k + 3) / 3][(k + 3) % 3].data(), d);
    }
    to[2][2] = Lane(corners[0][8], corners[1][8], corners[2][8], corners[3][8]);
#else
    for (std::size_t k = 0; k < 9; ++k)
    {
      to[k / 3][k % 3] = Lane(corners[0][k], corners[1][k], corners[2][k], corners[3][k]);
    }
#endif
    return to;
  }
  static Lanes minus(const Lanes& a, const Lanes& b) noexcept
  {
    return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  }
  static Lane dot(const Lanes& a, const Lanes& b) noexcept
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Lanes cross(const Lanes& a, const Lanes& b) noexcept
  {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }
};

/// The nearest triangle found so far in a search, with two squared distances in float: a box beyond
/// the first distance, or a triangle whose bound is beyond the second distance, cannot be nearer.
class NearestTriangle
{
public:
  /// `size` is the largest absolute local coordinate of the body, mm.
  NearestTriangle(const Vector3& tip, double size)
  {
    const double largest = tip.cwiseAbs().maxCoeff();
    // Error of converting the tip to floats: √3/2 units in the last place.
    this->TipRounding = 6e-8 * 2.0 * largest;
    this->BoundRounding = largest + size < TriangleBound::LargestCoordinate
      ? TriangleBound::Rounding * (largest + size)
      : std::numeric_limits<double>::infinity();
    this->Best.squaredDistance = std::numeric_limits<double>::infinity();
  }

  void take(std::int32_t triangle, const TriangleProjection& there) noexcept
  {
    this->Best = there;
    this->Triangle = triangle;
    const double distance = std::sqrt(there.squaredDistance);
    this->BoxReach = static_cast<float>(
      std::min(squared(distance + this->TipRounding), static_cast<double>(LargestFloat)));
    // If the bound does not fit into a float, every triangle is checked.
    const double bound = squared(distance + this->BoundRounding);
    this->BoundReach = bound < static_cast<double>(LargestFloat)
      ? static_cast<float>(bound)
      : std::numeric_limits<float>::infinity();
  }

  /// Squared distance within which a box may contain a nearer triangle.
  float boxReach() const noexcept { return this->BoxReach; }
  /// Returns whether a triangle with the TriangleBound `bound` may be nearer.
  bool canReach(float bound) const noexcept { return !(bound > this->BoundReach); }

  std::int32_t triangle() const noexcept { return this->Triangle; }
  const TriangleProjection& projection() const noexcept { return this->Best; }

private:
  static constexpr float LargestFloat = std::numeric_limits<float>::max();

  static double squared(double reach) noexcept
  {
    // The factor covers a dozen rounding errors of the float distance.
    return reach * reach * (1.0 + 1e-6);
  }

  double TipRounding;
  double BoundRounding;
  TriangleProjection Best;
  std::int32_t Triangle = -1;
  float BoxReach = LargestFloat;
  float BoundReach = std::numeric_limits<float>::infinity();
};
} // namespace palpate

#endif
