// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NearestTriangle_h
#define palpate_NearestTriangle_h

#include "Contact/TriangleBound.h"
#include "Contact/TriangleProjection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace palpate
{
/// What a search for the closest triangle has found so far, and the squared distances in float
/// beyond which a box, or a triangle by its bound, cannot help.
class NearestTriangle
{
public:
  /// `size`: largest coordinate of the body, local as the tip.
  NearestTriangle(const Vector3& tip, double size)
  {
    const double largest = tip.cwiseAbs().maxCoeff();
    this->TipRounding = 6e-8 * 2.0 * largest; // of the tip as floats: √3/2 ulp
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
    this->BoxReach = squared(distance + this->TipRounding);
    this->BoundReach = squared(distance + this->BoundRounding);
  }

  /// Squared distance within which a box may hold something nearer.
  float boxReach() const noexcept { return this->BoxReach; }
  /// Whether a triangle of this TriangleBound may be nearer.
  bool canReach(float bound) const noexcept { return !(bound > this->BoundReach); }

  std::int32_t triangle() const noexcept { return this->Triangle; }
  const TriangleProjection& projection() const noexcept { return this->Best; }

private:
  static constexpr float LargestFloat = std::numeric_limits<float>::max();

  static float squared(double reach) noexcept
  {
    // 1e-6: a dozen roundings of the float distance.
    return static_cast<float>(
      std::min(reach * reach * (1.0 + 1e-6), static_cast<double>(LargestFloat)));
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
