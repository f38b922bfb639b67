// SPDX-License-Identifier: BSD-3-Clause
// The space outside a body: distances from the surface, and straight ways that are free.
#ifndef palpate_FreeSpace_h
#define palpate_FreeSpace_h

#include "Contact/ContactBody.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>

namespace palpate
{
/// Distance from a body's surface to a point of the body's frame, mm: positive outside, negative
/// inside and behind an open surface. NaN if the body has no triangle or the point is not finite.
PALPATE_EXPORT double clearanceAt(const ContactBody& body, const Vector3& point) noexcept;

/// The unit normal of the surface at a point of a triangle, blended from the response's normals at
/// the three corners; the normal of the triangle if the response has none there.
PALPATE_EXPORT Vector3 surfaceNormal(
  const ContactBody& body, std::int32_t triangle, const Vector3& weights) noexcept;

/// The largest of the heights `most`, `most`/2, ... `most`/1024 (mm) below which the column over a
/// point of the surface, along `normal`, is free; 0 if the lowest is not. The column up to a height
/// is free if the clearance at z is at least 0.35 z for z = height, height/2, ...: the balls of
/// these radii overlap.
PALPATE_EXPORT double freeHeight(
  const ContactBody& body, const Vector3& point, const Vector3& normal, double most) noexcept;

/// Number of the directions of spiralDirection().
constexpr int SpiralDirections = 96;
/// Unit directions from `axis` (unit) to its opposite, evenly over the sphere (a Fibonacci spiral);
/// `i` from 0 to SpiralDirections - 1.
PALPATE_EXPORT Vector3 spiralDirection(const Vector3& axis, int i) noexcept;

/// The length from a point to a sphere about the origin, along a unit vector; 0 if the vector meets
/// no sphere ahead.
PALPATE_EXPORT double lengthToSphere(
  const Vector3& from, const Vector3& along, double radius) noexcept;

/**
 * Finds whether a straight way stays outside a body, in parts that a servo tick can afford.
 *
 * The clearance c of a point is the radius of a ball without surface. The search goes from the
 * start to the end in steps of c - margin/2, and fails if c is below the margin. Therefore each
 * point of a free way has a clearance of at least margin/2. No function allocates or throws. The
 * body must outlive the search.
 */
class PALPATE_EXPORT FreeLine
{
public:
  enum class State : std::uint8_t
  {
    Unknown, ///< the search has not ended
    Free,
    Blocked
  };

  /// Begins a search from one point of the body's frame to another, mm; `margin` > 0.
  void begin(
    const ContactBody& body, const Vector3& from, const Vector3& to, double margin) noexcept;
  /// Continues with at most `queries` closest points, and subtracts those that were used.
  State go(int& queries) noexcept;
  Vector3 end() const noexcept { return this->From + this->Length * this->Along; }

private:
  static constexpr int MostQueries = 400; ///< a longer search counts as blocked

  const ContactBody* Body = nullptr;
  Vector3 From = Vector3::Zero();
  Vector3 Along = Vector3::Zero(); ///< unit
  double Length = 0.0;
  double Margin = 0.0;
  double Done = 0.0; ///< length of the way that is known to be free, mm
  int Used = 0;
  State Found = State::Unknown;
};

/// Searches a whole way at once; not for a tick.
PALPATE_EXPORT bool isFree(
  const ContactBody& body, const Vector3& from, const Vector3& to, double margin) noexcept;
} // namespace palpate

#endif
