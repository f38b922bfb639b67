// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StraightStep_h
#define palpate_StraightStep_h

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace palpate
{
using Vector2 = Eigen::Vector2d;

/**
 * The displacement of one tick as a straight piece of path, and what pre-sliding displacements z do
 * along it, exactly, however long it is.
 *
 * In the coordinates (along, across) of the path z moves in order through: free inside a circle,
 * z' = (1, 0), which it leaves forwards; and on the circle, |z| = limit, where the contact is
 * dragged behind like a stone on a string: z' = (1, 0) - cos θ z/|z|, θ from path to z. That curve
 * is the tractrix: tan(θ/2) falls by exp(-length/limit).
 */
class StraightStep
{
public:
  /// None.
  StraightStep() = default;
  /// Along `direction`, of any length but 0; `length` mm.
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

  /// Freely, backwards of the path or within the circle; from outside it, up to where the path
  /// passes its centre. The length that is left.
  static double moveFreely(Vector2& z, double radius, double length) noexcept
  {
    if (z.x() >= 0.0 && z.squaredNorm() >= radius * radius)
    {
      return length; // spares a sliding contact the root
    }
    const double inside = radius * radius - z.y() * z.y();
    const double free = (inside > 0.0 ? std::sqrt(inside) : 0.0) - z.x();
    const double moved = std::clamp(free, 0.0, length);
    z.x() += moved;
    return length - moved;
  }

  /// From a point of the circle's front half.
  static void drag(Vector2& z, double limit, double length) noexcept
  {
    const double tangent = z.y() == 0.0 ? 0.0 : z.y() / (limit + z.x()) * std::exp(-length / limit);
    const double scale = limit / (1.0 + tangent * tangent);
    z = Vector2(scale * (1.0 - tangent * tangent), scale * 2.0 * tangent);
  }

  /// z shortened to the limit.
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
} // namespace palpate

#endif
