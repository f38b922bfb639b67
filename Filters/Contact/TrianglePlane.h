// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrianglePlane_h
#define palpate_TrianglePlane_h

#include "Contact/TriangleProjection.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// A triangle seen from above: how deep others lie under its plane, over their distance from it
/// within the plane.
class TrianglePlane
{
public:
  explicit TrianglePlane(const std::array<Vector3, 3>& corners);

  /// Smallest slope b such that every point of another triangle at corner k lies no deeper under
  /// the plane than b times its distance from this one; infinite if there is none. Sought along a
  /// few directions: a distance from the corner along any direction that leads away from the
  /// triangle is no longer than the one from the triangle. Any slope <= `enough` will do.
  double slopeTo(const std::array<Vector3, 3>& other, std::size_t k, double enough) const;

  /// mm.
  double smallestAltitude() const { return this->Altitude; }

private:
  double slopeAlong(const Vector3& direction, const std::array<Vector3, 3>& offset,
    const std::array<double, 3>& depth) const;

  std::array<Vector3, 3> Corner;
  Vector3 Normal;
  std::array<Vector3, 3> FromEdge;   ///< unit, away from the triangle across edge i
  std::array<Vector3, 3> FromCorner; ///< unit, between those of the edges that meet there
  double Altitude;
  double Rounding; ///< lengths below are nothing
};
} // namespace palpate

#endif
