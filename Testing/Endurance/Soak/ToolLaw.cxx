// SPDX-License-Identifier: BSD-3-Clause
#include "ToolLaw.h"

#include <cmath>
#include <limits>

namespace palpate::endurance
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
}

ToolLaw::ToolLaw(Shape shape, double size)
  : Kind(shape)
  , Size(size)
  , Tangent(std::tan(size * Pi / 180.0))
{
}

const char* ToolLaw::name() const
{
  switch (this->Kind)
  {
    case Flat:
      return "flat";
    case Paraboloid:
      return "paraboloid";
    case Cone:
      return "cone";
    default:
      return "sphere";
  }
}

double ToolLaw::depthOf(double contactRadius) const
{
  const double a = contactRadius;
  switch (this->Kind)
  {
    case Flat:
      return a < this->Size ? 0.0 : std::numeric_limits<double>::infinity();
    case Paraboloid:
      return a * a / this->Size;
    case Cone:
      return Pi * a / (2.0 * this->Tangent);
    default:
      return a < this->Size ? a * std::atanh(a / this->Size)
                            : std::numeric_limits<double>::infinity();
  }
}

double ToolLaw::contactRadius(double depth) const
{
  const double r = this->Size;
  switch (this->Kind)
  {
    case Flat:
      return r;
    case Paraboloid:
      return std::sqrt(r * depth);
    case Cone:
      return 2.0 * this->Tangent * depth / Pi;
    default:
      break;
  }
  // Bisection between 0 and the radius of the paraboloid, down to the last few bits.
  double low = 0.0;
  double high = std::fmin(std::sqrt(r * depth), r);
  for (int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    (this->depthOf(middle) < depth ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double ToolLaw::force(double depth, double modulus) const
{
  const double r = this->Size;
  switch (this->Kind)
  {
    case Flat:
      return 2.0 * modulus * r * depth;
    case Paraboloid:
      return 4.0 / 3.0 * modulus * std::sqrt(r * depth) * depth;
    case Cone:
      return 2.0 / Pi * modulus * this->Tangent * depth * depth;
    default:
      break;
  }
  const double a = this->contactRadius(depth);
  return modulus * ((a * a + r * r) * std::atanh(a / r) - a * r);
}

double ToolLaw::stiffness(double depth, double modulus) const
{
  return 2.0 * modulus * this->contactRadius(depth);
}

double ToolLaw::cappedForce(double depth, double modulus, double most) const
{
  if (this->stiffness(depth, modulus) <= most)
  {
    return this->force(depth, modulus);
  }
  const double from = this->depthOf(0.5 * most / modulus);
  return this->force(from, modulus) + most * (depth - from);
}

double ToolLaw::storageError() const
{
  return this->Kind == Sphere ? 5e-4 : 1e-6;
}
} // namespace palpate::endurance
