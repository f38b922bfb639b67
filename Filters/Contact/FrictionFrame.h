// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FrictionFrame_h
#define palpate_FrictionFrame_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate
{
using Vector2 = Eigen::Vector2d;

/**
 * The displacement of one tick as a straight piece of a path, and the exact change of a pre-sliding
 * displacement z along a straight path of any length.
 *
 * In the coordinates (along, across) of the path, z changes in two phases. Inside a circle it
 * follows the path, z' = (1, 0), until it leaves the circle on the front side. On the circle, |z| =
 * limit, the contact is dragged: z' = (1, 0) - cos θ z/|z|, where θ is the angle from the path to
 * z. The resulting curve is the tractrix: tan(θ/2) falls by the factor exp(-length/limit).
 */
class StraightStep
{
public:
  /// Creates a step without displacement.
  StraightStep() = default;
  /// A displacement along `direction`, which may have any length except 0. `length` is in mm.
  StraightStep(const Vector2& direction, double length) noexcept
    : Length(length)
    , Direction(direction * (1.0 / direction.norm()))
  {
  }

  explicit StraightStep(const Vector2& displacement) noexcept
    : Length(displacement.norm())
    , Direction(this->Length > 0.0 ? Vector2(displacement / this->Length) : Vector2(1.0, 0.0))
  {
  }

  double length() const noexcept { return this->Length; }
  const Vector2& direction() const noexcept { return this->Direction; }
  Vector2 displacement() const noexcept { return this->Length * this->Direction; }

  Vector2 toPath(const Vector2& z) const noexcept
  {
    return { this->Direction.dot(z), this->Direction.x() * z.y() - this->Direction.y() * z.x() };
  }
  Vector2 fromPath(const Vector2& z) const noexcept
  {
    return { this->Direction.x() * z.x() - this->Direction.y() * z.y(),
      this->Direction.y() * z.x() + this->Direction.x() * z.y() };
  }

  /// Moves z along the path until z leaves the circle on the front side. If the path does not meet
  /// the circle, z moves to the point of the path closest to the centre. Returns the remaining
  /// length.
  static double moveFreely(Vector2& z, double radius, double length) noexcept
  {
    if (z.x() >= 0.0 && z.squaredNorm() >= radius * radius)
    {
      return length; // shortcut for a sliding contact, without the square root
    }
    const double inside = radius * radius - z.y() * z.y();
    const double free = (inside > 0.0 ? std::sqrt(inside) : 0.0) - z.x();
    const double moved = std::clamp(free, 0.0, length);
    z.x() += moved;
    return length - moved;
  }

  /// Moves z along the tractrix, from a point on the front half of the circle.
  static void drag(Vector2& z, double limit, double length) noexcept
  {
    const double tangent = z.y() == 0.0 ? 0.0 : z.y() / (limit + z.x()) * decay(length / limit);
    const double scale = limit / (1.0 + tangent * tangent);
    z = Vector2(scale * (1.0 - tangent * tangent), scale * 2.0 * tangent);
  }

  /// Returns e^-x. For the small x of a tick, Taylor's polynomial is exact to rounding. Its
  /// coefficients are in the code, whereas the library's function reads a table from memory.
  static double decay(double x) noexcept
  {
    constexpr double little = 0.25; // the first omitted term, x^12/12!, is 1e-16
    if (!(x < little))
    {
      return std::exp(-x);
    }
    // The terms are grouped by four in independent groups, which the processor can evaluate in
    // parallel.
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double low = (1.0 - x) + x2 * (1.0 / 2 - x * (1.0 / 6));
    const double middle = (1.0 / 24 - x * (1.0 / 120)) + x2 * (1.0 / 720 - x * (1.0 / 5040));
    const double high =
      (1.0 / 40320 - x * (1.0 / 362880)) + x2 * (1.0 / 3628800 - x * (1.0 / 39916800));
    return low + x4 * (middle + x4 * high);
  }

  /// Shortens z to at most the length `limit`.
  static void clip(Vector2& z, double limit) noexcept
  {
    const double squared = z.squaredNorm();
    if (squared > limit * limit)
    {
      z *= limit / std::sqrt(squared);
    }
  }

private:
  double Length = 0.0;
  Vector2 Direction = Vector2(1.0, 0.0);
};

using Vector3 = Eigen::Vector3d;

/// Result of a friction model, in the frame of FrictionFrame.
struct TangentialForce
{
  Vector2 force = Vector2::Zero(); ///< on the tool, N
  bool sliding = true;
};

/**
 * A tangent frame that moves with the contact point, so that a tangential displacement can be
 * stored in two numbers.
 *
 * Parallel transport: from one tick to the next the frame undergoes the smallest rotation that maps
 * the last normal to the new one. A vector with constant components then neither turns within the
 * surface nor changes its length. On a closed path it turns by the integral of the curvature inside
 * the path (on a sphere, by the solid angle). No trigonometry is needed. On the way back the
 * rotation is reversed.
 *
 * Displacement over the surface: its direction is that of the chord from the last contact point,
 * with components averaged over the two frames (on a circular arc this is exactly the direction of
 * the arc). Its length is that of a circular arc over this chord whose tangent rotates by the angle
 * between the two normals. This length is 5e-7 too short at 0.3 rad per tick and 0.8 % too short at
 * a right angle. The component of the chord along the normals only lengthens the displacement, to
 * at most twice its length: a contact that moves along its normal has no displacement.
 *
 * Between normals more than 177 degrees apart the smallest rotation is not defined; the history
 * ends.
 */
class PALPATE_EXPORT FrictionFrame
{
public:
  /// Ends the history. The next advance() starts the frame at its point.
  void reset() noexcept { this->Started = false; }

  /// Moves the frame to the next contact. `point` is on the undeformed surface, mm; `normal` is a
  /// unit vector. Returns whether the frame was transported from the last contact. If not, the
  /// frame starts at `point` with displacement 0.
  bool advance(const Vector3& point, const Vector3& normal) noexcept;

  /// Returns the displacement of the last advance(), mm, in the coordinates of this frame.
  const StraightStep& step() const noexcept { return this->Step; }

  bool isStarted() const noexcept { return this->Started; }

  /// Returns the tangential part of a vector in space, in the coordinates of this frame.
  Vector2 toTangent(const Vector3& vector) const noexcept
  {
    return { vector.dot(this->First), vector.dot(this->Second) };
  }
  /// Returns a tangent vector of this frame as a vector in space.
  Vector3 toSpace(const Vector2& tangent) const noexcept
  {
    return tangent.x() * this->First + tangent.y() * this->Second;
  }

private:
  static constexpr double SmallestCosine = -0.999;
  static constexpr double LargestStretch = 2.0;

  void start(const Vector3& point, const Vector3& normal) noexcept
  {
    this->Started = true;
    this->Point = point;
    this->Normal = normal;
    this->First = normal.unitOrthogonal();
    this->Second = normal.cross(this->First);
    this->Step = StraightStep();
  }
  /// Returns (φ/2)/sin(φ/2) from cos φ: arcsin s/s = 1 + s²/6 + 3s⁴/40 + ... with s = sin(φ/2).
  static double arcOfChord(double cosine) noexcept
  {
    const double squared = 0.5 * (1.0 - cosine);
    return 1.0 + squared * (1.0 / 6.0 + 3.0 / 40.0 * squared);
  }

  bool Started = false;
  Vector3 Point = Vector3::Zero();
  Vector3 Normal = Vector3::Zero();
  Vector3 First = Vector3::Zero();
  Vector3 Second = Vector3::Zero();
  StraightStep Step;
};
// The values for the displacement are computed first, as independent scalar products, because the
// rest of a tick depends only on these values.
[[gnu::hot]] inline bool FrictionFrame::advance(
  const Vector3& point, const Vector3& normal) noexcept
{
  const double cosine = this->Normal.dot(normal);
  if (!this->Started || !(cosine > SmallestCosine))
  {
    this->start(point, normal);
    return false;
  }
  // An axis e of the frame becomes e - (n·e)/(1 + cos φ) (n + n'), where n is the new normal and n'
  // the old one.
  const Vector3 chord = point - this->Point;
  const Vector3 normals = this->Normal + normal;
  const double share = 1.0 / (1.0 + cosine);
  const double lean = share * chord.dot(normals);
  const double first = normal.dot(this->First);
  const double second = normal.dot(this->Second);
  const Vector2 along(2.0 * chord.dot(this->First) - first * lean,
    2.0 * chord.dot(this->Second) - second * lean); // chord · (old axis + new axis)
  const double seen = along.squaredNorm();
  if (seen > 0.0)
  {
    // Longest permitted displacement: LargestStretch times the length of the tangential chord,
    // which is |along|/2. The variable holds its square.
    const double longest = 0.25 * LargestStretch * LargestStretch * seen;
    const double arc = std::sqrt(std::min(chord.squaredNorm(), longest)) * arcOfChord(cosine);
    this->Step = StraightStep(along, arc);
  }
  else
  {
    this->Step = StraightStep();
  }
  // Corrects rounding errors, which would otherwise accumulate: projects the axis on the plane, and
  // scales it to unit length by one Newton step for 1/√.
  const Vector3 turned = this->First - (share * first) * normals;
  const double unit = 1.5 - 0.5 * turned.squaredNorm();
  this->First = unit * (turned - normal.dot(turned) * normal);
  this->Second = normal.cross(this->First);
  this->Point = point;
  this->Normal = normal;
  return true;
}
} // namespace palpate

#endif
