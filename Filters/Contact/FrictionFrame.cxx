// SPDX-License-Identifier: BSD-3-Clause
#include "FrictionFrame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double SmallestCosine = -0.999;
constexpr double LargestStretch = 2.0;

/// (φ/2)/sin(φ/2) from cos φ: arcsin s/s = 1 + s²/6 + 3s⁴/40 + ... with s = sin(φ/2).
double arcOfChord(double cosine)
{
  const double squared = 0.5 * (1.0 - cosine);
  return 1.0 + squared * (1.0 / 6.0 + 3.0 / 40.0 * squared);
}
} // namespace

void FrictionFrame::start(const Vector3& point, const Vector3& normal) noexcept
{
  this->Started = true;
  this->Point = point;
  this->Normal = normal;
  this->First = normal.unitOrthogonal();
  this->Second = normal.cross(this->First);
  this->Displacement.setZero();
}

bool FrictionFrame::advance(const Vector3& point, const Vector3& normal) noexcept
{
  const double cosine = this->Normal.dot(normal);
  if (!this->Started || !(cosine > SmallestCosine))
  {
    this->start(point, normal);
    return false;
  }
  const Vector3 chord = point - this->Point;
  const Vector3 turned =
    this->First - (normal.dot(this->First) / (1.0 + cosine)) * (this->Normal + normal);
  // Rounding would add up: back into the plane, and one Newton step of 1/√ to unit length.
  const double unit = 1.5 - 0.5 * turned.squaredNorm();
  const Vector3 first = unit * (turned - normal.dot(turned) * normal);
  const Vector3 second = normal.cross(first);
  const Vector2 along(chord.dot(this->First + first), chord.dot(this->Second + second));

  const double length = chord.squaredNorm();
  const double seen = 0.25 * along.squaredNorm();
  if (seen > 0.0)
  {
    const double stretch = std::min(std::sqrt(length / seen), LargestStretch);
    this->Displacement = (0.5 * stretch * arcOfChord(cosine)) * along;
  }
  else
  {
    this->Displacement.setZero();
  }
  this->Point = point;
  this->Normal = normal;
  this->First = first;
  this->Second = second;
  return true;
}
} // namespace palpate
