// SPDX-License-Identifier: BSD-3-Clause
// The space outside a body: distances from the surface, and straight ways that are free.
#ifndef palpate_FreeSpace_h
#define palpate_FreeSpace_h

#include "Contact/ContactBody.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>

namespace palpate
{
/// Distance of a point from the surface of a body, mm. Positive outside the body, negative inside
/// it and behind an open surface. NaN if the body has no triangle or the point is not finite. The
/// point is in the body frame.
PALPATE_EXPORT double clearanceAt(const ContactBody& body, const Vector3& point) noexcept;

/// The unit normal of the surface at a point of a triangle, interpolated between the response's
/// normals at the three corners. If the response has no normals there, the normal of the triangle
/// is returned.
PALPATE_EXPORT Vector3 surfaceNormal(
  const ContactBody& body, std::int32_t triangle, const Vector3& weights) noexcept;

/// Returns the height up to which the column over a point of the surface, along `normal`, is free.
/// The result is the largest of the heights `most`, `most`/2, ... `most`/1024 (mm) with a free
/// column, or 0 if the lowest column is not free. A column is free if the clearance at z is at
/// least 0.35 z for z = height, height/2, ...; the balls with these radii then overlap.
PALPATE_EXPORT double freeHeight(
  const ContactBody& body, const Vector3& point, const Vector3& normal, double most) noexcept;

/// Number of directions of spiralDirection().
constexpr int SpiralDirections = 96;
/// Returns one of the unit directions that cover the sphere evenly along a Fibonacci spiral, from
/// `axis` (unit) to its opposite. `i` is the index of the direction, from 0 to SpiralDirections -
/// 1.
PALPATE_EXPORT Vector3 spiralDirection(const Vector3& axis, int i) noexcept;

/// The distance from the point `from` to a sphere about the origin, along a unit vector. 0 if the
/// vector does not point to the sphere.
PALPATE_EXPORT double lengthToSphere(
  const Vector3& from, const Vector3& along, double radius) noexcept;

/**
 * Determines whether a straight line stays outside a body. The search is divided into parts that
 * are short enough for a servo tick.
 *
 * The clearance c of a point is the radius of a ball around the point that contains no part of the
 * surface. The search goes from the start to the end in steps of c - margin/2, and fails if c is
 * below the margin. Therefore each point of a free line has a clearance of at least margin/2. No
 * function allocates or throws. The body must outlive the search.
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

  /// Begins the search on the line from `from` to `to` (body frame, mm) with the margin `margin`
  /// (mm, > 0).
  void begin(
    const ContactBody& body, const Vector3& from, const Vector3& to, double margin) noexcept;
  /// Continues the search with at most `queries` closest-point queries, and subtracts the number of
  /// used queries from `queries`.
  State go(int& queries) noexcept;
  Vector3 end() const noexcept { return this->From + this->Length * this->Along; }

private:
  static constexpr int MostQueries = 400; ///< a longer search counts as blocked

  const ContactBody* Body = nullptr;
  Vector3 From = Vector3::Zero();
  Vector3 Along = Vector3::Zero(); ///< unit
  double Length = 0.0;
  double Margin = 0.0;
  double Done = 0.0; ///< length of the line that is known to be free, mm
  int Used = 0;
  State Found = State::Unknown;
};

/// Searches a whole line in one call. Must not be called from a servo tick.
PALPATE_EXPORT bool isFree(
  const ContactBody& body, const Vector3& from, const Vector3& to, double margin) noexcept;
} // namespace palpate

#endif
