// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Friction.h"

#include "Contact/FrictionFrame.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
bool isValid(const FrictionSettings& settings)
{
  const auto isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (settings.model == FrictionModel::ShapeDerived)
  {
    return isPositive(settings.coefficient) && settings.poissonRatio > -1.0 &&
      settings.poissonRatio <= 0.5;
  }
  return isPositive(settings.coefficient) && isPositive(settings.tangentialStiffness) &&
    settings.breakaway >= 0.0 && settings.breakaway <= 1.0 && settings.stickRadius >= 0.0 &&
    std::isfinite(settings.stickRadius);
}

constexpr int MostPieces = 40;
constexpr double LongestPiece = 1.0 / 8.0; ///< largest length of a piece, as a fraction of z_max
/// Largest distance from the limit for slideOn(), as a fraction of z_max.
constexpr double LastBit = 0.005;
/// Largest ratio of the components of z across and along the path for slideOn().
constexpr double Ahead = 0.1;
constexpr double AtLimit = 1.0 - 1e-9;
constexpr double Shortest = 1e-150; ///< mm; the square of this z_max is still greater than 0

double eighthPower(double square)
{
  const double fourth = square * square;
  return fourth * fourth;
}
} // namespace

Friction::Friction(const FrictionSettings& settings) noexcept
  : Model(settings.model)
  , Enabled(isValid(settings))
  , Coefficient(settings.coefficient)
  , ElastoPlastic(settings)
  , Dahl(settings)
  , Shape(settings)
{
}

void Friction::reset() noexcept
{
  this->Frame.reset();
}

void Friction::assume(const Friction& other) noexcept
{
  const bool haveBegun =
    this->Enabled && other.Enabled && this->Frame.isStarted() && other.Frame.isStarted();
  const bool isShape = this->Model == FrictionModel::ShapeDerived;
  if (!haveBegun || isShape != (other.Model == FrictionModel::ShapeDerived))
  {
    return;
  }
  const auto turned = [this, &other](const Vector2& displacement) -> Vector2
  { return this->Frame.toTangent(other.Frame.toSpace(displacement)); };
  if (isShape)
  {
    this->Shape.assume(other.Shape, turned);
    return;
  }
  const bool isDahl = other.Model == FrictionModel::Dahl;
  const Vector2 displacement =
    turned(isDahl ? other.Dahl.displacement() : other.ElastoPlastic.displacement());
  const double stiffness = isDahl ? other.Dahl.stiffness() : other.ElastoPlastic.stiffness();
  this->Dahl.setDisplacement(std::min(stiffness / this->Dahl.stiffness(), 1.0) * displacement);
  this->ElastoPlastic.setDisplacement(this->Dahl.displacement());
}

ElastoPlasticFriction::ElastoPlasticFriction(const FrictionSettings& settings) noexcept
  : Stiffness(settings.tangentialStiffness)
  , Breakaway(settings.breakaway)
  , Breakaway8(std::pow(settings.breakaway, 8))
  , Width8(std::max(std::pow(settings.stickRadius, 8) - this->Breakaway8, 0.0))
  , InverseWidth8(1.0 / this->Width8)
{
}

[[gnu::hot]] TangentialForce ElastoPlasticFriction::update(
  const StraightStep& step, double limit) noexcept
{
  const double longest = limit / this->Stiffness;
  if (!(longest > Shortest))
  {
    this->Z.setZero();
    return {};
  }
  if (this->slideOn(step, longest, this->Stiffness / limit))
  {
    return { -this->Stiffness * this->Z, true };
  }
  StraightStep::clip(this->Z, longest);
  const double free = this->Breakaway * longest;
  const Vector2 elastic = this->Z + step.displacement();
  if (std::max(elastic.squaredNorm(), this->Z.squaredNorm()) <= free * free)
  {
    this->Z = elastic; // within the breakaway circle during the whole step
  }
  else if (step.length() > 0.0)
  {
    Vector2 z = step.toPath(this->Z);
    double left = StraightStep::moveFreely(z, free, step.length());
    if (left > 0.0)
    {
      left = this->creep(z, longest, left);
    }
    if (left > 0.0)
    {
      StraightStep::drag(z, longest, left);
    }
    this->Z = step.fromPath(z);
  }
  const double nearly = AtLimit * longest;
  const bool sliding = this->Z.squaredNorm() >= nearly * nearly;
  return { -this->Stiffness * this->Z, sliding };
}

/// Handles the usual step of a sliding contact. z is at the limit of the last load, moves a short
/// distance to the limit of the present load (or is clipped to it), and is then dragged. Only the
/// angle θ from the path to z changes. The arguments of square roots and divisions are known before
/// the load of this tick. The load only enters through a factor near 1, which is evaluated as a
/// series.
///
/// The short distance is one midpoint step of the creep equations in polar coordinates: d|z|/dx =
/// (1 - α|z|) cos θ, dθ/dx = -sin θ/|z|. Errors are of second order in the angle and of third order
/// in the distance.
[[gnu::hot]] bool ElastoPlasticFriction::slideOn(
  const StraightStep& step, double longest, double inverse) noexcept
{
  const double size = this->Z.norm();
  const Vector2 z = step.toPath(this->Z);
  const double missing = 1.0 - size * inverse;
  if (!(z.x() > 0.0 && missing <= LastBit))
  {
    return false;
  }
  double tangent = z.y() / (size + z.x()); // tan(θ/2)
  double left = step.length();
  if (missing > 0.0)
  {
    const double slope = z.y() / z.x();
    const double half = 0.5 * missing;
    const double middle = 1.0 - half;
    const double w = eighthPower(middle * middle) - this->Breakaway8;
    // The length of the path multiplied by cos θ, from d|z|/dx = (1 - α|z|) cos θ.
    const double bit = missing * (1.0 + w * this->InverseWidth8);
    left -= bit * (longest * (size / z.x()));
    if (!(left >= 0.0 && std::abs(slope) <= Ahead && size >= this->Breakaway * longest))
    {
      return false;
    }
    // Series for half the change of θ, and for the tangent of the sum of the two half angles, which
    // has the divisor 1 - both.
    const double turn = -0.5 * bit * slope * (1.0 + half) * (1.0 + half * half);
    const double both = tangent * turn;
    tangent = (tangent + turn * (1.0 - turn * turn)) * (1.0 + both * (1.0 + both));
  }
  tangent *= StraightStep::decay(left * inverse);
  const double squared = tangent * tangent;
  const double scale = longest / (1.0 + squared);
  this->Z = step.fromPath({ scale * (1.0 - squared), scale * 2.0 * tangent });
  return true;
}

/// Moves z along the path until z is at the limit. Returns the remaining length of the path.
double ElastoPlasticFriction::creep(Vector2& z, double longest, double length) const noexcept
{
  double squared = z.squaredNorm();
  const double nearly = AtLimit * longest;
  for (int i = 0; i < MostPieces && length > 0.0 && squared < nearly * nearly; ++i)
  {
    double piece = std::min(length, LongestPiece * longest);
    Vector2 next = this->rungeKutta(z, longest, piece);
    double reached = next.squaredNorm();
    if (reached > longest * longest)
    {
      // z would exceed the limit: a secant step finds the fraction of the piece up to the limit.
      const double before = std::sqrt(squared);
      piece *= (longest - before) / (std::sqrt(reached) - before);
      next = this->rungeKutta(z, longest, piece);
      reached = next.squaredNorm();
    }
    z = next;
    squared = reached;
    length -= piece;
  }
  if (length > 0.0)
  {
    z *= longest / std::sqrt(squared);
  }
  StraightStep::clip(z, longest);
  return length;
}

Vector2 ElastoPlasticFriction::rate(const Vector2& z, double longest) const noexcept
{
  const double squared = z.squaredNorm();
  const double share = squared / (longest * longest);
  const double w = eighthPower(share) - this->Breakaway8;
  if (!(w > 0.0))
  {
    return { 1.0, 0.0 };
  }
  // α|z| (cos θ, sin θ) cos θ
  const double plastic = std::sqrt(share) * w / (w + this->Width8) * z.x() / squared;
  return { 1.0 - plastic * z.x(), -plastic * z.y() };
}

Vector2 ElastoPlasticFriction::rungeKutta(
  const Vector2& z, double longest, double length) const noexcept
{
  const Vector2 k1 = this->rate(z, longest);
  const Vector2 k2 = this->rate(z + 0.5 * length * k1, longest);
  const Vector2 k3 = this->rate(z + 0.5 * length * k2, longest);
  const Vector2 k4 = this->rate(z + length * k3, longest);
  return z + length / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
}

namespace
{
constexpr double NearlyAll = 1.0 - 1e-9;
}

ShapeFriction::ShapeFriction(const FrictionSettings& settings) noexcept
  : Coefficient(settings.coefficient)
  , Compliance((2.0 - settings.poissonRatio) / (2.0 * (1.0 - settings.poissonRatio)))
{
  this->Stiffness.fill(0.0);
  this->Displacement.fill(Vector2::Zero());
}

void ShapeFriction::reset() noexcept
{
  this->Count = 0;
}

TangentialForce ShapeFriction::move(
  const Vector2& displacement, const Springs& springs, double deflection) noexcept
{
  const StraightStep step(displacement);
  TangentialForce result;
  for (std::size_t j = 0; j < springs.count; ++j)
  {
    const double stiffness = springs.stiffness[j];
    const double limit = this->Coefficient * this->Compliance * (deflection - springs.level[j]);
    Vector2 u = Vector2::Zero();
    if (j < this->Count)
    {
      u = this->Displacement[j];
      if (stiffness > this->Stiffness[j])
      {
        u *= this->Stiffness[j] / stiffness;
      }
      StraightStep::clip(u, limit);
    }
    if (step.length() > 0.0 && limit > 0.0)
    {
      u = step.toPath(u);
      const double left = StraightStep::moveFreely(u, limit, step.length());
      if (left > 0.0)
      {
        StraightStep::drag(u, limit, left);
      }
      u = step.fromPath(u);
    }
    const double nearly = NearlyAll * limit;
    result.sliding = result.sliding && (stiffness == 0.0 || u.squaredNorm() >= nearly * nearly);
    this->Stiffness[j] = stiffness;
    this->Displacement[j] = u;
    result.force -= stiffness * u;
  }
  this->Count = springs.count;
  result.force /= this->Compliance;
  return result;
}
} // namespace palpate
