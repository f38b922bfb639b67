// SPDX-License-Identifier: BSD-3-Clause
// The force of a ToolContact: normal force, torque, friction, energy.
#include "Contact/ToolContact.h"

#include "Contact/CappedResponse.h"
#include "Contact/EnergyGradient.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// 1/√x. The square of a sum of nearly parallel normals is near 1. There the series is exact to
/// rounding and saves a tick the latency of a root and a division.
double inverseRoot(double x) noexcept
{
  constexpr double little = 0.01; // its eighth power, times 0.2, is 2e-17
  const double e = 1.0 - x;
  if (!(std::abs(e) < little))
  {
    return 1.0 / std::sqrt(x);
  }
  // Pairs of terms that are independent of each other.
  const double e2 = e * e;
  const double low = (1.0 + 1.0 / 2 * e) + e2 * (3.0 / 8 + 5.0 / 16 * e);
  const double high = (35.0 / 128 + 63.0 / 256 * e) + e2 * (231.0 / 1024 + 429.0 / 2048 * e);
  return low + e2 * e2 * high;
}

/// A force without its part against `out` (which need not have unit length). On a thin fin the
/// normals of the vertices can point into the body; so can the normal of a face beyond its border.
Vector3 outwardPart(const Vector3& force, const Vector3& out) noexcept
{
  const double along = force.dot(out);
  return along < 0.0 ? Vector3(force - along / out.squaredNorm() * out) : force;
}

/// A direction without its part against `out`; `out` if nothing remains.
Vector3 outward(const Vector3& direction, const Vector3& out) noexcept
{
  constexpr double rounding = 1e-12; // of the squared length
  const Vector3 part = outwardPart(direction, out);
  const bool isAgainst =
    direction.dot(out) < 0.0 && !(part.squaredNorm() > rounding * direction.squaredNorm());
  return isAgainst ? out.normalized() : part;
}
} // namespace

ResponseValue ToolContact::slowResponse(const Pressed& pressed, double depth) const noexcept
{
  const TriangleCorners& corners = this->Body.surface.corners(pressed.place.triangle);
  const Vector3& weights = pressed.place.projection.weights;
  const BlendedResponse response(this->Body.response, corners, weights);
  const ResponseValue upright = response.evaluate(depth);
  ResponseValue value = this->Tilt.isTilted() && depth > 0.0
    ? this->Tilt.tilted(corners, weights, depth, upright, response.energy(depth))
    : upright;
  value.force *= pressed.share;
  value.stiffness *= pressed.share;
  return value;
}

Eigen::Matrix3d ToolContact::weightGradients(const ContactPlace& place) const noexcept
{
  return this->Tilt.isFelt() ? this->Tilt.ofTip(place.weightGradients,
                                 this->Body.surface.corners(place.triangle), this->Body.response)
                             : place.weightGradients;
}

Vector3 ToolContact::vectorToContact(const ContactPlace& place) const noexcept
{
  constexpr double rounding = 1e-9; // mm; the direction of a shorter vector is uncertain
  const Vector3 way = place.projection.point - this->LastTip;
  return way.squaredNorm() > rounding * rounding ? way
                                                 : this->Body.surface.areaNormal(place.triangle);
}

[[gnu::hot]] bool ToolContact::blend(
  const ContactPlace& place, const BlendedResponse& response, Contact& result) noexcept
{
  this->LastCorners = this->Body.surface.corners(place.triangle);
  this->LastWeights = place.projection.weights;
  result.triangle = this->Body.surface.inputTriangle(place.triangle);
  result.contactPoint = place.projection.point;
  result.deflection = -place.signedDistance;
  const ResponseValue upright = response.evaluate(result.deflection);
  ResponseValue value = upright;
  if (this->Tilt.isTilted())
  {
    value = this->Tilt.press(this->LastCorners, this->LastWeights, result.deflection, upright,
      response.energy(result.deflection));
  }
  result.normalForce = value.force;
  result.stiffness = value.stiffness;
  result.state = value.beyondRange ? ContactState::BeyondRange : ContactState::Slide;
  if (this->IsInTime)
  {
    this->relax(place, response, value, result);
  }
  const Vector3 out = this->vectorToContact(place);
  if (this->Settings.form == ForceForm::EnergyConsistent)
  {
    const bool isAgainst = place.onBorder && place.normal.dot(out) < 0.0;
    result.normal = isAgainst ? outward(place.normal, out).normalized() : place.normal;
    result.force = EnergyGradient::force(result.normalForce, result.normal,
      this->weightGradients(place), this->energies(response, result.deflection));
    return result.force.allFinite();
  }
  Vector3 direction = place.normal; // the normal of a smooth surface differs from that of the facet
  if (!place.isSmooth)
  {
    direction = this->sumOfNormals(place, Vector3::Ones());
  }
  direction = outward(direction, out);
  if (this->Settings.form == ForceForm::Paper)
  {
    const std::array<ResponseValue, 3> each = response.evaluateEach(result.deflection);
    const Vector3 forces(each[0].force, each[1].force, each[2].force);
    const Vector3 sum = outwardPart(this->sumOfNormals(place, forces), out);
    const double more = upright.force > 0.0 ? result.normalForce / upright.force : 1.0;
    result.normalForce = more * sum.norm();
    direction = result.normalForce > 0.0 ? sum : direction;
  }
  const double squared = direction.squaredNorm();
  result.normal = inverseRoot(squared) * direction;
  result.force = result.normalForce * result.normal;
  return squared > 0.0 && result.force.allFinite(); // then `squared` is finite, too
}

void ToolContact::relax(const ContactPlace& place, const BlendedResponse& response,
  const ResponseValue& slow, Contact& result) noexcept
{
  // The material under a tilted tool has moved as under an upright tool with the same force.
  ContactTilt::Alike upright;
  upright.depth = result.deflection;
  upright.value = slow;
  if (this->Tilt.isTilted())
  {
    upright = this->Tilt.alike(response);
  }
  const ContactRelaxation::Force felt = this->Relaxation.press(
    { this->LastCorners, this->LastWeights, place.projection.point, upright.depth }, upright.value);
  result.normalForce = felt.total;
  result.memory = felt.total - slow.force;
  result.stiffness = felt.stiffness * upright.stiffening;
  result.state = felt.isTouched ? result.state : ContactState::None;
}

Vector3 ToolContact::energies(const BlendedResponse& response, double deflection) const noexcept
{
  Vector3 energies = response.energies(deflection);
  if (this->Tilt.isTilted())
  {
    energies = this->Tilt.energies(this->LastCorners, energies);
  }
  if (this->IsInTime)
  {
    // The energy stored by the memory force is divided among the corners in proportion to their
    // slow work: the curves of one tool on bodies of different stiffness have the same shape.
    const double work = energies.isZero(0.0) ? 0.0 : this->work(response, deflection);
    energies *= work > 0.0 ? 1.0 + this->Relaxation.storedEnergy() / work : 1.0;
    energies += this->Relaxation.strengthEnergies();
  }
  return energies;
}

[[gnu::hot]] double ToolContact::cappedShare(
  const Contact& contact, double maximumStiffness) const noexcept
{
  const BlendedResponse response = this->response();
  double depth = contact.deflection;
  double cap = maximumStiffness;
  if (this->Tilt.isTilted() && contact.normalForce > 0.0)
  {
    const ContactTilt::Alike upright = this->Tilt.alike(response);
    depth = upright.depth;
    cap /= std::max(upright.stiffening, 1e-9);
  }
  if (!this->IsInTime)
  {
    return CappedResponse(response, cap).share(depth);
  }
  const double slowCap = cap / this->Relaxation.stiffening();
  const double whole = contact.normalForce;
  const double capped =
    this->Relaxation.cappedForce(CappedResponse(response, slowCap).evaluate(depth).force, slowCap);
  return std::min(1.0, whole > 0.0 ? capped / this->Relaxation.force() : 1.0);
}

[[gnu::hot]] Vector3 ToolContact::sumOfNormals(
  const ContactPlace& place, const Vector3& factors) const noexcept
{
  const TriangleCorners& corners = this->Body.surface.corners(place.triangle);
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto i = static_cast<Eigen::Index>(k);
    sum += place.projection.weights[i] * factors[i] * this->Body.response.normal(corners[k]);
  }
  return sum;
}

[[gnu::hot]] void ToolContact::complete(const ContactPlace& place, const BlendedResponse& response,
  double share, Contact& result) noexcept
{
  if (this->Tilt.isTilted())
  {
    this->addTorque(place, share, result);
  }
  this->addFriction(response, result);
  if (this->Tilt.isFelt() && this->Tilt.isTooFar() && result.state != ContactState::BeyondRange)
  {
    result.state = ContactState::TiltedTooFar;
  }
}

void ToolContact::keepOutward(const ContactPlace& place, Contact& result) const noexcept
{
  const Vector3 kept = outwardPart(result.force, this->vectorToContact(place));
  if (kept == result.force)
  {
    return;
  }
  result.force = kept;
  result.normalForce = kept.norm();
  result.normal = result.normalForce > 0.0 ? Vector3(kept / result.normalForce) : result.normal;
}

void ToolContact::addTorque(const ContactPlace& place, double share, Contact& result) const noexcept
{
  const double slow = result.normalForce - result.memory;
  const double memory = slow > 0.0 ? result.normalForce / slow : 1.0;
  const double moment = this->Tilt.moment(result.normalForce, share * memory);
  result.tilt = this->Tilt.angle();
  result.torque = this->Tilt.torque(moment);
  // If the force form has an energy, the force includes the change of the tilt along the surface.
  if (this->Settings.form == ForceForm::EnergyConsistent ||
    (this->Settings.form == ForceForm::NormalizedDirection && place.isSmooth))
  {
    result.force += this->Tilt.forceBeside(
      moment, this->LastCorners, this->weightGradients(place), this->Body.response);
  }
}

[[gnu::hot]] void ToolContact::addFriction(
  const BlendedResponse& response, Contact& result) noexcept
{
  if (this->IsInTime)
  {
    result.friction = this->Relaxation.slide(result.contactPoint, result.normal);
    result.force += result.friction;
  }
  if (!(this->Settings.friction.coefficient > 0.0))
  {
    return;
  }
  const Friction::Result friction = this->Resistance.update(
    result.contactPoint, result.normal, result.normalForce, result.deflection, response);
  result.friction = this->IsInTime ? result.friction + friction.force : friction.force; // keeps -0
  result.force += friction.force;
  if (!friction.sliding && result.state == ContactState::Slide)
  {
    result.state = ContactState::Stick;
  }
}
} // namespace palpate
